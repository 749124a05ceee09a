// The lesson of this chapter: what breaks at the limits of a number, and the formulas that hold.
#pragma once
#include <string>
#include <tuple>

#include "exhibits.hpp"
#include "sheet.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_14 {

struct Lesson {
  static constexpr const char* idea = "what breaks at the limits of a number, and the formulas that hold";

  static constexpr bool single_numbers = true;  // the seeds' formulas branch, and packs cannot

  TextureFile texture{"earth.png"};
  TextureFile label{"uv_map.png"};

  std::string exhibit;
  Care care = Care::robust;

  void options(CommandLine& line) {
    texture.declare(line);
    line.text("--exhibit", "NAME", exhibit, "one exhibit alone, such as pole; the sheet's table has their names");
    line.choice<Care>("--formulas", care, {{"seeds", Care::plain}, {"robust", Care::robust}},
                      "whose formulas draw the exhibit");
  }

  /// All exhibits, in the order of the sheet.
  [[nodiscard]] auto exhibits() const {
    const ImageTexture earth{texture.load()};
    const ImageTexture map{label.load()};
    const Sphere globe{{0, 0, 0}, 1};
    const auto from = [&](const char* name, const char* caption, double radii) {
      return Globe<ImageTexture>{name, caption, towards_origin({0, 0, radii}, 1.15), globe, earth};
    };
    const Camera above_the_pole{.eye = {0, 1.1, 0.01}, .target = {0, 1, 0}, .fov_y_degrees = 1.5};
    const Camera at_the_seam = towards_origin({-3, 0, 0}, 3e-7);
    const Camera far_from_home{.eye = {100000, 0, 5}, .target = {100000, 0, 0}, .fov_y_degrees = 26};
    return std::tuple{
        from("from-10", "a globe from 10 radii", 10),
        from("from-1e3", "a globe from 1,000 radii", 1e3),
        from("from-1e5", "a globe from 100,000 radii", 1e5),
        from("from-1e7", "a globe from 10,000,000 radii", 1e7),
        Globe<Graticule>{"pole", "the pole, rings of 1/4 texel", above_the_pole, globe, {}},
        Globe<Graticule>{"seam", "the seam, 1e-7 wide", at_the_seam, globe, {.sectors = 2, .rings = 1}},
        Globe<ImageTexture>{"far-home", "a globe at 100,000 radii from 0", far_from_home, {{100000, 0, 0}, 1}, earth},
        Globe<ImageTexture>{
            "units", "a globe of radius 1e-25", towards_origin({0, 0, 1e-24}, 1.15e-25), {{0, 0, 0}, 1e-25}, earth},
        Shadows{"acne", "shadows, ground of radius 100,000", 1, 1e5},
        Shadows{"small", "shadows, the stage 1e-4 as large", 1e-4},
        Needle{.texture = map},
        FarFloor{},
        ManyTurns{.texture = earth},
        OddExponent{},
    };
  }

  void show(Studio& studio) const {
    if (exhibit.empty()) return show_exhibits(exhibits(), studio);
    show_exhibit(exhibits(), exhibit, care, studio);
  }
};

}  // namespace texmap::chapter_14
