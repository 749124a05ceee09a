// The figures of chapter 06's page.
#include <algorithm>
#include <stdexcept>

#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "engine/picture/load_image.hpp"
#include "figures.hpp"
#include "support/lecture_highlight.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

namespace texmap::test {
namespace {

using chapter_06::Lesson;

std::string color(Rgb8 pixel) {
  return std::to_string(pixel.r) + ", " + std::to_string(pixel.g) + ", " + std::to_string(pixel.b);
}

/// The lecture's scene with Blinn's highlight: n . h to a power, h halfway between lamp and eye.
struct Halfway : Lesson {
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const auto& object, const Hit<Real>& hit) {
      const LightSample<Real> light = sample_light(stage.light, phong.casters(objects), hit);
      const Real cosine = dot(hit.normal, normalize(light.to_light - ray.direction));
      const auto shininess = static_cast<Scalar<Real>>(object.material.shininess);
      const Real specular =
          select(light.cosine > Real(0),
                 Real(object.material.specular) * power(max(cosine, Real(0)), shininess), Real(0));
      const Real sum = lambert(object.material.lambertian, light) + specular;
      if (&object != &objects[chapter_06::middle]) return gray(Real(0));
      return mix(gray(clamp(sum, Real(0), Real(1))), object.paint(hit), Real(phong.blend));
    });
  }
};

/// On how many pixels of the lecture's globe Phong's and Blinn's highlights show.
void spot_figures(Figures& figures) {
  const auto drawn = [](const auto& lesson) { return picture(lesson, 800, 400); };
  const auto without = drawn(prepared<Halfway>({"--scene", "lecture", "--shininess", "1e30"}));
  const auto spot = [&](const Image& image) {
    long count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const bool ground = without.pixels[i] == Rgb8{0, 0, 0};
      count += !ground && image.pixels[i] != without.pixels[i] ? 1 : 0;
    }
    return whole(count);
  };
  figures.emplace_back("06.spot_of_phong", spot(drawn(prepared<Lesson>({"--scene", "lecture"}))));
  for (const std::string shininess : {"500", "1500", "2000"}) {
    figures.emplace_back(
        "06.spot_of_blinn_" + shininess,
        spot(drawn(prepared<Halfway>({"--scene", "lecture", "--shininess", shininess}))));
  }
}

/// How many pixels the slides' formula brightens in the dark, without a texture.
void lecture_figures(Figures& figures) {
  figures.emplace_back("06.pixels_in_the_dark", whole(brightened_pixels().in_the_dark));
}

}  // namespace

void figures_of_06(Figures& figures) {
  // The stage, with and without the highlight.
  const auto globe = prepared<Lesson>();
  const auto plain = prepared<chapter_05::Lesson>({"--degrees", "20"});
  const Image before = picture(plain);
  const Image after = picture(globe);
  std::size_t brightest = 0;
  int most = 0;
  for (std::size_t i = 0; i < after.pixels.size(); ++i) {
    const int change = levels_apart(before.pixels[i], after.pixels[i]);
    if (change > most) brightest = i;
    most = std::max(most, change);
  }
  const int column = static_cast<int>(brightest) % after.width;
  const int row = static_cast<int>(brightest) / after.width;
  figures.emplace_back("06.highlight", std::to_string(column) + ", " + std::to_string(row));
  figures.emplace_back("06.highlight_before", color(before.at(column, row)));
  figures.emplace_back("06.highlight_after", color(after.at(column, row)));
  const auto spot = [&](const char* shininess) {
    return count_different(picture(prepared<Lesson>({"--shininess", shininess})), before);
  };
  const auto wide = spot("50");
  const auto narrow = spot("500");
  figures.emplace_back("06.pixels_at_50", whole(static_cast<long long>(wide)));
  figures.emplace_back("06.pixels_at_500", whole(static_cast<long long>(narrow)));
  figures.emplace_back("06.spot_factor",
                       decimals(static_cast<double>(wide) / static_cast<double>(narrow), 1));

  // The side that the lamp does not reach.
  const Image texture = picture(prepared<Lesson>({"--blend", "1"}));
  const Image half = picture(prepared<Lesson>({"--blend", "0.5"}));
  figures.emplace_back("06.dark_texture", color(texture.at(346, 320)));
  figures.emplace_back("06.dark_multiplied", color(after.at(346, 320)));
  figures.emplace_back("06.dark_blended", color(half.at(346, 320)));

  lecture_figures(figures);
  spot_figures(figures);

  const TemporaryFolder folder;
  const std::string file = folder / "one.png";
  const Outcome outcome = run("\"" TEXMAP_BIN_DIR "/06_one_file\" --texture \"" TEXMAP_ASSETS_DIR
                              "/earth.png\" --out \"" +
                              file + "\"");
  if (outcome.status != 0) throw std::runtime_error("06_one_file: " + outcome.err);
  const Image expected = picture(prepared<Lesson>({"--scene", "lecture"}), 800, 400);
  figures.emplace_back("06.one_file_other", whole(count_different(load_image(file), expected)));
}

}  // namespace texmap::test
