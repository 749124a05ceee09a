// Close-ups: a part of a picture, drawn larger.
#pragma once
#include "scene/camera.hpp"

namespace texmap {

/// The view with a picture `times` as large, in the same number of pixels.
///
/// @param fixed  the place that stays where it is
/// The ray through `fixed` + d is that of the whole picture through `fixed` + d / times.
[[nodiscard]] inline View<> close_up(const View<>& whole, double times,
                                     const PixelPlace<double>& fixed) {
  View<> view = whole;
  view.pixel = whole.pixel / times;
  view.center_column = fixed.column + times * (whole.center_column - fixed.column);
  view.center_row = fixed.row + times * (whole.center_row - fixed.row);
  return view;
}

}  // namespace texmap
