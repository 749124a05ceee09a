// Tests of common/texture/footprint.hpp: what a pixel covers on a texture.
#include "texture/footprint.hpp"

#include <doctest.h>

#include "support/dice.hpp"
#include "support/many_digits.hpp"

namespace texmap::test {
namespace {

template <class Real>
Uv<Dual<Real>> moving(Real u_by_x, Real u_by_y, Real v_by_x, Real v_by_y) {
  return {{Real(0.5), u_by_x, u_by_y}, {Real(0.5), v_by_x, v_by_y}};
}

/// How far a footprint is from having the parallelogram's area and its spread in each direction,
/// in units of the spread. The parallelogram's sides are p and q.
double misfit(const Footprint<double>& footprint, double pu, double pv, double qu, double qv) {
  using Wide = long double;
  const Wide uu = Wide(pu) * pu + Wide(qu) * qu, vv = Wide(pv) * pv + Wide(qv) * qv;
  const Wide both = Wide(pu) * pv + Wide(qu) * qv;
  const Wide longer = footprint.longer, shorter = footprint.shorter;
  const Wide u = footprint.along_u / longer, v = footprint.along_v / longer;
  // The rectangle's spread: longer^2 along (u, v), shorter^2 across, along (-v, u).
  const Wide l = longer * longer, s = shorter * shorter;
  const Wide off = std::max({std::abs(l * u * u + s * v * v - uu),
                             std::abs(l * v * v + s * u * u - vv), std::abs((l - s) * u * v - both),
                             std::abs(longer * shorter - std::abs(Wide(pu) * qv - Wide(pv) * qu))});
  return static_cast<double>(off / (uu + vv));
}

TEST_CASE("the rectangle has the parallelogram's area and its spread in every direction") {
  Dice dice(9);
  double worst = 0, worst_exchanged = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::exp(dice.between(-12, 12));
    const auto any = [&] { return size * dice.between(-1, 1) * (dice.once_in(8) ? 0.001 : 1); };
    const double pu = any(), pv = any(), qu = any(), qv = any();
    const auto of = [&](double a, double b, double c, double d) {
      return footprint_of(moving(a, b, c, d), 1.0, 1.0);
    };
    worst = std::max(worst, misfit(of(pu, qu, pv, qv), pu, pv, qu, qv));
    // pbrt-v4's fault: the derivatives of s and t exchanged.
    worst_exchanged = std::max(worst_exchanged, misfit(of(pv, qv, pu, qu), pu, pv, qu, qv));
  }
  CHECK(worst < 1e-14);
  CHECK(worst_exchanged > 0.5);
}

TEST_CASE("sides along u and v are the footprint, and its size counts in texels") {
  const auto wide = footprint_of(moving(0.5, 0.0, 0.0, 0.25), 16.0, 8.0);
  CHECK(wide.longer == 8);
  CHECK(wide.shorter == 2);
  CHECK(std::abs(wide.along_u) == 8);
  CHECK(wide.along_v == 0);
  const auto high = footprint_of(moving(0.0, 0.125, 1.0, 0.0), 16.0, 8.0);
  CHECK(high.longer == 8);
  CHECK(high.shorter == 2);
  CHECK(high.along_u == 0);
  CHECK(std::abs(high.along_v) == 8);
}

TEST_CASE_TEMPLATE("whatever the derivatives, a footprint is finite and its sides are in range",
                   Real, float, double, long double) {
  const Real infinite = infinity<Real>();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const std::array<Real, 13> values = {Real(0),   Real(1e-20), Real(-1e-20), Real(1e-6),  Real(1),
                                       Real(-1),  Real(1e6),   Real(1e20),   Real(-1e20), infinite,
                                       -infinite, nan,         -Real(0)};
  for (const Real a : values) {
    for (const Real b : values) {
      for (const Real c : values) {
        for (const Real d : values) {
          for (const Real size : {Real(1), Real(16384)}) {
            const auto footprint = footprint_of(moving(a, b, c, d), size, size);
            for (const Real part : {footprint.along_u, footprint.along_v, footprint.longer})
              REQUIRE((abs(part) < Real(4e7)));
            REQUIRE((footprint.shorter >= 0 && footprint.shorter <= footprint.longer));
          }
        }
      }
    }
  }
  const auto unknown = footprint_of(moving(nan, Real(0), Real(0), Real(0)), Real(4), Real(4));
  CHECK(unknown.longer == Real(16777216));
}

#ifdef TEXMAP_HAVE_DIGITS
/// The direction of a pixel, any function of its column and row that passes the seam and a pole.
template <class Real>
Vec3<Real> direction(const Real& column, const Real& row, double lift, double aside) {
  return {Real(-1) + column * row * Real(0.125), Real(lift) + row * Real(0.5) + column * Real(0.25),
          Real(aside) + column - row * Real(0.375)};
}

TEST_CASE("derivatives of (u, v) are those of 50 digits: on the seam, close to it, near a pole") {
  const double step = 0.01;  // of a pixel
  double worst = 0;
  for (const double aside : {0.3, 1e-3, 1e-12, 0.0, -1e-12, -1e-3, -0.3}) {
    for (const double lift : {0.0, 0.5, -2.0, 30.0, 1000.0}) {
      const auto uv =
          uv_rtiow(direction<Dual<double>>({0.0, step, 0.0}, {0.0, 0.0, step}, lift, aside));
      const auto exact = [&](bool by_column, bool of_u) {
        const Digits50 h("1e-7");  // a turn, 2 pi, is exact to 20 digits
        const auto at = [&](const Digits50& x) {
          const Digits50 column = by_column ? x : Digits50(0), row = by_column ? Digits50(0) : x;
          const auto place = uv_rtiow(direction<Digits50>(column, row, lift, aside));
          return of_u ? place.u : place.v;
        };
        Digits50 change = at(h) - at(-h);
        if (change > 0.5) change -= 1;  // across the seam
        if (change < -0.5) change += 1;
        return static_cast<double>(change / (2 * h) * Digits50(step));
      };
      const double size = std::abs(exact(true, true)) + std::abs(exact(true, false));
      worst = std::max({worst, std::abs(uv.u.dx - exact(true, true)) / size,
                        std::abs(uv.u.dy - exact(false, true)) / size,
                        std::abs(uv.v.dx - exact(true, false)) / size,
                        std::abs(uv.v.dy - exact(false, false)) / size});
    }
  }
  CHECK(worst < 1e-12);
}
#endif

TEST_CASE("the footprint does not notice the seam; differences of neighboring pixels do") {
  const auto at = [](double z) { return uv_rtiow(Vec3<Dual<double>>{-1.0, 0.2, {z, 0.01, 0.0}}); };
  const auto before = footprint_of(at(-1e-9), 1024.0, 512.0);
  const auto behind = footprint_of(at(1e-9), 1024.0, 512.0);
  CHECK(std::abs(at(-1e-9).u.value - at(1e-9).u.value) > 0.99);
  CHECK(std::abs(before.longer - behind.longer) < 1e-6);
  const auto plain = [](double z) { return uv_rtiow(Vec3d{-1, 0.2, z}).u; };
  const double from_neighbors = std::abs(plain(0.005) - plain(-0.005)) * 1024;
  CHECK(from_neighbors > 600 * before.longer);
}

}  // namespace
}  // namespace texmap::test
