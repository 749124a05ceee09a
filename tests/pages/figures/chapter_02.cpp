// The figures of chapter 02's page.
#include <algorithm>
#include <cmath>

#include "02_checkerboard_uv/lesson.hpp"
#include "figures.hpp"
#include "published/uv.hpp"
#include "support/daily_program.hpp"
#include "support/pictures.hpp"

namespace texmap::test {
namespace {

using chapter_02::Lesson;

constexpr double earth_in_metres = 6371000;

std::string uv_at(const Vec3d& p) {
  const Uv<double> uv = uv_rtiow(p);
  return digits(uv.u, 4) + ", " + digits(uv.v, 4);
}

std::string color(Rgb8 pixel) {
  return std::to_string(pixel.r) + ", " + std::to_string(pixel.g) + ", " + std::to_string(pixel.b);
}

std::string means(const Mean& mean) {
  return decimals(mean.r, 2) + ", " + decimals(mean.g, 2) + ", " + decimals(mean.b, 2);
}

/// Metres on the Earth that v is off at most, in float, within a degree of the north pole.
struct PoleErrors {
  double acos = 0, atan2 = 0;
  long directions = 0;
};

PoleErrors errors_at_the_pole() {
  PoleErrors errors;
  for (int i = 1; i <= 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      const double angle = pi<double>() / 180 * i / 200, around = 2 * pi<double>() * j / 200;
      const Vec3<float> p =
          normalize(number_cast<float>(Vec3d{std::sin(angle) * std::cos(around), std::cos(angle),
                                             std::sin(angle) * std::sin(around)}));
      const long double exact = uv_rtiow(number_cast<long double>(p)).v;
      const auto metres = [&](float v) {
        return static_cast<double>(std::abs(static_cast<long double>(v) - exact)) * pi<double>() *
               earth_in_metres;
      };
      ++errors.directions;
      errors.acos = std::max(errors.acos, metres(published::uv_next_week_v4(p).v));
      errors.atan2 = std::max(errors.atan2, metres(uv_rtiow(p).v));
    }
  }
  return errors;
}

/// The angle nearest to 0 that acos can give, as metres on the Earth.
template <class Real>
double gap() {
  using std::acos;
  return static_cast<double>(acos(below_one<Real>())) * earth_in_metres;
}

/// Question 02.b: nine squares, seen from the side of the seam.
Lesson nine_squares() {
  Lesson lesson;
  lesson.stage.camera.eye = {-8, 2, -3};
  lesson.stage.light.position = {-5, 5, 5};
  lesson.checkered.texture.squares = 9;
  for (auto& object : lesson.objects) {
    if (std::holds_alternative<chapter_02::Checkered>(object.paint))
      object.paint = lesson.checkered;
  }
  return lesson;
}

/// Exercise 02.3: the pattern twice around the sphere.
struct TwiceAround : Lesson {
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return color_along(objects, ray, stage.sky, [&](const auto& object, const Hit<Real>& hit) {
      const LightSample<Real> light = sample_light(stage.light, objects, hit);
      Color<Real> color = object.paint(hit);
      if (std::holds_alternative<chapter_02::Checkered>(object.paint)) {
        const Uv<Real> uv = uv_rtiow(hit.normal);
        color = checkered.texture(Uv<Real>{Real(2) * uv.u, uv.v});
      }
      return color * lambert(surface, light);
    });
  }
};

}  // namespace

void figures_of_02(Figures& figures) {
  figures.emplace_back("02.uv_minus_x", uv_at({-1, 0, 0}));
  figures.emplace_back("02.uv_plus_z", uv_at({0, 0, 1}));
  figures.emplace_back("02.uv_plus_x", uv_at({1, 0, 0}));
  figures.emplace_back("02.uv_minus_z", uv_at({0, 0, -1}));
  figures.emplace_back("02.uv_plus_y", uv_at({0, 1, 0}));
  figures.emplace_back("02.uv_minus_y", uv_at({0, -1, 0}));
  figures.emplace_back("02.uv_p", uv_at({0.64, 0.48, 0.6}));

  const PoleErrors errors = errors_at_the_pole();
  figures.emplace_back("02.directions_at_the_pole", whole(errors.directions));
  figures.emplace_back("02.acos_km", decimals(errors.acos / 1000, 1));
  figures.emplace_back("02.atan2_metres", decimals(errors.atan2, 1));
  figures.emplace_back("02.gap_float_km", decimals(gap<float>() / 1000, 1));
  figures.emplace_back("02.gap_double_cm", decimals(gap<double>() * 100, 1));

  const Image drawn = picture(Lesson{});
  figures.emplace_back("02.other_than_published",
                       whole(count_different(drawn, daily::draw(800, 600, true))));
  figures.emplace_back("02.mean_red", means(mean_of(drawn, 180, 280, 80, 80)));
  figures.emplace_back("02.mean_red_upside_down",
                       means(mean_of(upside_down(drawn), 180, 280, 80, 80)));

  figures.emplace_back("02.twice_around", whole(count_different(picture(TwiceAround{}), drawn)));
  const Image nine = picture(nine_squares());
  figures.emplace_back("02.left_of_the_seam", color(nine.at(405, 290)));
  figures.emplace_back("02.right_of_the_seam", color(nine.at(440, 290)));
}

}  // namespace texmap::test
