// What changed between two steps, and whether only that changed which the chapters declare.
#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/compare/difference_map.hpp"
#include "engine/compare/figures_json.hpp"
#include "engine/measure/text.hpp"

namespace texmap::steps {
namespace {

constexpr int zoom_radius = 7;  // pixels on each side of the middle one
constexpr int zoom_factor = 16;

double turns_between(double a, double b) { return std::abs((a - b) - std::round(a - b)); }

bool has_uv(const Uv<double>& uv) { return !std::isnan(uv.u); }

std::string names_of(const std::vector<int>& objects) {
  std::string names;
  for (const int object : objects) {
    if (!names.empty()) names += ", ";
    names += object_name(object);
  }
  return names.empty() ? "none" : names;
}

}  // namespace

std::string object_name(int index) {
  constexpr std::array<const char*, 4> names = {"middle", "left", "right", "ground"};
  if (index < 0) return "sky";
  if (static_cast<std::size_t>(index) < names.size()) return names[static_cast<std::size_t>(index)];
  return "object " + std::to_string(index);
}

Comparison compare(DrawnStep before, DrawnStep after, std::vector<int> may_change) {
  Comparison result;
  result.figures = measure(before.picture, after.picture);
  const auto allowed = [&](int object) {
    return std::find(may_change.begin(), may_change.end(), object) != may_change.end();
  };
  int left = before.picture.width, right = -1, top = before.picture.height, bottom = -1;
  for (std::size_t i = 0; i < before.picture.pixels.size(); ++i) {
    const int column = static_cast<int>(i % static_cast<std::size_t>(before.picture.width));
    const int row = static_cast<int>(i / static_cast<std::size_t>(before.picture.width));
    if (has_uv(before.uv[i]) && has_uv(after.uv[i])) {
      const double du = turns_between(before.uv[i].u, after.uv[i].u);
      const double dv = std::abs(before.uv[i].v - after.uv[i].v);
      result.pixels_with_uv += 1;
      result.largest_du = std::max(result.largest_du, du);
      result.largest_dv = std::max(result.largest_dv, dv);
      if (du > 0 || dv > 0) {
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = row;
      }
    }
    if (before.picture.pixels[i] == after.picture.pixels[i]) continue;
    if (allowed(before.objects[i]) || allowed(after.objects[i])) {
      result.changed_inside += 1;
      continue;
    }
    if (result.changed_elsewhere == 0) {
      result.stray_column = column;
      result.stray_row = row;
    }
    result.changed_elsewhere += 1;
  }
  if (right >= 0) result.uv_box = {left, top, right - left + 1, bottom - top + 1};
  result.before = std::move(before);
  result.after = std::move(after);
  result.may_change = std::move(may_change);
  return result;
}

Image crop(const Image& picture, const Box& box) {
  constexpr int margin = 8;
  const int left = std::max(box.left - margin, 0);
  const int top = std::max(box.top - margin, 0);
  Image part(std::min(box.left + box.width + margin, picture.width) - left,
             std::min(box.top + box.height + margin, picture.height) - top);
  for (int row = 0; row < part.height; ++row) {
    for (int column = 0; column < part.width; ++column)
      part.at(column, row) = picture.at(left + column, top + row);
  }
  return part;
}

Image uv_difference_map(const Comparison& comparison) {
  const Image& picture = comparison.before.picture;
  constexpr Rgb8 nothing{128, 128, 128};
  const auto shade = [](double share) {
    return difference_color(static_cast<int>(std::min(share, 1.0) * 255));
  };
  Image map(2 * picture.width, picture.height, nothing);
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(column);
      const Uv<double>& a = comparison.before.uv[i];
      const Uv<double>& b = comparison.after.uv[i];
      if (!has_uv(a) || !has_uv(b)) continue;
      map.at(column, row) = shade(2 * turns_between(a.u, b.u));
      map.at(picture.width + column, row) = shade(std::abs(a.v - b.v));
    }
  }
  return map;
}

Image zoom(const Image& picture, int column, int row) {
  constexpr int side = 2 * zoom_radius + 1;
  Image enlarged(side * zoom_factor, side * zoom_factor, {128, 128, 128});
  for (int y = 0; y < enlarged.height; ++y) {
    for (int x = 0; x < enlarged.width; ++x) {
      const int from_column = column - zoom_radius + x / zoom_factor;
      const int from_row = row - zoom_radius + y / zoom_factor;
      const bool inside = from_column >= 0 && from_column < picture.width && from_row >= 0 &&
                          from_row < picture.height;
      if (inside) enlarged.at(x, y) = picture.at(from_column, from_row);
      // A frame of two lines, black in white, round the middle pixel: seen on any color.
      const int off_x = std::abs(2 * x + 1 - enlarged.width) / 2;
      const int off_y = std::abs(2 * y + 1 - enlarged.height) / 2;
      const int ring = std::max(off_x, off_y) - zoom_factor / 2;
      if (ring == 0 || ring == 1) enlarged.at(x, y) = Rgb8{0, 0, 0};
      if (ring == 2 || ring == 3) enlarged.at(x, y) = Rgb8{255, 255, 255};
    }
  }
  return enlarged;
}

std::string report_json(const Comparison& c) {
  std::vector<Json> may_change;
  for (const int object : c.may_change) may_change.emplace_back(object_name(object));
  const Json stray = Json::object({{"column", c.stray_column}, {"row", c.stray_row}});
  return Json::object(
             {
                 {"before", c.before.chapter},
                 {"after", c.after.chapter},
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
  std::string lines = c.before.chapter + " -> " + c.after.chapter + "\n";
  if (f.pixels_different == 0) {
    lines += "  changed    0 of " + std::to_string(f.pixels_compared) + " pixels\n";
  } else {
    lines += text("  changed    %zu of %zu pixels (%.2f %%), columns %d to %d, rows %d to %d\n",
                  f.pixels_different, f.pixels_compared, 100 * f.share_different, f.box.left,
                  f.box.left + f.box.width - 1, f.box.top, f.box.top + f.box.height - 1);
  }
  lines += text("  elsewhere  %zu pixels changed that show no object that may change (%s)\n",
                c.changed_elsewhere, names_of(c.may_change).c_str());
  lines += text("  figures    largest %d levels at (%d, %d), RMSE %.2f, PSNR %.1f dB, SSIM %.4f\n",
                f.worst.levels, f.worst.column, f.worst.row, f.root_mean_square_error,
                f.peak_signal_to_noise, f.structural_similarity);
  lines.append("  look at    ").append(page).append("\n");
  return lines;
}

}  // namespace texmap::steps
