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
