// The sheet: each exhibit in float and double, with the seeds' formulas and with the course's, and the table of what went
// wrong.
#pragma once
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "exhibits.hpp"
#include "lettering.hpp"
#include "paste.hpp"
#include "render.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"

namespace texmap::chapter_14 {

/// One picture of an exhibit, and what each of its pixels sees, to more digits than it was drawn with.
struct Panel {
  Image image;
  std::vector<Sight<long double>> sights;

  Panel() = default;
  Panel(int width, int height)
      : image(width, height), sights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
};

/// How far one picture is from the truth.
struct Mistakes {
  int wrong = 0;           ///< pixels of another color, by more than one level of 255
  int missed = 0;          ///< pixels where one sees a surface and the other does not
  long double texels = 0;  ///< the largest way between the two places on a texture of 8192 x 4096, where both have one
};

/// The pictures of an exhibit: four ways to draw it, and the one that judges them.
enum Way { plain_float, robust_float, plain_double, robust_double, reference, ways };
inline constexpr std::array<const char*, reference> way_names = {"seeds', float", "robust, float", "seeds', double",
                                                                 "robust, double"};

template <class Real, class Exhibit>
void draw_row(Panel& panel, const Exhibit& exhibit, Care care, int row) {
  const View view = view_of(exhibit.camera, panel.image.width, panel.image.height);
  for (int column = 0; column < view.width; ++column) {
    const Sight<Real> sight = exhibit(ray_through(view, Real(column), Real(row)), care);
    const auto byte = [](Real channel) { return byte_of(static_cast<double>(channel)); };
    panel.image.at(column, row) = {byte(sight.color.r), byte(sight.color.g), byte(sight.color.b)};
    panel.sights[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(column)] = {
        {},
        {static_cast<long double>(sight.uv.u), static_cast<long double>(sight.uv.v)},
        sight.hit,
        sight.mapped,
        static_cast<long double>(sight.round)};
  }
}

template <class Exhibit>
void draw_row(Panel& panel, const Exhibit& exhibit, Way way, int row) {
  const Care care = way == plain_float || way == plain_double ? Care::plain : Care::robust;
  if (way == reference) {
    draw_row<long double>(panel, exhibit, care, row);
  } else if (way == plain_float || way == robust_float) {
    draw_row<float>(panel, exhibit, care, row);
  } else {
    draw_row<double>(panel, exhibit, care, row);
  }
}

/// True for colors more than one level apart in some channel: one level is what cutting off a byte makes of any rounding.
[[nodiscard]] inline bool differ(Rgb8 a, Rgb8 b) { return std::max({abs(a.r - b.r), abs(a.g - b.g), abs(a.b - b.b)}) > 1; }

/// @param truth  the same exhibit, drawn with more digits
[[nodiscard]] inline Mistakes mistakes_of(const Panel& panel, const Panel& truth) {
  Mistakes mistakes;
  for (std::size_t i = 0; i < truth.sights.size(); ++i) {
    const Sight<long double>& seen = panel.sights[i];
    const Sight<long double>& right = truth.sights[i];
    if (differ(panel.image.pixels[i], truth.image.pixels[i])) ++mistakes.wrong;
    if (seen.hit != right.hit) ++mistakes.missed;
    if (!seen.mapped || !right.mapped) continue;
    const long double across = abs(seen.uv.u - right.uv.u);  // u = 0 and u = 1 are one place
    mistakes.texels =
        std::max({mistakes.texels, std::min(across, 1 - across) * right.round * 8192, abs(seen.uv.v - right.uv.v) * 4096});
  }
  return mistakes;
}

[[nodiscard]] inline std::string texels_of(const Mistakes& mistakes, const Panel& truth) {
  bool mapped = false;
  for (const auto& sight : truth.sights) mapped = mapped || sight.mapped;
  if (!mapped) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1e", static_cast<double>(mistakes.texels));
  return text.data();
}

/// Two exhibits beside each other, four pictures each.
struct SheetLayout {
  int panel_width, panel_height, line, gap, scale;

  SheetLayout(int width, int height, int exhibits) {
    const int rows = (exhibits + 1) / 2;
    scale = std::max(1, width / 1640);
    line = 11 * scale;
    gap = std::max(1, width / 200);
    panel_width = std::max(1, width / 8 - gap);
    panel_height = std::max(1, height / rows - 3 * line - gap);
  }
  [[nodiscard]] int left(int exhibit, int way) const { return gap / 2 + (exhibit % 2 * 4 + way) * (panel_width + gap); }
  [[nodiscard]] int top(int exhibit) const { return exhibit / 2 * (panel_height + 3 * line + gap) + gap / 2; }
};

/// One exhibit as a lesson of its own.
template <class Exhibit>
struct Alone {
  const Exhibit& exhibit;
  Care care;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Ray<Real>& ray) const {
    return exhibit(ray, care).color;
  }
};

/// The picture of one exhibit, with the number that the user chose.
template <class Exhibit>
[[nodiscard]] Image draw_alone(const Exhibit& exhibit, Care care, Studio& studio) {
  const Alone<Exhibit> lesson{exhibit, care};
  const View view = view_of(exhibit.camera, studio.width, studio.height);
  return studio.timed(1.0 * studio.width * studio.height * studio.samples, [&](const RenderSettings& settings) {
    if (studio.number == Number::float_) return render<float>(lesson, view, settings);
    if (studio.number == Number::extended) return render<long double>(lesson, view, settings);
    return render<double>(lesson, view, settings);
  });
}

/// Draws and saves the exhibit of that name.
/// Errors: UsageError naming all exhibits if there is none.
template <class... Exhibit>
void show_exhibit(const std::tuple<Exhibit...>& exhibits, const std::string& name, Care care, Studio& studio) {
  std::string names;
  bool found = false;
  const auto look = [&](const auto& exhibit) {
    names += (names.empty() ? "" : ", ") + std::string(exhibit.name);
    if (name != exhibit.name) return;
    found = true;
    studio.save(draw_alone(exhibit, care, studio));
  };
  std::apply([&](const auto&... each) { (look(each), ...); }, exhibits);
  if (!found) throw UsageError("--exhibit takes one of " + names + ", not '" + name + "'");
}

/// The sheet and what it says in figures.
struct Sheet {
  Image picture;
  std::string table;
  std::vector<std::array<Mistakes, reference>> mistakes;  ///< of each exhibit, in their order
};

/// Draws every exhibit in all ways, on a sheet as large as the studio's picture.
template <class... Exhibit>
[[nodiscard]] Sheet draw_sheet(const std::tuple<Exhibit...>& exhibits, Studio& studio) {
  constexpr int count = sizeof...(Exhibit);
  const SheetLayout layout(studio.width, studio.height, count);
  std::vector<std::array<Panel, ways>> panels(count);
  for (auto& row : panels) row.fill(Panel(layout.panel_width, layout.panel_height));

  Sheet sheet;
  const double rays = 1.0 * count * int{ways} * layout.panel_width * layout.panel_height;
  sheet.picture = studio.timed(rays, [&](const RenderSettings& settings) {
    const int rows = layout.panel_height;
    for_each_row(count * ways * rows, settings.threads, settings.progress, [&](int job) {
      const auto way = static_cast<Way>(job / rows % ways);
      const int which = job / rows / ways;
      int at = 0;
      const auto draw_if_due = [&](const auto& exhibit) {
        if (at++ == which) draw_row(panels[static_cast<std::size_t>(which)][way], exhibit, way, job % rows);
      };
      std::apply([&](const auto&... each) { (draw_if_due(each), ...); }, exhibits);
    });
    return Image(studio.width, studio.height, {255, 255, 255});
  });

  sheet.table =
      "                         the seeds' formulas         the course's\n"
      "exhibit     number     wrong  missed  texels     wrong  missed  texels\n";
  const auto describe = [&](const auto& exhibit) {
    const int i = static_cast<int>(sheet.mistakes.size());
    const auto& row = panels[static_cast<std::size_t>(i)];
    sheet.mistakes.emplace_back();
    draw_text(sheet.picture, layout.left(i, 0), layout.top(i) + 2 * layout.scale, exhibit.caption, {0, 0, 0}, layout.scale);
    for (std::size_t way = 0; way < reference; ++way) {
      const Mistakes mistakes = mistakes_of(row[way], row[reference]);
      sheet.mistakes.back()[way] = mistakes;
      const std::string texels = texels_of(mistakes, row[reference]);
      std::array<char, 120> text{};
      if (way % 2 == 0) {
        std::snprintf(text.data(), text.size(), "%-12s%-7s", way == 0 ? exhibit.name : "", way == 0 ? "float" : "double");
        sheet.table += text.data();
      }
      std::snprintf(text.data(), text.size(), "%9d%8d%9s%s", mistakes.wrong, mistakes.missed, texels.c_str(),
                    way % 2 == 0 ? " " : "\n");
      sheet.table += text.data();
      const bool textured = texels != "-";
      const std::string verdict = std::to_string(mistakes.wrong) + " wrong" + (textured ? ", " + texels + " tx" : "");
      const int left = layout.left(i, static_cast<int>(way));
      const int top = layout.top(i) + layout.line;
      const int below = top + layout.panel_height + 2 * layout.scale;
      paste(sheet.picture, row[way].image, left, top);
      draw_text(sheet.picture, left, below, way_names[way], {70, 70, 70}, layout.scale);
      draw_text(sheet.picture, left, below + layout.line, verdict, mistakes.wrong == 0 ? Rgb8{0, 110, 40} : Rgb8{170, 30, 20},
                layout.scale);
    }
  };
  std::apply([&](const auto&... each) { (describe(each), ...); }, exhibits);
  return sheet;
}

/// Draws and saves the sheet, and prints the table.
template <class... Exhibit>
void show_exhibits(const std::tuple<Exhibit...>& exhibits, Studio& studio) {
  if (studio.typed("--number") || studio.typed("--samples") || studio.typed("--formulas")) {
    throw UsageError(
        "--number, --samples and --formulas need --exhibit NAME: the sheet shows float and double, seeds' and robust");
  }
  studio.prefer_size(1680, 1330);
  const Sheet sheet = draw_sheet(exhibits, studio);
  if (!studio.quiet) print(sheet.table);
  studio.save(sheet.picture);
}

}  // namespace texmap::chapter_14
