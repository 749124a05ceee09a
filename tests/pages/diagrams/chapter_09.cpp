// The diagrams of chapter 09 show what its formulas say.
#include <doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "pages/diagrams/named.hpp"

using namespace texmap::diagrams;

namespace {

/// The four corners of an area in a drawing.
std::array<Spot, 4> corners(const Drawing& d, const std::string& name) {
  return {d.marked(name + " 0"), d.marked(name + " 1"), d.marked(name + " 2"),
          d.marked(name + " 3")};
}

/// Mean squares of x and y and the mean of x y, from points of a parallelogram's inside.
std::array<double, 3> spread(const std::array<Spot, 4>& at) {
  const Spot center = (at[0] + at[2]) * 0.5;
  constexpr int parts = 200;
  std::array<double, 3> sums{};
  for (int i = 0; i < parts; ++i) {
    for (int k = 0; k < parts; ++k) {
      const double s = (i + 0.5) / parts, t = (k + 0.5) / parts;
      const Spot p = at[0] + (at[1] - at[0]) * s + (at[3] - at[0]) * t - center;
      sums = {sums[0] + p.x * p.x, sums[1] + p.y * p.y, sums[2] + p.x * p.y};
    }
  }
  for (double& sum : sums) sum /= parts * parts;
  return sums;
}

}  // namespace

TEST_CASE("the rectangle has the spread of the parallelogram, and right angles") {
  const Drawing d = named("pixel_footprint");
  const auto box = corners(d, "rectangle");
  const auto of_box = spread(box), of_sides = spread(corners(d, "parallelogram"));
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(of_box.at(i) == doctest::Approx(of_sides.at(i)).epsilon(1e-6));
  const Spot one = box[1] - box[0], other = box[3] - box[0];
  CHECK(std::abs(one.x * other.x + one.y * other.y) < 1e-6);
  CHECK(distance(d.marked("parallelogram 0"), box[0]) > 2);  // they are not the same

  // The ellipse ends at the root of 2/3 of the longer side: 0.816 sides from the middle.
  const double longer = std::max(std::hypot(one.x, one.y), std::hypot(other.x, other.y));
  CHECK(distance(d.marked("end of the ellipse"), d.marked("center")) ==
        doctest::Approx(0.8165 * longer).epsilon(1e-4));
}

TEST_CASE("eye, corner of the pixel and corner of the footprint are on one line") {
  const Drawing d = named("pixel_footprint");
  const Spot eye = d.marked("eye");
  const auto pixel = corners(d, "pixel"), covered = corners(d, "floor");
  for (std::size_t i = 0; i < 4; ++i) {
    const Spot a = pixel.at(i) - eye, b = covered.at(i) - eye;
    CHECK(std::abs(a.x * b.y - a.y * b.x) < 1e-6 * std::hypot(b.x, b.y) * std::hypot(a.x, a.y));
    CHECK(b.x > a.x);
  }
}

TEST_CASE("the levels hold the means of a picture with 18 filled texels of 64") {
  const Drawing d = named("mip_pyramid");
  CHECK_NOTHROW(static_cast<void>(d.marked("mean 3 0 0 is 0.28")));  // 18 / 64
  CHECK_NOTHROW(static_cast<void>(d.marked("mean 2 0 0 is 0.44")));  // 7 / 16
  CHECK_NOTHROW(static_cast<void>(d.marked("mean 2 1 1 is 0.31")));  // 5 / 16
  CHECK_NOTHROW(static_cast<void>(d.marked("mean 1 0 0 is 0.25")));
}

TEST_CASE("a read 3 texels wide lies where a mix of the squares 4 and 16 is 9") {
  const Drawing d = named("level_of_width");
  const double step = d.marked("level 1").x - d.marked("level 0").x;
  const double fraction = (d.marked("width 3").x - d.marked("level 1").x) / step;
  CHECK((1 - fraction) * 4 + fraction * 16 == doctest::Approx(9));
}

TEST_CASE("the six reads divide the longer side of the footprint into six equal parts") {
  const Drawing d = named("square_or_row");
  const Spot from = d.marked("one end"), to = d.marked("other end");
  for (int i = 0; i < 6; ++i) {
    const Spot expected = from + (to - from) * ((i + 0.5) / 6);
    CHECK(distance(d.marked("read " + std::to_string(i)), expected) < 1e-6);
  }
  CHECK_THROWS(static_cast<void>(d.marked("read 6")));
}

TEST_CASE("slopes are one tenth a pixel everywhere, differences are not at the seam") {
  const Drawing d = named("slope_at_seam");
  const auto dot = [&](int i) { return d.marked("dot " + std::to_string(i)); };
  for (int i = 0; i < 8; ++i) {
    const Spot slope = d.marked("slope " + std::to_string(i));
    CHECK(slope.y / slope.x == doctest::Approx(-19.0 / 60));
    if (i != 3 && i != 7) CHECK((dot(i + 1) - dot(i)).y == doctest::Approx(-19));
  }
  CHECK((dot(4) - dot(3)).y == doctest::Approx(0.9 * 190));
}
