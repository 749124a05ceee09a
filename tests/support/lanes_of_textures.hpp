// Textures on packs.
#pragma once
#include <doctest.h>

#include "color.hpp"
#include "pack.hpp"
#include "uv.hpp"

#ifdef TEXMAP_HAVE_PACKS
namespace texmap::test {

/// Checks that each lane of a pack sees what a plain number sees there: 200 packs of places in and around the picture.
template <class T, class Texture>
void check_each_lane(const Texture& texture) {
  for (int start = 0; start < 200; ++start) {
    const auto places = [start](int step, int between, int count) {
      return from_lanes<Pack<T>>([=](std::size_t lane) {
        return static_cast<T>((start * step + static_cast<int>(lane) * between) % (count + 20) - 10) / static_cast<T>(count);
      });
    };
    const Uv<Pack<T>> uv{places(7, 31, 211), places(13, 5, 196)};
    const Color<Pack<T>> colors = texture(uv);
    for (std::size_t i = 0; i < lanes<Pack<T>>; ++i) {
      CAPTURE(lane(uv.u, i));
      CAPTURE(lane(uv.v, i));
      const Color<T> color = texture(Uv<T>{lane(uv.u, i), lane(uv.v, i)});
      REQUIRE(lane(colors.r, i) == color.r);
      REQUIRE(lane(colors.g, i) == color.g);
      REQUIRE(lane(colors.b, i) == color.b);
    }
  }
}

}  // namespace texmap::test
#endif
