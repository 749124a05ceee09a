// The options --filter, --wrap, --taps, --floor and --plot.
#pragma once
#include <string>

#include "engine/app/lesson.hpp"
#include "engine/app/texture_file.hpp"
#include "texture/encoded.hpp"
#include "texture/filters.hpp"

namespace texmap {

/// How the user wants textures to be read.
struct FilterOptions {
  Filter filter = Filter::anisotropic;
  Wrap wrap = Wrap::repeat;  ///< of the floor; the globe's is spherical
  int taps = 16;
  std::string floor_file = "checkers";
  std::string plot;  ///< the file for the plot of errors; empty: none

  void declare(CommandLine& line);
  /// True for filters that use the footprints of pixels.
  [[nodiscard]] bool needs_footprints() const {
    return filter != Filter::nearest && filter != Filter::bilinear;
  }
  /// Chooses another filter, here and for a texture.
  void apply(Filter other, int most_taps, FilteredTexture& texture) {
    texture.filter = filter = other;
    texture.taps = taps = most_taps;
  }
  /// The floor's picture as a texture.
  [[nodiscard]] FilteredTexture load_floor() const;
  /// The globe's.
  [[nodiscard]] FilteredTexture load_globe(const TextureFile& file) const;
};

/// The base of a lesson that filters: its picture shows the mean light of its pixels.
struct FilteredLesson : LessonHooks {
  FilterOptions filtering;

  /// True if rays bring their derivatives by the pixel's column and row.
  [[nodiscard]] bool needs_footprints() const { return filtering.needs_footprints(); }
  /// Mean light as a color; bytes are cut off, so half of one is added.
  template <class Real>
  [[nodiscard]] Color<Real> shown(const Color<Real>& light) const {
    return encoded(light) + gray(Real(0.5 / 255));
  }
};

/// Lets all textures of a lesson be read by a filter.
template <class Lesson>
void read_by(Lesson& lesson, Filter filter, int taps) {
  lesson.filtering.apply(filter, taps, lesson.ground.texture);
  for (auto& object : lesson.objects) lesson.filtering.apply(filter, taps, object.paint.texture);
}

/// A checkerboard of black and white squares as a picture.
[[nodiscard]] Image checkers_image(int size, int squares);

}  // namespace texmap
