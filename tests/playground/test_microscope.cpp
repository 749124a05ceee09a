// The error microscope of the book's cover, without a browser: test_cover.py compares the rest.
#include "tools/book/microscope.hpp"

#include <doctest.h>

#include "14_numerical_extremes/exhibits.hpp"

using namespace texmap;

namespace {

constexpr std::array<double, 5> distances{1, 100, 1995, 1e5, 1e8};
constexpr int size = 400;

/// Ten pixels of the globe, in both halves.
template <class Check>
void at_ten_pixels(const Check& check) {
  for (int i = 0; i < 10; ++i) check(60 + 28 * i, 110 + 67 * i % 180);
}

double apart(float number, const DoublePair& right) {
  return std::abs(static_cast<double>(DoublePair(number) - right));
}

}  // namespace

TEST_CASE("both halves are chapter 14's globe, bit for bit") {
  using chapter_14::Formulas;
  const chapter_14::Globe<ImageTexture> globe{{}, {{}, 1}, {}};
  for (const double radii : distances) {
    const View<> view = microscope::view_from(radii, size);
    at_ten_pixels([&](int column, int row) {
      const auto pixel = microscope::look(radii, size, column, row, 2048, 1024);
      const auto ray = ray_through(view, static_cast<float>(column), static_cast<float>(row));
      for (const bool ours : {false, true}) {
        const auto seen = globe(ray, ours ? Formulas::robust : Formulas::published);
        const auto& steps = ours ? pixel.ours : pixel.published;
        REQUIRE(seen.hit == (steps[4] < infinity<float>()));
        if (!seen.hit) continue;
        CHECK(steps[5] == seen.uv.u);
        if (seen.mapped) CHECK(steps[6] == seen.uv.v);
        // The root of b^2 - a c is what lies between this distance and the foot of the ray.
        if (!ours) {
          const float a = dot(ray.direction, ray.direction), b = -dot(ray.origin, ray.direction);
          CHECK(steps[4] == (b - sqrt(steps[3])) / a);
        }
      }
    });
  }
}

TEST_CASE("true values obey both formulas, and ours keeps six digits of them at any distance") {
  for (const double radii : distances) {
    at_ten_pixels([&](int column, int row) {
      const auto [published, ours, right] = microscope::look(radii, size, column, row, 2048, 1024);
      CHECK(static_cast<double>(right[0] - right[1]) ==
            doctest::Approx(static_cast<double>(right[3])).epsilon(1e-12));
      for (const std::size_t step : {2U, 3U, 5U, 6U}) CHECK(apart(ours[step], right[step]) < 5e-7);
      if (radii >= 1e5) CHECK(apart(published[3], right[3]) > 0.01);
      if (radii == 1) CHECK(apart(published[5], right[5]) < 5e-7);
    });
  }
}

TEST_CASE("a program of another author has the same numbers") {
  struct Measured {
    double away, discriminant, u, right_discriminant, right_u;
  };
  const Point to_eye = normalize(Point{0.55, 0.45, 0.78});
  for (const Measured& one : {Measured{2, 0.789552212, 0.3070586, 0.789551638, 0.3070585},
                              Measured{1e3, 0.75, 0.2608700, 0.777875, 0.2623174},
                              Measured{3e3, 2, 0.2935147, 0.777796, 0.2622401},
                              Measured{1e5, 2048, 0.3461126, 0.780525, 0.2627914}}) {
    const double angle = std::atan(1.06 / one.away);
    const View<> view = view_of({to_eye * one.away, {}, 360 / std::numbers::pi * angle}, 520, 520);
    const auto seen = ray_through(view, 156.0, 208.0);  // in double, then rounded to float
    const Ray<float> ray{number_cast<float>(seen.origin), number_cast<float>(seen.direction)};
    const auto published = microscope::steps_of(ray, SphereForm::plain, 2048, 1024);
    const auto ours = microscope::steps_of(ray, SphereForm::hybrid, 2048, 1024);
    CHECK(published[3] == static_cast<float>(one.discriminant));
    CHECK(std::abs(published[5] - one.u) < 1e-7);
    CHECK(std::abs(ours[3] - one.right_discriminant) < 1e-6);
    CHECK(std::abs(ours[5] - one.right_u) < 1e-7);
  }
}
