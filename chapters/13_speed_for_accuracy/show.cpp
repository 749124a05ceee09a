// Runs the lesson: says how far it is, prints the tables, and writes plots, figures and the sheet.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "engine/compare/difference.hpp"
#include "engine/draw/develop.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/sheet.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/budget_options.hpp"
#include "engine/run/command_line.hpp"
#include "lesson.hpp"
#include "show.hpp"

namespace texmap::chapter_13 {
namespace {

constexpr Rgb8 black{0, 0, 0};

/// "1 pixel", "2 pixels".
std::string counted(long count, const char* what) {
  return text("%ld %s%s", count, what, count == 1 ? "" : "s");
}

/// Four rows of four pictures, each above three lines of text, and a line above all; filled panel
/// by panel.
struct Sheet {
  const Globe& globe;
  int width, height, threads;
  Tick tick;
  int scale = std::max(1, width / 1640);
  int line = 11 * scale;
  int gap = std::max(1, width / 120);
  int panel_width = std::max(1, width / 4 - gap);
  int panel_height = std::max(1, (height - 2 * line) / 4 - 3 * line - gap);
  View<> view = globe.view(panel_width, panel_height);  ///< of a panel
  SheetImage image{width, height, {255, 255, 255}};
  int panels = 0;

  /// Adds a picture with up to three lines of text.
  void add(const Image& picture, const std::string& name, const std::vector<std::string>& more) {
    const int left = gap / 2 + panels % 4 * (panel_width + gap);
    const int top = 2 * line + gap / 2 + panels / 4 * (panel_height + 3 * line + gap);
    SheetColumn column{image, left, top, scale, line};
    column.ink = {70, 70, 70};
    column.lay(picture);
    column.write(name, black);
    for (const std::string& words : more) column.write(words);
    tick(++panels, 16);
  }
  /// Adds what ways to draw change in a picture.
  void add_differences(std::vector<Row> rows, const Image& reference) {
    find_errors(rows, globe, view, threads, [](int, int) {});
    for (const Row& row : rows) {
      const bool is_place = row.part == Part::places;
      const std::string way =
          is_place && row.variant.degree == 0 ? "reference formula" : choice_of(row);
      const char* seen = row.changed == 1 ? " differs, by " : " differ, by up to ";
      add(differences(picture_of(globe, view, row.variant, threads), reference, is_place ? 1 : 0),
          (is_place ? name_of(row.variant.number) + std::string(", ") : "sRGB by ") + way,
          {row.changed == 0 ? "no pixel differs"
                            : counted(row.changed, "pixel") + seen + counted(row.levels, "level"),
           is_place ? text("%.2g texels off, at most %.2g", row.worst, row.bound)
                    : "at most " + counted(row.levels_bound, "level")});
    }
  }
  /// The picture, and what numbers and kernels change in it.
  void add_places(Filter filter, const std::vector<std::pair<NumberKind, int>>& ways) {
    const Image reference = reference_picture(globe, view, filter);
    const Image& texture = globe.nearest.image;
    add(reference,
        filter == Filter::nearest ? "nearest texel, extended" : "bilinear filter, extended",
        {text("the picture, %d x %d pixels", reference.width, reference.height),
         text("of a texture of %d x %d", texture.width, texture.height)});
    std::vector<Row> rows;
    rows.reserve(ways.size());
    for (const auto& [number, degree] : ways)
      rows.push_back({Part::places, {.number = number, .degree = degree, .filter = filter}});
    add_differences(rows, reference);
  }
  /// The picture under the sky, and what shorter curves change in it.
  void add_curves() {
    const Image reference = picture_of(globe, view, {.curve = Curve::exact}, threads);
    add(reference, "under the sky's light, sRGB exact", {"one ray a pixel"});
    add_differences(
        {{Part::curves, {.curve = Curve::four}}, {Part::curves, {.curve = Curve::three}}},
        reference);
  }
  /// The picture that all samplers converge to, and how far off 16 samples are.
  void add_samplers() {
    const Variant variant{.number = NumberKind::double_pack};
    const auto drawn = [&](const Sampler& sampler) {
      return sampled(globe, view, variant, sampler, threads);
    };
    const Film converged = drawn(Sampler(SamplerKind::sobol, 256, 1));
    const Image smooth = develop(converged, Transfer::srgb);
    add(smooth, "sobol, 256 rays a pixel", {"what all samplers go to"});
    for (const SamplerKind kind : sampler_kinds) {
      const Film film = drawn(Sampler(kind, 16));
      const double off = rms_difference(levels_of(film), levels_of(converged));
      add(differences(develop(film, Transfer::srgb), smooth, 0),
          std::string(name_of(kind)) + ", 16 rays a pixel",
          {text("%.2f levels off, root mean square", off)});
    }
  }
  /// Writes above all panels what the colors mean.
  void add_legend() {
    SheetColumn column{image, gap / 2, line / 2, scale, line, 0};
    const auto write = [&](const std::string& words) {
      column.write(words, black);
      column.left += text_width(words, column.size) + line;
      column.top = line / 2;
    };
    write(
        "Differences in levels of 255; in the upper two rows a changed pixel is drawn three wide:");
    for (const int levels : {0, 1, 2, 4, 8, 16, 32, 64, 128, 255}) {
      column.lay(Image(line, 8 * scale, difference_color(levels)));
      column.left += line + 4 * scale;
      column.top = line / 2;
      write(std::to_string(levels));
    }
  }
};

/// How far a run is.
struct Phases {
  /// What each phase takes of the time, about: three of errors and times each, and the sheet.
  std::array<int, 7> percents = {10, 5, 45, 10, 15, 10, 5};
  std::size_t phase = 0;
  int before = 0;  ///< percent

  void told(const RenderSettings& settings, int done, int total) {
    if (settings.progress) settings.progress(before + percents[phase] * done / total, 100);
    if (done < total || phase + 1 == percents.size()) return;
    before += percents[phase++];
  }
};

}  // namespace

SheetImage draw_sheet(const Globe& globe, int width, int height, int threads, const Tick& tick) {
  using enum NumberKind;
  Sheet sheet{globe, width, height, threads, tick};
  sheet.add_places(Filter::nearest, {{float_, 0}, {float_, 5}, {float_, 9}});
  sheet.add_places(Filter::bilinear, {{float_, 5}, {float_, 9}, {double_, 23}});
  sheet.add_curves();
  sheet.add_samplers();
  sheet.add_legend();
  return sheet.image;
}

View<> view_of_sheet(const Globe& globe, int width, int height) {
  return Sheet{globe, width, height, 0, {}}.view;
}

std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out) {
  if (is_stream(out)) return {};
  std::vector<std::filesystem::path> names;
  for (const char* const ending :
       {"_speed_error.svg", "_speed_levels.svg", "_error_seconds.svg", ".json"})
    names.push_back(std::filesystem::path(out).replace_extension() += ending);
  return names;
}

void TradeOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.text("--budget", "BUDGET", budget,
            "also recommend a way for this allowed error: exact, texels=0.001 or levels=2");
  line.choice("--instructions", widest, "baseline|avx2|avx512",
              "the widest vector instructions that packs may use");
  line.whole("--rounds", rounds, 1, 10000,
             "how often to time each variant; the shortest time counts");
  line.whole("--seconds", seconds, 1, 1000000,
             "after so many seconds of timing, skip every round beyond the fifth");
}

void Lesson::draw_all(Session& session) {
  session.chosen.settings.instructions = trade.widest;
  session.chosen.check();
  const Settings& settings = session.settings;
  std::vector<Budget> budgets = {read_budget("exact"), read_budget("texels=0.01"),
                                 read_budget("levels=1")};
  const Budget own = read_budget(trade.budget.empty() ? "exact" : trade.budget);
  const auto is_own = [&](const Budget& each) { return to_text(each) == to_text(own); };
  if (std::none_of(budgets.begin(), budgets.end(), is_own)) budgets.push_back(own);
  const std::vector<std::filesystem::path> report = names_of_report(path_of(settings.out));
  for (const std::filesystem::path& file : report) {
    usage_error_if(file == path_of(settings.out),
                   "--out must not end in .json: that file gets what was measured");
    check_output(file);  // before anything long
  }
  const Globe globe(texture.load());
  const View<> view = view_of_sheet(globe, settings.width, settings.height);

  Measurements all;
  Phases phases;
  const Image sheet = session.timed(0, [&](const RenderSettings& render) {
    const Tick tick = [&](int done, int total) { phases.told(render, done, total); };
    all = measure(globe, view, render.threads, tick);
    return draw_sheet(globe, settings.width, settings.height, render.threads, tick);
  });

  session.count_rays(all.rays);

  if (!report.empty()) {
    std::vector<std::string> contents;
    for (const Plot& plot : plots_of(all)) contents.push_back(svg_of(plot));
    contents.push_back(json_of(all, globe.nearest.image));
    for (std::size_t i = 0; i < report.size(); ++i)
      with_name("cannot write", report[i], [&] { write_text_atomically(report[i], contents[i]); });
  }
  if (!settings.quiet) {
    std::string lines;
    if (!report.empty()) {
      lines =
          "Look first at the trade, time across and error up: " + texmap::name_of(report.front()) +
          "\n\n";
    }
    lines += table_of(all) + "\n";
    for (const Budget& each : budgets) lines += recommendation(all, each, globe.nearest.image);
    print(lines);
  }
  session.save(sheet);
}

}  // namespace texmap::chapter_13
