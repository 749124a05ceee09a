// What a layout costs: the largest texel, the worst stretch, the length of its seams, time.
#include "figures.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/compare/interleaved.hpp"
#include "engine/files/text.hpp"

namespace texmap::chapter_10 {
namespace {

/// A part of a picture's edge or of a line inside it that is a seam.
struct Border {
  Uv<double> from, to;
};

std::vector<Border> borders_of(Projection projection) {
  constexpr double most = 1 - 1e-12;
  constexpr double above = 0.5;
  constexpr double under = 0.5 - 1e-12;
  switch (projection) {
    case Projection::cube:
    case Projection::equi_angular:
      // Of each of the two bands, so that the line between them is met twice.
      return {{{0, above}, {0, 1}},        {{most, above}, {most, 1}}, {{0, 1}, {most, 1}},
              {{0, above}, {most, above}}, {{0, 0}, {0, under}},       {{most, 0}, {most, under}},
              {{0, 0}, {most, 0}},         {{0, under}, {most, under}}};
    case Projection::equirect:
    case Projection::plane:
    case Projection::cylinder:
    case Projection::octahedral:
    case Projection::equal_area:
      break;
  }
  return {{{0, 0}, {0, 1}}, {{most, 0}, {most, 1}}, {{0, 0}, {most, 0}}, {{0, 1}, {most, 1}}};
}

double arc(const Vec3<double>& a, const Vec3<double>& b) {
  return atan2(length(cross(a, b)), dot(a, b));
}

std::string figure(double value) { return std::isinf(value) ? "no bound" : text("%.4f", value); }

/// Times of a projection / those of the equirectangular one.
struct RelativeTimes {
  double forward, inverse;
};
std::array<RelativeTimes, projections.size()> measure_times() {
  constexpr std::size_t count = 4096;
  std::vector<Vec3<double>> directions;
  std::vector<Uv<double>> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / count;
    const double v = std::fmod(static_cast<double>(i) * std::numbers::phi, 1.0);
    places.push_back({u, v});
    directions.push_back(unproject(Projection::cylinder, places.back()));
  }
  double kept = 0;  // so that the compiler cannot drop the work
  std::vector<Work> works;
  for (const ProjectionFacts& facts : projections) {
    const Projection projection = facts.projection;
    works.emplace_back([&, projection] {
      for (const Vec3<double>& p : directions) kept += project(projection, p).v;
    });
    works.emplace_back([&, projection] {
      for (const Uv<double>& uv : places) kept += unproject(projection, uv).y;
    });
  }
  const std::vector<WorkTime> times = work_times(works, 10);
  std::array<RelativeTimes, projections.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = {times[2 * i].processor / times[0].processor,
                 times[2 * i + 1].processor / times[1].processor};
  }
  volatile double sink = kept;
  static_cast<void>(sink);
  return result;
}

}  // namespace

ClosedForms closed_forms(Projection projection) {
  constexpr double pi = std::numbers::pi;
  constexpr double none = std::numeric_limits<double>::infinity();
  switch (projection) {
    case Projection::equirect:
      return {pi / 2, none, {0, 1, 0}};
    case Projection::plane:
      return {none, none, {1, 0, 0}};
    case Projection::cylinder:
      return {1, none, {0, 1, 0}};
    case Projection::cube:
      return {6 / pi, std::sqrt(3.0), {1, 1, 1}};
    case Projection::equi_angular:
      return {3 * pi / 8, std::sqrt(3.0), {1, 1, 1}};
    case Projection::octahedral:
      return {3 * std::sqrt(3.0) / pi, (3 + std::sqrt(5.0)) / 2, {1, 0, 0}};
    case Projection::equal_area:
      break;
  }
  const double sum = pi / 4 + 8 / pi;  // the stretch s at the equator has s + 1 / s = sum
  return {1, (sum + std::sqrt(sum * sum - 4)) / 2, {1, 0, 0}};
}

double seam_degrees(Projection projection) {
  if (projection == Projection::plane) return 360;  // the equator, where the other half is missing
  constexpr int steps = 3000;  // a multiple of 3: every corner of a cube is met
  double sum = 0;
  for (const Border& border : borders_of(projection)) {
    const auto at = [&](int i) {
      const double t = static_cast<double>(i) / steps;
      return unproject(projection, Uv<double>{border.from.u + t * (border.to.u - border.from.u),
                                              border.from.v + t * (border.to.v - border.from.v)});
    };
    for (int i = 0; i < steps; ++i) sum += arc(at(i), at(i + 1));
  }
  return sum / 2 * 180 / std::numbers::pi;
}

std::string table_of_figures() {
  const auto times = measure_times();
  std::string table =
      text("%-14s%-16s%-16s%-10s%-18s\n%-14s%-16s%-16s%-10s%-9s%s\n", "", "largest texel",
           "worst stretch", "seams", "time, equirect 1", "projection", "/ mean texel",
           "long : short", "degrees", "forward", "inverse");
  for (std::size_t i = 0; i < projections.size(); ++i) {
    const Projection projection = projections[i].projection;
    const ClosedForms forms = closed_forms(projection);
    table += text("%-14s%-16s%-16s%-10.1f%-9.2f%.2f\n", projections[i].word,
                  figure(forms.largest_texel).c_str(), figure(forms.worst_stretch).c_str(),
                  seam_degrees(projection), times[i].forward, times[i].inverse);
  }
  return table + "\n";
}

}  // namespace texmap::chapter_10
