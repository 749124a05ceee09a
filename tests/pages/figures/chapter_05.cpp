// The figures of chapter 05's page.
#include <cmath>
#include <string>

#include "03_image_texture/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

/// The usual way: degrees to radians, then sine and cosine.
template <class Real>
RotationY through_radians(Real degrees) {
  const Real radians = degrees * pi<Real>() / Real(180);
  return {.cosine = static_cast<double>(std::cos(radians)),
          .sine = static_cast<double>(std::sin(radians))};
}

Image turned(const RotationY& rotation) {
  auto lesson = prepared<chapter_05::Lesson>();
  std::get<chapter_05::Textured>(lesson.objects[chapter_05::middle].paint).mapping.rotation =
      rotation;
  return picture(lesson);
}

/// How far +z comes to lie from an angle, in texels of a map 8192 wide.
template <class Real>
double texels_off(const Vec3<Real>& turned_z, double degrees) {
  const double angle = static_cast<double>(std::atan2(turned_z.x, turned_z.z));
  return std::abs(std::remainder(angle * 180 / pi<double>() - degrees, 360.0)) / 360 * 8192;
}

/// The same after 10,000 turns in steps of one degree, each of which turns the turned point.
template <class Real>
double texels_off_after_steps() {
  const RotationY step = rotation_y(1);
  Vec3<Real> p{Real(0), Real(0), Real(1)};
  for (int i = 0; i < 360 * 10000; ++i) p = step(p);
  return texels_off(p, 0);
}

}  // namespace

void figures_of_05(Figures& figures) {
  const Image before = picture(prepared<chapter_03::Lesson>());
  const auto differ = [&](const Image& image) { return whole(count_different(before, image)); };
  figures.emplace_back("05.pixels_lecture_at_90",
                       differ(picture(prepared<chapter_05::Lesson>(
                           {"--degrees", "90", "--convention", "lecture"}))));
  const RotationY in_float = through_radians(1e9F);
  figures.emplace_back("05.texels_in_float",
                       decimals(texels_off(in_float(Vec3d{0, 0, 1}), 280), 0));
  figures.emplace_back("05.texels_after_steps", digits(texels_off_after_steps<double>(), 1));
  figures.emplace_back("05.texels_after_steps_in_float",
                       decimals(texels_off_after_steps<float>(), 1));
  figures.emplace_back("05.sine_of_360", digits(through_radians(360.0).sine, 2));
  for (const double turns : {1e9, 1e12, 1e14}) {
    figures.emplace_back("05.pixels_in_radians_1e" + std::to_string(std::lround(std::log10(turns))),
                         differ(turned(through_radians(360 * turns))));
  }
}

}  // namespace texmap::test
