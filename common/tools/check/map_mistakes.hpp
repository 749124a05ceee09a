// What often goes wrong on the way from a point of the unit sphere to its (u, v) on a map.
#pragma once
#include "exercises.hpp"

namespace texmap::check {

/// A map's u from a share of a turn to the east, 0 on +x: the right one first, then what those take
/// who make another mistake, too.
using Begins = std::vector<double (*)(double share)>;

/// The own mistakes with the u of a map on which +x is in the middle.
inline double from_half(double share) { return 0.5 + share; }
inline double from_0(double share) { return share; }
inline Slips<double> wrong_halves(double share) {
  return {
      {"the 1/2 is missing in u (in C++ 1 / 2 is 0, so write 0.5): u can be negative", share},
      {"1/2 is added, not subtracted: u can be negative", share - 0.5},
      {"only the angle is divided: write (angle + pi) / (2 * pi)", pi + share},
      {"u is 0 on +x, where it has to be 1/2: the map is turned by half a turn",
       {share < 0 ? share + 1 : share, share + 1}},
  };
}

/// Wrong u of the point (x, y, z) on such a map; `own` are the map's own mistakes.
inline Slips<double> wrong_us(double x, double y, double z, const Begins& begins,
                              Slips<double> (*own)(double share)) {
  constexpr double turn = 2 * pi;
  const auto share = [](double sine, double cosine) { return atan2(sine, cosine) / turn; };
  const double longitude = atan2(-z, x);
  constexpr auto precedence = "C++ reads a / 2 * pi as (a / 2) * pi: write a / (2 * pi)";
  constexpr auto radians = "u is in radians: divide the angle by 2 pi";
  const Slips<double> shares = {
      {precedence, longitude / 2 * pi},
      {radians, longitude},
      {"divide the radians by 2 pi",
       {{"a whole turn is not 360", longitude / 360},
        {"u is a part of 1, not degrees", longitude / radian},
        {"by pi alone the map goes around twice", longitude / pi}}},
      {"the arguments of atan2 are exchanged (z comes first), or u begins a quarter turn away",
       {share(x, z), -share(x, z)}},
      {"y goes up: the longitude is an angle between x and z",
       {share(-y, x), share(x, -y), share(-z, -y), share(y, x), share(x, y), share(-z, y)}},
      {"std::atan sees only z / x, half of the globe: use std::atan2", atan(-z / x) / turn},
  };
  Slips<double> us = own(longitude / turn);
  us += {
      {precedence, (longitude + pi) / 2 * pi},
      {radians, longitude + pi},
      {"u is the same everywhere: in C++ 1 / 2 is 0, and 0 * angle is 0", begins.front()(0)},
  };
  for (const auto& begin : begins) us += changed(shares, begin);
  return us;
}

/// Wrong (u, v) of the point (x, y, z) on such a map, v upward, as many write them.
inline Slips<Place2> map_slips(double x, double y, double z, const Begins& begins,
                               Slips<double> (*own)(double share)) {
  const auto v_by = [](double cosine) { return acos(clamp(cosine, -1.0, 1.0)) / pi; };
  const double north = asin(y), south = acos(-y);
  const double u = begins.front()(atan2(-z, x) / (2 * pi)), v = south / pi;
  const Slips<double> vs = {
      {"v is 0 on the equator, and has to be 1/2 there: add 0.5 (in C++ 1 / 2 is 0)", north / pi},
      {"divide the radians by pi",
       {{"v is in radians", {south, 1 - south}},
        {"half a turn is not 180", {south / 180, 0.5 + north / 180}},
        {"v is a part of 1, not degrees", south / radian},
        {"acos and asin run over half a turn", {south / (2 * pi), 0.5 + north / (2 * pi)}}}},
      {"v grows with the angle, not with the height y: take acos or asin", {(y + 1) / 2, y}},
      {"y is the axis from pole to pole: v comes from y", {v_by(x), v_by(-x), v_by(z), v_by(-z)}},
      {"limit y to -1 and 1, not to 0 and 1: half of the globe has negative y", v_by(max(-y, 0.0))},
      {"v is below 0 everywhere but at a pole: take the minus away", -v},
      {"the square root is missing in v: the distance from the axis is sqrt(x * x + z * z)",
       atan2(x * x + z * z, -y) / pi},
  };
  Slips<Place2> table = {"u and v are exchanged", {v, u}};
  table += changed(wrong_us(x, y, z, begins, own), [&](double wrong) { return Place2{wrong, v}; });
  return table += changed(vs, [&](double wrong) { return Place2{u, wrong}; });
}

/// The same for those who have a sign wrong or do not limit y, for acos and asin, too.
inline Slips<Place2> map_slips(const Vec3d& p, const Begins& begins,
                               Slips<double> (*own)(double share)) {
  Slips<Place2> table;
  for (const double y : {p.y, -p.y}) {
    for (const double z : {p.z, -p.z}) {
      for (const double limited : {clamp(y, -1.0, 1.0), y})
        table += map_slips(p.x, limited, z, begins, own);
    }
  }
  return table;
}

}  // namespace texmap::check
