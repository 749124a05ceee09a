// The options --convention and --rounding.
#pragma once
#include "command_line.hpp"
#include "conventions.hpp"
#include "texture_file.hpp"

namespace texmap {

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

}  // namespace texmap
