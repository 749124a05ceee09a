// Tests of common/texture/footprint.hpp: what a pixel covers on a texture. That its sides are in
// range whatever the derivatives, and how exact these are, tests/extremes searches.
#include "texture/footprint.hpp"

#include <doctest.h>
#include <algorithm>

#include "support/dice.hpp"

namespace texmap::test {
namespace {

Uv<Dual<double>> moving(double u_by_x, double u_by_y, double v_by_x, double v_by_y) {
  return {{0.5, u_by_x, u_by_y}, {0.5, v_by_x, v_by_y}};
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
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::exp(dice.between(-12, 12));
    const auto any = [&] { return size * dice.between(-1, 1) * (dice.once_in(8) ? 0.001 : 1); };
    const double pu = any(), pv = any(), qu = any(), qv = any();
    worst = std::max(worst, misfit(footprint_of(moving(pu, qu, pv, qv), 1.0, 1.0), pu, pv, qu, qv));
  }
  CHECK(worst < 1e-14);
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
  const double nan = std::numeric_limits<double>::quiet_NaN();  // wider than any texture
  CHECK(footprint_of(moving(nan, 0, 0, 0), 4.0, 4.0).longer == 16777216);
}

}  // namespace
}  // namespace texmap::test
