// The sheet of all exhibits, its table, and the options of one exhibit alone.
#include <algorithm>

#include "engine/compare/difference.hpp"
#include "engine/draw/threads.hpp"
#include "engine/files/sheet.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/session.hpp"
#include "exhibit.hpp"

namespace texmap::chapter_14 {
namespace {

/// As they are drawn on the sheet.
constexpr std::array<const char*, reference> variant_names = {
    "published, float", "robust, float", "published, double", "robust, double"};

std::string names_of(const std::vector<Exhibit>& exhibits) {
  std::string names;
  for (const Exhibit& exhibit : exhibits) names += (names.empty() ? "" : ", ") + exhibit.name;
  return names;
}

Mistakes mistakes_of(const Panel& panel, const Panel& truth) {
  Mistakes mistakes;
  for (std::size_t i = 0; i < truth.points.size(); ++i) {
    const SurfacePoint<Judge>& seen = panel.points[i];
    const SurfacePoint<Judge>& right = truth.points[i];
    // Rounding alone can cost one level when bytes are cut off.
    if (channel_difference(panel.image.pixels[i], truth.image.pixels[i]) > 1) ++mistakes.wrong;
    if (seen.hit != right.hit) ++mistakes.missed;
    if (!seen.mapped || !right.mapped) continue;
    const Judge across = abs(seen.uv.u - right.uv.u);  // u = 0 and u = 1 are one place
    const Judge along_u = min(across, Judge(1) - across) * right.round * Judge(8192);
    const Judge along_v = abs(seen.uv.v - right.uv.v) * Judge(4096);
    mistakes.texels = max(max(along_u, along_v), mistakes.texels);
  }
  return mistakes;
}

using Panels = std::vector<Panel>;  // one for each Variant

constexpr int line_height = 11;  // of text at scale 1

/// Draws an exhibit's caption and pictures on the sheet, and adds its rows to the table. There are
/// two exhibits in a row, four pictures each, between lines of text.
void add_to_sheet(Sheet& sheet, const Exhibit& exhibit, const Panels& panels, int scale, int gap) {
  const int index = static_cast<int>(sheet.mistakes.size());
  sheet.mistakes.emplace_back();
  const Image& panel = panels[reference].image;
  const int line = line_height * scale;
  const int top = gap / 2 + index / 2 * (panel.height + 3 * line + gap);
  const auto& points = panels[reference].points;
  const bool has_texture =
      std::any_of(points.begin(), points.end(), [](const auto& point) { return point.mapped; });
  for (std::size_t variant = 0; variant < reference; ++variant) {
    const Mistakes mistakes = mistakes_of(panels[variant], panels[reference]);
    sheet.mistakes.back()[variant] = mistakes;
    const std::string texels =
        has_texture ? text("%.1e", static_cast<double>(mistakes.texels)) : "-";
    const bool first_of_line = variant % 2 == 0;
    if (first_of_line) {
      sheet.table += text("%-12s%-7s", variant == 0 ? exhibit.name.c_str() : "",
                          variant == 0 ? "float" : "double");
    }
    sheet.table += text("%9d%8d%9s%s", mistakes.wrong, mistakes.missed, texels.c_str(),
                        first_of_line ? " " : "\n");

    const int place = index % 2 * 4 + static_cast<int>(variant);
    const int left = gap / 2 + place * (panel.width + gap);
    SheetColumn column{sheet.picture, left, top, scale, line, 0};
    column.ink = {70, 70, 70};
    column.write(variant == 0 ? exhibit.caption : "", {0, 0, 0});
    column.lay(panels[variant].image);
    column.above = 2 * scale;
    column.write(variant_names[variant]);
    const std::string off = shown(read_decimal(texels).value_or(0)) + " texels off";  // 2000, no e
    column.write(std::to_string(mistakes.wrong) + " wrong" + (has_texture ? ", " + off : ""),
                 mistakes.wrong == 0 ? Rgb8{0, 110, 40} : Rgb8{170, 30, 20});
  }
}

}  // namespace

void ExhibitOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  const Image any_texture(1, 1);
  line.text("--exhibit", "NAME", name,
            "draw this exhibit alone, at 800 x 600 unless you give another size: " +
                names_of(all_exhibits(any_texture, any_texture)));
  line.choice<Formulas>("--formulas", formulas,
                        {{"published", Formulas::published},
                         {"robust", Formulas::robust},
                         {"seeds", Formulas::published}},
                        "with --exhibit: the formulas of the source documents, or the course's "
                        "own; seeds is an old word for published");
  line.choice("--number", number, "float|double|extended",
              "with --exhibit: the number type to calculate with");
  line.whole("--samples", samples, 1, 65536, "with --exhibit: rays per pixel");
}

void ExhibitOptions::apply_to(Chosen& chosen) const {
  if (!name.empty()) {
    chosen.settings.number = number;
    chosen.settings.samples = samples;
    return chosen.default_size(800, 600);
  }
  for (const char* const option : {"--number", "--samples", "--formulas"}) {
    usage_error_if(chosen.was_given(option),
                   "--number, --samples and --formulas need --exhibit NAME: the sheet shows float "
                   "and double, published and robust");
  }
}

Sheet draw_sheet(const std::vector<Exhibit>& exhibits, Session& session) {
  const int count = static_cast<int>(exhibits.size());
  const int width = session.settings.width;
  const int height = session.settings.height;
  const int scale = std::max(1, width / 1640), gap = std::max(1, width / 200);
  const int columns = std::max(1, width / 8 - gap);
  const int rows = std::max(1, height / ((count + 1) / 2) - 3 * line_height * scale - gap);
  std::vector<Panels> panels(exhibits.size(), Panels(variants, Panel(columns, rows)));

  Sheet sheet;
  const double rays = 1.0 * count * int{variants} * columns * rows;
  static_cast<Image&>(sheet.picture) = session.timed(rays, [&](const RenderSettings& settings) {
    for_each_row(count * variants * rows, settings.threads, settings.progress, [&](int job) {
      const auto variant = static_cast<Variant>(job / rows % variants);
      const auto index = static_cast<std::size_t>(job / rows / variants);
      exhibits[index].draw_row(panels[index][variant], variant, job % rows);
    });
    return Image(width, height, {255, 255, 255});
  });
  sheet.table =
      "                         published formulas          the course's\n"
      "exhibit     number     wrong  missed  texels     wrong  missed  texels\n";
  for (std::size_t i = 0; i < exhibits.size(); ++i)
    add_to_sheet(sheet, exhibits[i], panels[i], scale, gap);
  sheet.table += judge_line();
  return sheet;
}

Image draw_exhibit(const std::vector<Exhibit>& exhibits, const std::string& name, Formulas formulas,
                   Session& session) {
  const auto exhibit = std::find_if(exhibits.begin(), exhibits.end(),
                                    [&name](const Exhibit& each) { return each.name == name; });
  usage_error_if(exhibit == exhibits.end(),
                 "--exhibit takes one of " + names_of(exhibits) + ", not '" + name + "'");
  const Settings& chosen = session.settings;
  return session.timed(
      1.0 * chosen.width * chosen.height * chosen.samples, [&](const RenderSettings& settings) {
        return exhibit->draw(formulas, chosen.number, chosen.width, chosen.height, settings);
      });
}

void show_exhibits(const std::vector<Exhibit>& exhibits, const ExhibitOptions& options,
                   Session& session) {
  if (!options.name.empty())
    return session.save(draw_exhibit(exhibits, options.name, options.formulas, session));
  const Sheet sheet = draw_sheet(exhibits, session);
  if (!session.settings.quiet) print(sheet.table);
  session.save(sheet.picture);
}

}  // namespace texmap::chapter_14
