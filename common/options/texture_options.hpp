// The options that chapters with a picture on the globe share.
#pragma once
#include <array>
#include <cstdio>
#include <string>

#include "command_line.hpp"
#include "conventions.hpp"
#include "find_texture.hpp"
#include "load_image.hpp"
#include "studio.hpp"

namespace texmap {

/// A texture that the user can replace by a picture of their own.
struct TextureFile {
  std::string name;   ///< a path, or the name of a file in assets/

  void declare(CommandLine& line) {
    line.text("--texture", "FILE", name, "the picture on the globe, a PNG or JPEG twice as wide as high");
  }
  /// Errors: ImageError naming the file, and where it was looked for. A missing texture is never replaced by a color.
  [[nodiscard]] Image load() const { return load_image(find_texture(name)); }
};

/// How a picture is laid on the globe, as the user chooses.
struct LayoutOptions {
  Convention convention = Convention::rtiow;
  TexelRounding rounding = TexelRounding::floor;

  void declare(CommandLine& line) {
    line.choice<Convention>("--convention", convention,
                            {{"daily", Convention::daily}, {"rtiow", Convention::rtiow}, {"lecture", Convention::lecture}},
                            "where the picture begins and which way it runs");
    line.choice<TexelRounding>("--rounding", rounding, {{"floor", TexelRounding::floor}, {"lecture", TexelRounding::lecture}},
                               "from a coordinate to a texel: floor(u n), or the lecture's (n-1) u cut off");
  }
  /// The picture as a texture for this layout.
  [[nodiscard]] ImageTexture lay_out(const TextureFile& file) const { return {file.load(), v_axis_of(convention), rounding}; }
};

/// How far the globe is turned about its axis, as the user chooses.
struct RotationOptions {
  double degrees = 90;
  int frames = 0;   ///< of a turntable, 0 for a single picture

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
  for (int frame = 0; frame < turn.frames; ++frame) {
    rotation = rotation_y(turn.degrees + 360.0 * frame / turn.frames);
    studio.save(studio.draw(lesson), numbered(frame));
  }
}

}  // namespace texmap
