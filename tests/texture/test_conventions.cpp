// Tests of texture/conventions.hpp and rotated.hpp: the source documents' conventions and the steps
// between them.
#include <doctest.h>

#include "number/kinds/pack.hpp"

#include <numbers>
#include "published/uv.hpp"
#include "support/whole_numbers.hpp"
#include "texture/conventions.hpp"
#include "texture/rotated.hpp"

namespace texmap::test {
namespace {

#define NUMBERS float, double, long double, Pack<float>, Pack<double>

/// The difference of two places round the globe: 0 and 1 are one.
double apart(double a, double b) {
  const double off = abs(a - b);
  return std::min(off, 1 - off);
}

/// The i-th of n points spread evenly over the unit sphere.
Point spread(int i, int n) {
  const double y = 1 - (2 * i + 1.0) / n;
  const double around = i * 2.399963229728653;
  const double radius = std::sqrt((1 - y) * (1 + y));
  return {radius * std::cos(around), y, radius * std::sin(around)};
}

TEST_CASE_TEMPLATE("the axes have their exact places in each convention", Real, NUMBERS) {
  struct Place {
    double u, v;
  };
  struct Row {
    Point p;
    Place daily, rtiow, lecture;
  };
  const Row table[] = {
      {{-1, 0, 0}, {0, 0.5}, {0, 0.5}, {0.75, 0.5}},
      {{0, 0, 1}, {0.75, 0.5}, {0.25, 0.5}, {0, 0.5}},
      {{1, 0, 0}, {0.5, 0.5}, {0.5, 0.5}, {0.25, 0.5}},
      {{0, 0, -1}, {0.25, 0.5}, {0.75, 0.5}, {0.5, 0.5}},
      {{0, 1, 0}, {0.5, 0}, {0.5, 1}, {0.25, 1}},
      {{0, -1, 0}, {0.5, 1}, {0.5, 0}, {0.25, 0}},
      {{-1, 0, -0.0}, {0, 0.5}, {0, 0.5}, {0.75, 0.5}},
      {{-0.0, 0, 1}, {0.75, 0.5}, {0.25, 0.5}, {0, 0.5}},
  };
  for (const Row& row : table) {
    CAPTURE(row.p.x);
    CAPTURE(row.p.y);
    CAPTURE(row.p.z);
    const auto check = [&](Convention convention, const Place& place) {
      const Uv<Real> uv = uv_of(convention, number_cast<Real>(row.p));
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        CHECK(lane(uv.u, i) == static_cast<Scalar<Real>>(place.u));
        CHECK(lane(uv.v, i) == static_cast<Scalar<Real>>(place.v));
      }
    };
    check(Convention::daily, row.daily);
    check(Convention::rtiow, row.rtiow);
    check(Convention::lecture, row.lecture);
  }
}

TEST_CASE("in the daily convention v runs down the picture, in the others up") {
  CHECK(v_axis_of(Convention::daily) == VAxis::down);
  CHECK(v_axis_of(Convention::rtiow) == VAxis::up);
  CHECK(v_axis_of(Convention::lecture) == VAxis::up);
}

TEST_CASE_TEMPLATE("the north pole is in the top row of the picture in every convention", Real,
                   float, double, long double) {
  Image image(1, 2, {0, 0, 0});
  image.at(0, 0) = {255, 255, 255};
  for (const Convention convention : {Convention::daily, Convention::rtiow, Convention::lecture}) {
    const ImageTexture texture{image, v_axis_of(convention)};
    CHECK(texture(uv_of(convention, Vec3<Real>{Real(0.1), Real(0.9), Real(0.2)})).g == Real(1));
    CHECK(texture(uv_of(convention, Vec3<Real>{Real(0.1), Real(-0.9), Real(0.2)})).g == Real(0));
  }
}

TEST_CASE("each convention is its document's own formula on 100000 points") {
  double worst_u = 0;
  double worst_v = 0;
  constexpr int points = 100000;
  for (int i = 0; i < points; ++i) {
    const Point p = normalize(spread(i, points));
    const auto compare = [&](const Uv<double>& ours, const Uv<double>& theirs) {
      worst_u = std::max(worst_u, apart(ours.u, theirs.u));
      worst_v = std::max(worst_v, abs(ours.v - theirs.v));
    };
    compare(uv_of(Convention::daily, p), published::uv_daily(p));
    compare(uv_of(Convention::rtiow, p), published::uv_one_weekend_2020(p));
    compare(uv_of(Convention::rtiow, p), published::uv_next_week_v4(p));
    compare(uv_of(Convention::lecture, p), published::uv_lecture(p));
  }
  MESSAGE("worst: u " << worst_u << ", v " << worst_v);
  CHECK(worst_u <= 4e-16);
  CHECK(worst_v <= 2e-14);  // the documents' asin and acos lose digits towards the poles
}

TEST_CASE_TEMPLATE("the conventions are flips and quarter turns of one another, to the last bit",
                   Real, float, double) {
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3<Real> p = number_cast<Real>(spread(i, 20000));
    const Uv<Real> book = uv_of(Convention::rtiow, p);
    const Uv<Real> daily = uv_of(Convention::daily, p);
    const Uv<Real> lecture = uv_of(Convention::lecture, p);
    // In long double these are exact, and one rounding to Real is all that may differ.
    const auto u = static_cast<long double>(book.u);
    const long double flipped = u == 0 ? 0 : 1 - u;
    const long double turned = u < 0.25L ? u + 0.75L : u - 0.25L;
    if (daily.u != std::min(static_cast<Real>(flipped), below_one<Real>())) ++wrong;
    if (daily.v != Real(1) - book.v) ++wrong;
    if (abs(static_cast<long double>(lecture.u) - turned) >
        static_cast<long double>(unit_roundoff<Real>()))
      ++wrong;
    if (lecture.v != book.v) ++wrong;
    const Uv<Real> plain = uv_rtiow(p);
    if (book.u != plain.u || book.v != plain.v) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("places that are sums of powers of two go from convention to convention exactly",
                   Real, NUMBERS) {
  using T = Scalar<Real>;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j <= 16; ++j) {
      const double u = i / 64.0, v = j / 16.0;
      const auto check = [&](Convention convention, double expected_u, double expected_v) {
        const Uv<Real> uv = in_convention(convention, Uv<Real>{Real(u), Real(v)});
        CHECK(lane(uv.u, lanes<Real> - 1) == static_cast<T>(expected_u));
        CHECK(lane(uv.v, lanes<Real> - 1) == static_cast<T>(expected_v));
      };
      check(Convention::rtiow, u, v);
      check(Convention::daily, i == 0 ? 0 : 1 - u, 1 - v);
      check(Convention::lecture, i < 16 ? u + 0.75 : u - 0.25, v);
    }
  }
}

TEST_CASE_TEMPLATE(
    "the zero vector has a place in every convention, and v runs down in one of them", Real, float,
    double, long double) {
  for (const Convention convention : {Convention::daily, Convention::rtiow, Convention::lecture}) {
    const Uv<Real> uv = uv_of(convention, Vec3<Real>{});
    CHECK(uv.u == (convention == Convention::lecture ? Real(0.25) : Real(0.5)));
    CHECK(uv.v == Real(0.5));
    CHECK((v_axis_of(convention) == VAxis::down) == (convention == Convention::daily));
  }
}

TEST_CASE(
    "a quarter turn moves every texel center by a quarter of the picture, in every convention") {
  constexpr int n = 8192;
  constexpr int rows = 4;
  const Convention conventions[] = {Convention::daily, Convention::rtiow, Convention::lecture};
  for (const Convention convention : conventions) {
    // Daily's u runs west, so there a rotation takes away what it adds elsewhere.
    const int direction = convention == Convention::daily ? -1 : 1;
    for (int quarter = -1; quarter <= 4; ++quarter) {
      const Rotated<ConventionMapping> turned{rotation_y(90.0 * quarter), {convention}};
      int wrong = 0;
      for (int column = 0; column < n; ++column) {
        for (int row = 0; row < rows; ++row) {
          const double longitude = 2 * std::numbers::pi * (column + 0.5) / n;
          const double latitude = std::numbers::pi * ((row + 0.5) / rows - 0.5);
          const Point p{-std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                        std::cos(latitude) * std::sin(longitude)};
          const int before = static_cast<int>(test::texel_index(uv_of(convention, p).u, n));
          const int after = static_cast<int>(test::texel_index(turned(p).u, n));
          if (after != (before + (direction * quarter + 4) * (n / 4)) % n) ++wrong;
        }
      }
      CAPTURE(quarter);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("the lecture's convention is the book's on a globe turned back by a quarter") {
  constexpr int n = 8192;
  const Rotated<ConventionMapping> turned{rotation_y(-90), {Convention::rtiow}};
  int wrong = 0;
  double worst = 0;
  for (int column = 0; column < n; ++column) {
    const double longitude = 2 * std::numbers::pi * (column + 0.5) / n;
    const Point p{-std::cos(longitude), 0.3, std::sin(longitude)};
    const Uv<double> lecture = uv_of(Convention::lecture, p);
    const Uv<double> book = turned(p);
    if (test::texel_index(lecture.u, n) != test::texel_index(book.u, n)) ++wrong;
    worst = std::max({worst, apart(lecture.u, book.u), abs(lecture.v - book.v)});
  }
  CHECK(wrong == 0);
  CHECK(worst <= 4e-16);
}

TEST_CASE("a turned mapping turns the point before it maps it") {
  const Rotated<RtiowMapping> turned{rotation_y(90), {}};
  CHECK(turned(Point{0, 0, 1}).u == 0.5);
  CHECK(turned(Point{1, 0, 0}).u == 0.75);
  CHECK(ConventionMapping{}(Point{0, 0, 1}).u == 0.25);
  CHECK(ConventionMapping{Convention::daily}(Point{0, 0, 1}).u == 0.75);
}

}  // namespace
}  // namespace texmap::test
