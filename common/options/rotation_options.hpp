// The options --degrees and --turntable.
#pragma once
#include <array>
#include <cstdio>
#include <string>

#include "rotation.hpp"
#include "save_png.hpp"
#include "studio.hpp"

namespace texmap {

/// How far the globe is turned about its axis, as the user chooses.
struct RotationOptions {
  double degrees = 90;
  int frames = 0;  ///< of a turntable, 0 for a single picture

  void declare(CommandLine& line) {
    line.decimal("--degrees", degrees, -1e300, 1e300, "turn of the globe about its axis, any angle");
    line.whole("--turntable", frames, 0, 9999, "draw a full turn in N pictures instead, numbered _000, _001, ...");
  }
};

/// The ending of a frame's name: _007 for 7.
[[nodiscard]] inline std::string numbered(int frame) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "_%03d", frame);
  return text.data();
}

/// Draws and saves a full turn of the globe, one numbered picture after another.
///
/// @param rotation  the globe's, inside `lesson`; each picture sets it anew from the first angle, so that no error adds up
template <class Lesson>
void save_turntable(Studio& studio, const Lesson& lesson, const RotationOptions& turn, RotationY& rotation) {
  for (int frame = 0; frame < turn.frames; ++frame) check_output(studio.file_name(numbered(frame)));
  for (int frame = 0; frame < turn.frames; ++frame) {
    rotation = rotation_y(turn.degrees + 360.0 * frame / turn.frames);
    studio.save(studio.draw(lesson), numbered(frame));
  }
}

}  // namespace texmap
