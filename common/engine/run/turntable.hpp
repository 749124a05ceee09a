// The options --degrees and --turntable.
#pragma once
#include <string>

#include "math/rotation.hpp"

namespace texmap {

struct Offer;

/// By which angle the look-up on the globe is turned, once or in several pictures of a full turn.
struct Turntable {
  double degrees = 90;
  int frames = 0;  ///< of a full turn; 0 for a single picture
  int frame = 0;   ///< the one that is drawn

  void declare(Offer& offer);
  /// The rotation of the frame, computed from the first angle, so that errors do not add up.
  [[nodiscard]] RotationY rotation() const;
};

/// The ending of a frame's name: _007 for 7.
[[nodiscard]] std::string frame_suffix(int frame);

}  // namespace texmap
