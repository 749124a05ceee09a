// The options --convention and --rounding.
#include "engine/app/layout_options.hpp"

#include "engine/app/command_line.hpp"

namespace texmap {

void LayoutOptions::declare(CommandLine& line) {
  line.choice<Convention>("--convention", convention,
                          {{"daily", Convention::daily},
                           {"rtiow", Convention::rtiow},
                           {"lecture", Convention::lecture}},
                          "where on the globe the picture begins, and which way it runs");
  line.choice<TexelRounding>(
      "--rounding", rounding,
      {{"floor", TexelRounding::floor}, {"lecture", TexelRounding::lecture}},
      "which texel has the coordinate u: number floor(u n), or the lecture's (n-1) u, cut off");
}

ImageTexture LayoutOptions::load(const TextureFile& file) const {
  return {file.load(), v_axis_of(convention), rounding};
}

}  // namespace texmap
