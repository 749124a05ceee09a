// The four seeds' conventions side by side: their own formulas, and the figures that relate them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "conventions.hpp"
#include "seed_formulas.hpp"

namespace texmap::chapter_04 {

/// A seed's way of laying (u, v) on a sphere.
struct Seed {
  const char* title;
  Uv<double> (*formula)(const Point&);
  Convention convention;
};

inline constexpr std::array<Seed, 4> seeds_compared = {{
    {"seed 0: daily", seeds::uv_daily<double>, Convention::daily},
    {"seed 1: One Weekend 2020", seeds::uv_one_weekend_2020<double>, Convention::rtiow},
    {"seed 2: rtiow", seeds::uv_next_week_v4<double>, Convention::rtiow},
    {"seed 4: lecture", seeds::uv_lecture<double>, Convention::lecture},
}};

/// The direction at a place of the flat map: east to the right from -x, north up, as seen from outside the sphere.
///
/// @param east, north  0 to 1 from the left and from the lower edge
[[nodiscard]] inline Point direction_at(double east, double north) {
  const double longitude = 2 * std::numbers::pi * east;
  const double latitude = std::numbers::pi * (north - 0.5);
  return {-std::cos(longitude) * std::cos(latitude), std::sin(latitude), std::sin(longitude) * std::cos(latitude)};
}

/// +1 where a picture laid on by `formula` reads as printed, -1 where it is mirrored: the sign of the Jacobian of (u, up)
/// against (east, north) at one place, by differences. `up` is v, or -v where v runs down the picture.
[[nodiscard]] inline int handedness(const Seed& seed) {
  constexpr double east = 0.4;
  constexpr double north = 0.6;
  constexpr double step = 1e-4;
  const Uv<double> here = seed.formula(direction_at(east, north));
  const Uv<double> to_east = seed.formula(direction_at(east + step, north));
  const Uv<double> to_north = seed.formula(direction_at(east, north + step));
  const double up = v_axis_of(seed.convention) == VAxis::up ? 1 : -1;
  const double determinant = ((to_east.u - here.u) * (to_north.v - here.v) - (to_north.u - here.u) * (to_east.v - here.v)) * up;
  return determinant > 0 ? 1 : -1;
}

/// A relation between two conventions, and the largest error with which it holds.
struct Relation {
  std::string text;
  double residual = 0;  ///< in turns for u, in half turns for v
};

/// The exact relations, measured with the seeds' own formulas in double on 100,000 directions spread evenly over the sphere.
/// Between u = 0 and u = 1, which are one meridian, the distance is counted the short way round.
[[nodiscard]] inline std::array<Relation, 6> measure_relations() {
  std::array<Relation, 6> relations = {{
      {"u1 = u2"},
      {"u2 = 1 - u0"},
      {"u4 = frac(u2 - 1/4)"},
      {"v1 = v2"},
      {"v2 = 1 - v0"},
      {"v4 = v2"},
  }};
  const auto round_the_circle = [](double a, double b) { return std::abs((a - b) - std::round(a - b)); };
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    // Equal steps of height and golden steps round: a Fibonacci lattice.
    const double y = 1 - (2 * i + 1.0) / count;
    const double turn = i * 0.61803398874989485;
    const double radius = std::sqrt(1 - y * y);
    const Point p{radius * std::cos(2 * std::numbers::pi * turn), y, radius * std::sin(2 * std::numbers::pi * turn)};
    const Uv<double> s0 = seeds::uv_daily(p);
    const Uv<double> s1 = seeds::uv_one_weekend_2020(p);
    const Uv<double> s2 = seeds::uv_next_week_v4(p);
    const Uv<double> s4 = seeds::uv_lecture(p);
    const std::array<double, 6> errors = {round_the_circle(s1.u, s2.u),        round_the_circle(s2.u, 1 - s0.u),
                                          round_the_circle(s4.u, s2.u - 0.25), std::abs(s1.v - s2.v),
                                          std::abs(s2.v - (1 - s0.v)),         std::abs(s4.v - s2.v)};
    for (std::size_t k = 0; k < errors.size(); ++k) relations[k].residual = std::max(relations[k].residual, errors[k]);
  }
  return relations;
}

/// The table that the chapter prints.
[[nodiscard]] inline std::string table_of_relations() {
  std::string table = "relation                largest error on 100,000 directions, double\n";
  std::array<char, 120> line{};
  for (const Relation& relation : measure_relations()) {
    std::snprintf(line.data(), line.size(), "%-24s%.1e\n", relation.text.c_str(), relation.residual);
    table += line.data();
  }
  table += "\nconvention                  u runs  v runs  a picture on it\n";
  for (const Seed& seed : seeds_compared) {
    const double west_to_east = seed.formula(direction_at(0.41, 0.6)).u - seed.formula(direction_at(0.4, 0.6)).u;
    const double south_to_north = seed.formula(direction_at(0.4, 0.61)).v - seed.formula(direction_at(0.4, 0.6)).v;
    std::snprintf(line.data(), line.size(), "%-28s%-8s%-8s%s\n", seed.title, west_to_east > 0 ? "east" : "west",
                  south_to_north > 0 ? "north" : "south", handedness(seed) > 0 ? "reads as printed" : "is mirrored");
    table += line.data();
  }
  return table + "\n";
}

}  // namespace texmap::chapter_04
