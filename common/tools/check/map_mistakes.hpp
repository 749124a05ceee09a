// What often goes wrong on the way from a point of the unit sphere to its (u, v) on a map.
#pragma once
#include "exercises.hpp"

namespace texmap::check {

/// Wrong (u, v) of the point (x, y, z) in chapter 02's convention, as many write them.
inline Slips<Place2> map_slips(double x, double y, double z) {
  constexpr auto no_half =
      "the 1/2 is missing in u (in C++ 1 / 2 is 0, so write 0.5): u can be negative";
  constexpr auto degrees = "the angles are in radians: a whole turn is 2 pi, not 360";
  constexpr double turn = 2 * pi;
  const auto u_by = [](double sine, double cosine) { return 0.5 + atan2(sine, cosine) / turn; };
  const auto v_by = [](double cosine) { return acos(clamp(cosine, -1.0, 1.0)) / pi; };
  const double longitude = atan2(-z, x), north = asin(y), south = acos(-y);
  const double exchanged = atan2(x, z) / turn;
  const double u = 0.5 + longitude / turn, v = south / pi;
  const Slips<double> us = {
      {no_half, longitude / turn},
      {"1/2 is added, not subtracted: u can be negative", longitude / turn - 0.5},
      {"C++ reads a / 2 * pi as (a / 2) * pi: write a / (2 * pi)",
       {0.5 + longitude / 2 * pi, longitude / 2 * pi, (longitude + pi) / 2 * pi}},
      {"u is in radians: divide the angle by 2 pi, then add 1/2",
       {longitude, longitude + 0.5, longitude + pi}},
      {"only the angle is divided: write (angle + pi) / (2 * pi), or angle / (2 * pi) + 0.5",
       pi + longitude / turn},
      {degrees, {0.5 + longitude / 360, longitude / 360}},
      {"u is divided by pi: the map goes around twice", 0.5 + longitude / pi},
      {"u begins a quarter turn away, or the arguments of atan2 are exchanged: z comes first, the "
       "sine's side",
       {0.5 + exchanged, 0.5 - exchanged, exchanged}},
      {"u is 0 on +x, where it has to be 1/2: the map is turned by half a turn",
       {u < 0.5 ? u + 0.5 : u - 0.5, u_by(-z, -x)}},
      {"u is 1/2 everywhere: in C++ 1 / 2 is 0, and 0 times the angle is 0", 0.5},
      {"y goes up: the longitude is an angle between x and z",
       {u_by(-y, x), u_by(x, -y), u_by(-z, -y), u_by(y, x), u_by(x, y), u_by(-z, y)}},
      {"std::atan sees only the quotient z / x, half of the globe: use std::atan2",
       {0.5 + atan(-z / x) / turn, 0.5 + atan(-z / x) / pi}},
  };
  const Slips<double> vs = {
      {"v is 0 on the equator, and has to be 1/2 there: add 0.5 (in C++ 1 / 2 is 0)", north / pi},
      {"v is in radians: divide the angle by pi", south},
      {degrees, {south / 180, 0.5 + north / 180}},
      {"acos runs from 0 to pi: divide v by pi, not by 2 pi", south / turn},
      {"asin runs from -pi/2 to pi/2: divide v by pi, not by 2 pi", 0.5 + north / turn},
      {"v grows with the angle, not with the height y: take acos or asin", {(y + 1) / 2, y}},
      {"y is the axis from pole to pole: v comes from y", {v_by(x), v_by(-x), v_by(z), v_by(-z)}},
      {"limit y to -1 and 1, not to 0 and 1: half of the globe has negative y", v_by(max(-y, 0.0))},
      {"v is below 0 everywhere but at a pole: take the minus away", -v},
      {"the square root is missing in v: the distance from the axis is sqrt(x * x + z * z)",
       atan2(x * x + z * z, -y) / pi},
  };
  Slips<Place2> table = {
      {"u and v are parts of 1, not degrees: divide by 2 pi and by pi instead",
       {{longitude / radian, south / radian}, {0.5 + longitude / radian, south / radian}}},
      {"u and v are exchanged", {v, u}},
      {"the angles are not divided by 2 pi and pi: they are in radians",
       {{longitude, south}, {0.5 + longitude, south}}},
      {degrees, {0.5 + longitude / 360, south / 180}},
      {no_half, {longitude / turn, north / pi}},
  };
  table += changed(us, [&](double wrong) { return Place2{wrong, v}; });
  return table += changed(vs, [&](double wrong) { return Place2{u, wrong}; });
}

/// The same for those who have a sign wrong or do not limit y, for acos and asin, too.
inline Slips<Place2> map_slips(const Vec3d& p) {
  Slips<Place2> table;
  for (const double y : {p.y, -p.y}) {
    for (const double z : {p.z, -p.z}) {
      for (const double limited : {clamp(y, -1.0, 1.0), y}) table += map_slips(p.x, limited, z);
    }
  }
  return table;
}

}  // namespace texmap::check
