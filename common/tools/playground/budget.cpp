// The WebAssembly module of chapter 13's live picture: the chapter's own ways to draw the globe,
// with their bounds, errors and pictures, and what a graphics processor's (u, v) are compared with.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "13_speed_for_accuracy/errors.hpp"
#include "13_speed_for_accuracy/measure.hpp"
#include "13_speed_for_accuracy/report.hpp"
#include "engine/files/decode_image.hpp"
#include "engine/files/json.hpp"
#include "exported.hpp"
#include "texel_error.hpp"

namespace {

using namespace texmap;
using namespace texmap::chapter_13;

struct Trade {
  Globe globe;
  View<> view = globe.view(318, 224);  // as on the chapter's sheet
  std::vector<Row> rows;
  std::vector<ReferenceHit> hits;
  Image reference;

  explicit Trade(const Image& picture) : globe(picture) {
    for (const Row& row : rows_of(Part::places, Instructions::baseline)) {
      if (row.variant.filter == Filter::nearest && row.variant.number != NumberKind::extended)
        rows.push_back(row);
    }
  }
};
std::unique_ptr<Trade> trade;

/// A unit vector of float, as the page's graphics processor gets it, and what it gives back.
struct Probe {
  float x, y, z, met;
};
std::vector<Probe> probes;
Image errors;  ///< of the probes, a row
constexpr int map_width = 1024, map_height = 512;

/// The directions of a map: its first and last columns are the seam, its first and last rows the
/// poles.
Vec3d map_direction(int column, int row) {
  const double turn = 2 * std::numbers::pi * column / (map_width - 1);
  const double from_pole = std::numbers::pi * row / (map_height - 1);
  const double round = std::sin(from_pole);
  return {-std::cos(turn) * round, std::cos(from_pole), std::sin(turn) * round};
}

Uv<double> right_uv(const Probe& probe) {
  return uv_rtiow(Vec3d{double(probe.x), double(probe.y), double(probe.z)});
}

}  // namespace

/// Reads the globe's PNG or JPEG; returns the ways to draw it, with what is known beforehand.
EXPORTED(begin) const char* begin(const std::uint8_t* bytes, int size) {
  return answer([&] {
    trade = std::make_unique<Trade>(decode_image({bytes, static_cast<std::size_t>(size)}));
    return Json::object(
               {{"width", trade->view.width},
                {"height", trade->view.height},
                {"map", Json::list({double(map_width), double(map_height)})},
                {"ways", Json::list_of(trade->rows,
                                       [](const Row& row) {
                                         return Json::object(
                                             {{"number", name_of(row.variant.number)},
                                              {"kernel", name_of_kernel(row.variant.degree)},
                                              {"budget", budget_for(row.variant.degree,
                                                                    trade->globe.nearest.image)}});
                                       })}})
        .text;
  });
}

/// Compares a way with the judge: its bound, what is seen, and how many pixels change. The first
/// call draws the judge's picture, which takes the longest.
EXPORTED(compare) const char* compare(int way) {
  if (trade->hits.empty()) {
    trade->hits = reference_hits(trade->globe, trade->view);
    trade->reference = picture_of_hits(trade->globe, trade->view, Filter::nearest, trade->hits);
  }
  Row& row = trade->rows[static_cast<std::size_t>(way)];
  find_errors_of_place(row, trade->globe, trade->view, trade->hits);
  return answer([&] {
    return Json::object({{"bound", row.bound},
                         {"worst", row.worst},
                         {"changed", row.changed},
                         {"may_change", row.may_change},
                         {"levels", row.levels}})
        .text;
  });
}

/// The picture of a way, 4 bytes a pixel.
EXPORTED(draw) const std::uint8_t* draw(int way) {
  return rgba_of(
      picture_of(trade->globe, trade->view, trade->rows[static_cast<std::size_t>(way)].variant, 1));
}

/// Of ways that took these milliseconds, shortest and median, the fastest that keeps to a limit in
/// texels, or -1, and the front: nothing is both faster and more exact.
EXPORTED(choose) const char* choose(double limit, const double* times) {
  for (std::size_t i = 0; i < trade->rows.size(); ++i)
    trade->rows[i].took = {times[2 * i], times[2 * i], times[2 * i + 1] / times[2 * i]};
  Rows all, within;
  for (const Row& row : trade->rows) {
    all.push_back(&row);
    if (keeps_to({Budget::Unit::texels, limit}, row)) within.push_back(&row);
  }
  const auto number = [](const Row* row) {
    return row == nullptr ? -1 : int(row - trade->rows.data());
  };
  return answer([&] {
    return Json::object(
               {{"best", number(fastest(within))},
                {"front", Json::list_of(pareto_front(all),
                                        [&](const Row* row) { return Json(number(row)); })}})
        .text;
  });
}

/// Where the picture of a way differs from the judge's.
EXPORTED(show_changes) const std::uint8_t* show_changes(int way) {
  Trade& t = *trade;
  return rgba_of(
      differences(picture_of(t.globe, t.view, t.rows[static_cast<std::size_t>(way)].variant, 1),
                  t.reference, 1));
}

/// Chooses what a graphics processor computes (u, v) of: the directions of a map of the sphere, or
/// the normals of the picture; four floats each, the fourth 0 where a pixel shows the sky.
EXPORTED(probe) const Probe* probe(int of_map) {
  const Trade& t = *trade;
  probes.clear();
  if (of_map != 0) {
    for (int row = 0; row < map_height; ++row) {
      for (int column = 0; column < map_width; ++column) {
        const Vec3d n = map_direction(column, row);
        probes.push_back({float(n.x), float(n.y), float(n.z), 1});
      }
    }
    return probes.data();
  }
  for (int row = 0; row < t.view.height; ++row) {
    for (int column = 0; column < t.view.width; ++column) {
      const auto ray = ray_through(t.view, double(column), double(row));
      const double distance = distance_to(t.globe.sphere, ray);
      if (distance == infinity<double>()) {
        probes.push_back({0, 0, 0, 0});
        continue;
      }
      const Vec3d n = normal_at(t.globe.sphere, ray, distance);
      probes.push_back({float(n.x), float(n.y), float(n.z), 1});
    }
  }
  return probes.data();
}

/// The coefficients of a degree's polynomials, as FastUnitMapping has them.
EXPORTED(coefficients) const char* coefficients(int degree) {
  return answer([&] {
    return with_uv_mapping(degree, [&]<class Mapping>(const Mapping&) {
      if constexpr (requires { Mapping::degree; }) {
        const auto list = [](const auto& powers) {
          return Json::list_of(powers, [](long double power) { return Json(double(power)); });
        };
        return Json::object({{"tangent", list(ArcTangentFit<Mapping::degree>::powers)},
                             {"cosine", list(ArcCosineFit<Mapping::degree>::powers)}})
            .text;
      } else {
        return std::string("!this degree has no polynomial");
      }
    });
  });
}

/// Compares (u, v) that were computed elsewhere, two floats a probe, with double's for the same
/// direction. Returns the largest error in texels, of all probes, near the seam and near the poles,
/// and how many probes read another texel.
EXPORTED(judge) const char* judge(const float* uv) {
  const Trade& t = *trade;
  const Size texels{t.globe.nearest.image.width, t.globe.nearest.image.height};
  double worst = 0, seam = 0, pole = 0;
  int changed = 0;
  std::vector<double> off;
  errors = Image(static_cast<int>(probes.size()), 1);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto& [x, y, z, met] = probes[i];
    Rgb color = gray(0.0);
    if (met != 0) {
      const Uv<double> right = right_uv(probes[i]), given{double(uv[2 * i]), double(uv[2 * i + 1])};
      const double round = std::hypot(double(x), double(z));
      const double across = std::abs(given.u - right.u);
      const double error = std::max(std::min(across, std::abs(1 - across)) * round * texels.width,
                                    std::abs(given.v - right.v) * texels.height);
      const double texel_off = error <= 1e9 ? error : 1e9;  // also for no number
      worst = std::max(worst, texel_off);
      if (std::min(right.u, 1 - right.u) < 1e-3) seam = std::max(seam, texel_off);
      if (round < 0.01) pole = std::max(pole, texel_off);
      off.push_back(texel_off);
      const auto shown = [&](const Uv<double>& at) { return t.globe.nearest(at); };
      const Rgb a = shown(given), b = shown(right);
      if (!(a.r == b.r && a.g == b.g && a.b == b.b)) ++changed;
      color = live::color_of_error(texel_off);
    }
    errors.pixels[i] = {byte_of(color.r), byte_of(color.g), byte_of(color.b)};
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  return answer([&] {
    return Json::object({{"worst", worst},
                         {"median", *middle},
                         {"seam", seam},
                         {"pole", pole},
                         {"changed", changed},
                         {"probes", int(off.size())}})
        .text;
  });
}
/// The errors of the last comparison as colors, 4 bytes a probe.
EXPORTED(judged) const std::uint8_t* judged() { return rgba_of(errors); }
