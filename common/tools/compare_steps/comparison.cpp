// What changed between two steps, and whether only that changed which the chapters declare.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/compare/show_figures.hpp"
#include "engine/measure/text.hpp"

namespace texmap::steps {

constexpr std::array object_names = {"middle", "left", "right", "ground"};

std::string names_of(ObjectSet objects, const std::string& if_empty) {
  std::string names;
  for (int index = 0; const char* const name : object_names) {
    if (objects.contains(index++)) names.append(names.empty() ? "" : ", ").append(name);
  }
  return names.empty() ? if_empty : names;
}

Comparison compare(DrawnStep before, DrawnStep after, ObjectSet may_change) {
  Comparison result;
  result.figures = measure(before.picture, after.picture);
  const auto allowed = [&](int object) { return object >= 0 && may_change.contains(object); };
  for (std::size_t i = 0; i < before.objects.size(); ++i) {
    const Uv<double>&a = before.uv[i], &b = after.uv[i];
    if (!std::isnan(a.u) && !std::isnan(b.u)) {
      const double turns = a.u - b.u;
      result.pixels_with_uv += 1;
      result.largest_du = std::max(result.largest_du, std::abs(turns - std::round(turns)));
      result.largest_dv = std::max(result.largest_dv, std::abs(a.v - b.v));
    }
    if (before.picture.pixels[i] == after.picture.pixels[i]) continue;
    if (allowed(before.objects[i]) || allowed(after.objects[i])) {
      result.changed_inside += 1;
      continue;
    }
    if (result.changed_elsewhere == 0) {
      result.stray_column = static_cast<int>(i) % before.picture.width;
      result.stray_row = static_cast<int>(i) / before.picture.width;
    }
    result.changed_elsewhere += 1;
  }
  result.before = std::move(before);
  result.after = std::move(after);
  result.may_change = may_change;
  return result;
}
std::string report_json(const Comparison& c) {
  std::vector<Json> may_change;
  for (int index = 0; const char* const name : object_names) {
    if (c.may_change.contains(index++)) may_change.emplace_back(name);
  }
  const Json stray = Json::object({{"column", c.stray_column}, {"row", c.stray_row}});
  return Json::object(
             {
                 {"before", c.before.name},
                 {"after", c.after.name},
                 {"only_declared_changed", c.changed_elsewhere == 0},
                 {"may_change", Json::list(may_change)},
                 {"changed_inside", c.changed_inside},
                 {"changed_elsewhere", c.changed_elsewhere},
                 {"first_changed_elsewhere", c.stray_column < 0 ? nullptr : stray},
                 {"pixels_with_uv", c.pixels_with_uv},
                 {"largest_du_turns", c.largest_du},
                 {"largest_dv", c.largest_dv},
                 {"figures", json_of(c.figures)},
             },
             true)
             .text +
         "\n";
}

std::string summary(const Comparison& c, const std::string& page) {
  const Figures& f = c.figures;
  std::string lines = c.before.name + " -> " + c.after.name + "\n";
  if (f.pixels_different == 0) {
    lines += "  changed    0 of " + std::to_string(f.pixels_compared) + " pixels\n";
  } else {
    lines += "  changed    " + differing_pixels(f) +
             text("; columns %d to %d, rows %d to %d\n", f.box.left, f.box.left + f.box.width - 1,
                  f.box.top, f.box.top + f.box.height - 1);
  }
  lines += text("  elsewhere  %zu pixels changed; the step may change: %s\n", c.changed_elsewhere,
                names_of(c.may_change, "nothing").c_str());
  lines += text("  figures    largest %d levels at (%d, %d), RMSE %.2f, PSNR %.1f dB, SSIM %.4f\n",
                f.worst.levels, f.worst.column, f.worst.row, f.root_mean_square_error,
                f.peak_signal_to_noise, f.structural_similarity);
  lines.append("  look at    ").append(page).append("\n");
  return lines;
}

}  // namespace texmap::steps
