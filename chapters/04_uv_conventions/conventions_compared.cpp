// The source documents' conventions with their own formulas, and the figures that relate them.
#include "conventions_compared.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "published/uv.hpp"

#include "engine/files/text.hpp"

namespace texmap::chapter_04 {

const std::array<PublishedMapping, 4> published_mappings = {{
    {"daily exercise", published::uv_daily<double>, Convention::daily},
    {"One Weekend 2020", published::uv_one_weekend_2020<double>, Convention::rtiow},
    {"Next Week", published::uv_next_week_v4<double>, Convention::rtiow},
    {"lecture", published::uv_lecture<double>, Convention::lecture},
}};

Vec3<double> direction_at(double east, double north) {
  const double longitude = 2 * std::numbers::pi * east;
  const double latitude = std::numbers::pi * (north - 0.5);
  return {-cos(longitude) * cos(latitude), sin(latitude), sin(longitude) * cos(latitude)};
}

int handedness(const PublishedMapping& mapping) {
  constexpr double east = 0.4;
  constexpr double north = 0.6;
  constexpr double step = 1e-4;
  const Uv<double> here = mapping.formula(direction_at(east, north));
  const Uv<double> to_east = mapping.formula(direction_at(east + step, north));
  const Uv<double> to_north = mapping.formula(direction_at(east, north + step));
  const double up = v_axis_of(mapping.convention) == VAxis::up ? 1 : -1;
  const double determinant = ((to_east.u - here.u) * (to_north.v - here.v) -
                              (to_north.u - here.u) * (to_east.v - here.v)) *
                             up;
  return determinant > 0 ? 1 : -1;
}

std::array<Relation, 6> measure_relations() {
  std::array<Relation, 6> relations = {{
      {"u_weekend = u_next"},
      {"u_next = 1 - u_daily"},
      {"u_lecture = frac(u_next - 1/4)"},
      {"v_weekend = v_next"},
      {"v_next = 1 - v_daily"},
      {"v_lecture = v_next"},
  }};
  // u = 0 and u = 1 are one meridian: the shorter way between two u counts.
  const auto around = [](double a, double b) { return std::abs((a - b) - std::round(a - b)); };
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    // A Fibonacci lattice: equal steps of height, golden steps around the axis.
    const double y = 1 - (2 * i + 1.0) / count;
    const double turn = i * 0.61803398874989485;
    const double radius = std::sqrt(1 - y * y);
    const Vec3<double> p{radius * cos(2 * std::numbers::pi * turn), y,
                         radius * sin(2 * std::numbers::pi * turn)};
    const Uv<double> daily = published::uv_daily(p);
    const Uv<double> one_weekend = published::uv_one_weekend_2020(p);
    const Uv<double> next_week = published::uv_next_week_v4(p);
    const Uv<double> lecture = published::uv_lecture(p);
    const std::array<double, 6> errors = {
        around(one_weekend.u, next_week.u),    around(next_week.u, 1 - daily.u),
        around(lecture.u, next_week.u - 0.25), std::abs(one_weekend.v - next_week.v),
        std::abs(next_week.v - (1 - daily.v)), std::abs(lecture.v - next_week.v)};
    for (std::size_t k = 0; k < errors.size(); ++k)
      relations[k].residual = std::max(relations[k].residual, errors[k]);
  }
  return relations;
}

std::string table_of_relations() {
  std::string table =
      "relation                        largest error on 100,000 directions, double\n";
  for (const Relation& relation : measure_relations()) {
    table += text("%-32s%.1e\n", relation.text.c_str(), relation.residual);
  }
  table += "\n";
  for (const PublishedMapping& mapping : published_mappings) {
    const Uv<double> here = mapping.formula(direction_at(0.4, 0.6));
    const bool east = mapping.formula(direction_at(0.41, 0.6)).u > here.u;
    const bool north = mapping.formula(direction_at(0.4, 0.61)).v > here.v;
    table += text("%s: u runs %s, v runs %s, a picture on it %s\n", mapping.title,
                  east ? "east" : "west", north ? "north" : "south",
                  handedness(mapping) > 0 ? "reads as printed" : "is mirrored");
  }
  return table + "\n";
}

}  // namespace texmap::chapter_04
