// What is said of the rows: the table, JSON, the plots, and what to take for a budget.
#include <algorithm>
#include <cmath>

#include "12_environment_map/front.hpp"
#include "engine/kernels/kernel_plan.hpp"
#include "engine/measure/json.hpp"
#include "engine/measure/text.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {
namespace {

/// The options that draw chapter 09's scene by a filter: "anisotropic 4" is a filter and its taps.
std::string options_of(const std::string& filter) {
  const std::size_t space = filter.find(' ');
  std::string options = "--filter " + filter.substr(0, space);
  if (space != std::string::npos) options.append(" --taps ").append(filter.substr(space + 1));
  return options;
}

Rows of_sky(const Measurements& all, const std::string& sky) {
  return all.some_of(Part::skies, [&](const Row& row) { return row.sky == sky; });
}
Rows all_of(const Measurements& all, Part part) {
  return all.some_of(part, [](const Row&) { return true; });
}

// The table.

/// The times of a number and a kernel with each set of instructions, as parts of plain double's,
/// and their widest spread.
std::string times_of(std::span<const Row> rows, Variant variant) {
  std::string times;
  double spread = 1;
  for (const Instructions instructions : all_instructions) {
    variant.instructions = instructions;
    const Row* row = find_row(rows, variant);
    times += row == nullptr ? "        -" : text("%9.3f", row->time);
    if (row != nullptr) spread = std::max(spread, row->took.spread);
  }
  return times + text("%5.2f", spread);
}

std::string table_of_places(const Measurements& all, Filter filter) {
  const std::span<const Row> rows = all.of(Part::places);
  std::string table = text(
      "%s, %d x %d pixels, one ray per pixel; time 1 is plain double's %.1f ms with the nearest "
      "texel\n",
      filter == Filter::nearest ? "Nearest texel" : "Bilinear filter", all.width, all.height,
      rows.front().took.processor);
  table += text("%-23s%25s%7s %26s %14s %12s\n", "", "time by instructions", "spread",
                "place off by, texels", "pixels off", "levels off");
  table +=
      text("%-12s %-10s%9s%9s%9s%5s %8s %8s %8s %6s %7s %4s %7s\n", "number", "kernel", "baseline",
           "avx2", "avx512", "", "worst", "mean", "at most", "seen", "at most", "seen", "at most");
  for (const Row& row : rows) {
    const Variant& variant = row.variant;
    if (variant.filter != filter || variant.instructions != Instructions::baseline) continue;
    table += text("%-12s %-10s", name_of(variant.number), name_of_kernel(variant.degree).c_str()) +
             times_of(rows, variant) + errors_text(all, row) + "\n";
  }
  return table + "\n";
}

std::string table_of_light(const Measurements& all, Part part, const std::string& title) {
  std::string table = title + "\n";
  table += text("%-48s%7s %26s %14s %12s\n", "", "spread", "levels off, not rounded", "pixels off",
                "levels off");
  table += text("%-12s %-12s %-6s %-8s %8s%5s %8s %8s %8s %6s %7s %4s %7s\n", "number",
                "instructions", "texels", "curve", "time", "", "worst", "mean", "at most", "seen",
                "at most", "seen", "at most");
  for (const Row& row : all.of(part)) {
    table += text("%-12s %-12s %s %8.3f%5.2f", name_of(row.variant.number),
                  name_of(row.variant.instructions), columns_of_light(row.variant).c_str(),
                  row.time, row.took.spread) +
             errors_text(all, row) + "\n";
  }
  return table + "\n";
}

std::string table_of_noise(const Measurements& all) {
  const std::span<const Row> rows = all.of(Part::samplers);
  const Variant& drawn_with = rows.front().variant;
  std::string table = text(
      "Samples: root mean square error in levels of 255, and milliseconds for %d x %d pixels (%s, "
      "%s)\n        ",
      noise_width, noise_height, name_of(drawn_with.number), name_of(drawn_with.instructions));
  for (const SamplerKind kind : sampler_kinds) table += text("  %-22s", name_of(kind));
  table += "\nsamples ";
  for (std::size_t i = 0; i < sampler_kinds.size(); ++i) table += "   mean at most       ms";
  table += "\n";
  for (const int samples : sample_counts) {
    table += text("%7d ", samples);
    for (const Row& row : rows) {
      if (row.samples == samples)
        table += text(" %7.2f %7.2f %8.2f", row.mean, row.bound, row.took.processor);
    }
    table += "\n";
  }
  return table;
}

/// "+" for what is on a front, else a space.
const char* front_mark(const Rows& rows, const Row& row) {
  const Rows front = pareto_front(rows);
  return std::find(front.begin(), front.end(), &row) == front.end() ? " " : "+";
}

std::string table_of_filters(const Measurements& all) {
  std::string table = text(
      "Filters on checkers to the horizon (chapter 09): errors are root mean squares of light 0 to "
      "1;\ntimes 255 they are levels of light. + is on the front\n%-14s %8s %8s %12s %13s\n",
      "filter", "error", "levels", "texels read", "ns a look-up");
  for (const Row& row : all.of(Part::filters)) {
    table += errors_text(all, row) +
             text(" %12.0f%s\n", row.took.processor, front_mark(all_of(all, Part::filters), row));
  }
  return table;
}

std::string table_of_skies(const Measurements& all) {
  const std::span<const Row> rows = all.of(Part::skies);
  std::string table = text(
      "Ways to light matte objects by three skies (chapter 12), %d x %d pixels: root mean square "
      "error in levels\nof 255, and time on one thread. * is what --light auto takes, + is on the "
      "front\n",
      chapter_12::front_width, chapter_12::front_height);
  table += text("%-24s%27s %29s\n%-9s%-15s", "", "levels off with samples", "microseconds a pixel",
                "sky", "way");
  std::string counts, times;
  for (const Row& row : rows) {
    if (row.name != rows[0].name) break;
    counts += text(" %8d", row.samples);
    times += text(" %8d ", row.samples);
  }
  table += counts + times;
  const Row* before = nullptr;
  for (const Row& row : rows) {
    if (before == nullptr || row.name != before->name || row.sky != before->sky)
      table.append("\n").append(errors_text(all, row));
    table += text(" %8.3g%s", row.took.processor, front_mark(of_sky(all, row.sky), row));
    before = &row;
  }
  return table +
         "\nHow far one direction is off, as a part of its light: what --light auto compares\n" +
         all.choice + "\n";
}

// JSON.

Json json_of(const Row& row) {
  const Variant& v = row.variant;
  const Json spread = row.took.spread;
  if (row.part == Part::samplers) {
    return Json::object({{"sampler", name_of(row.sampler)},
                         {"samples", row.samples},
                         {"rmse", row.mean},
                         {"rmse_bound", row.bound},
                         {"milliseconds", row.took.processor},
                         {"wall_milliseconds", row.took.wall},
                         {"spread", spread}});
  }
  if (row.part == Part::filters) {
    return Json::object({{"name", row.name},
                         {"options", options_of(row.name)},
                         {"error", row.mean},
                         {"own_error", row.own_error},
                         {"levels", row.bound},
                         {"reads", row.reads},
                         {"nanoseconds", row.took.processor},
                         {"spread", spread}});
  }
  if (row.part == Part::skies) {
    return Json::object({{"sky", row.sky},
                         {"way", row.name},
                         {"auto", row.chosen},
                         {"samples", row.samples},
                         {"levels", row.bound},
                         {"microseconds", row.took.processor},
                         {"spread", spread}});
  }
  const bool places = row.part == Part::places;
  return Json::object({{"number", name_of(v.number)},
                       {"instructions", name_of(v.instructions)},
                       {"degree", v.degree},
                       {"filter", name_of(v.filter)},
                       {"curve", name_of(v.curve)},
                       {"texels", name_of(v.format)},
                       {"milliseconds", row.took.processor},
                       {"wall_milliseconds", row.took.wall},
                       {"spread", spread},
                       {"time", row.time},
                       {places ? "worst_texels" : "worst_unrounded", row.worst},
                       {places ? "mean_texels" : "mean_unrounded", row.mean},
                       {places ? "texels_bound" : "unrounded_bound", row.bound},
                       {"changed", row.changed},
                       {"may_change", row.may_change},
                       {"levels", row.levels},
                       {"levels_bound", row.levels_bound}});
}

// Plots.

using PointOf = std::function<PlotPoint(const Row&)>;
using NameOf = std::function<std::string(const Row&)>;

/// Adds points to the series of their names, new ones after the others.
///
/// @param style  of a new series, by how many there are
void add_points(Plot& plot, const Rows& rows, const PointOf& point, const NameOf& name,
                const std::function<int(int)>& style, bool joined = false) {
  for (const Row* row : rows) {
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const PlotSeries& each) { return each.name == name(*row); });
    if (series == plot.series.end()) {
      const int number = static_cast<int>(plot.series.size());
      series = plot.series.insert(series, {name(*row), style(number), {}, joined});
    }
    series->points.push_back(point(*row));
  }
}

/// The front of rows: of neighbors that are as fast only the most exact has a label.
std::vector<PlotPoint> labelled_front(const Rows& rows, const PointOf& point, const NameOf& label) {
  std::vector<PlotPoint> points;
  for (const Row* row : pareto_front(rows)) {
    const PlotPoint next = point(*row);
    if (!points.empty() && next.x < same_time * points.back().x) points.back().label.clear();
    points.push_back({next.x, next.y, label(*row)});
  }
  return points;
}

std::string kernel_or_atan2(const Row& row) {
  return row.variant.degree == 0 ? "atan2" : name_of_kernel(row.variant.degree);
}

/// Every number with some kernels and the nearest texel: its time with its spread, and how far off
/// a place can be at most.
Plot plot_speed_error(const Measurements& all) {
  Plot plot{.title = "The trade: each way to draw the globe, its time and how far off it can be",
            .x_title = text("time of a picture, plain double with atan2 = 1 (%.1f ms); bars end at "
                            "the median",
                            all.of(Part::places).front().took.processor),
            .y_title = "texels off at most; a number is a polynomial's degree"};
  // Of the polynomials some: what lies between them has a time between theirs.
  const Rows shown = all.some_of(Part::places, [](const Row& row) {
    constexpr std::array degrees = {0, 5, 9, 17, 23, 35};
    return row.variant.filter == Filter::nearest &&
           std::find(degrees.begin(), degrees.end(), row.variant.degree) != degrees.end();
  });
  const auto point = [](const Row& row) -> PlotPoint {
    const int degree = row.variant.degree;
    return {row.time, row.bound, degree == 0 ? "atan2" : std::to_string(degree),
            row.time * row.took.spread,
            described_number(row.variant) + ", " + kernel_or_atan2(row)};
  };
  add_points(
      plot, shown, point, [](const Row& row) { return described_number(row.variant); },
      [](int number) { return number % 9; });
  plot.front = labelled_front(shown, point, [](const Row&) { return ""; });
  return plot;
}

/// Every curve and both texel formats: the time, and how far off a channel can be at most, of which
/// the rounding to bytes is half a level.
Plot plot_speed_levels(const Measurements& all) {
  Plot plot{.title = "Speed against error: from texels through light to bytes, one ray a pixel",
            .x_title = "time, plain double with the power = 1",
            .y_title = "a channel is off by at most, in levels of 255, rounding included"};
  const auto point = [](const Row& row) -> PlotPoint {
    const std::string light = described_light(row.variant);
    return {row.time, 0.5 + row.bound, row.variant.number == NumberKind::double_ ? light : "",
            row.time * row.took.spread, described_number(row.variant) + ", " + light};
  };
  const Rows curves = all_of(all, Part::curves);
  add_points(
      plot, curves, point, [](const Row& row) { return described_number(row.variant); },
      [](int number) { return number % 9; });
  plot.front =
      labelled_front(curves, point, [](const Row& row) { return described_light(row.variant); });
  return plot;
}

constexpr std::array sampler_styles = {0, 4, 8, 1};
int sampler_style(int number) { return sampler_styles[static_cast<std::size_t>(number) % 4]; }
std::string sampler_name(const Row& row) { return name_of(row.sampler); }

/// The noise of each sampler against its samples: the mean, and dashed what it does not exceed.
Plot plot_error_samples(const Measurements& all) {
  Plot plot{.title = "Error against samples",
            .x_title = "samples a pixel",
            .y_title = "root mean square error, levels of 255",
            .x_ticks = {sample_counts.begin(), sample_counts.end()}};
  for (const SamplerKind kind : sampler_kinds) {
    PlotSeries mean{name_of(kind), sampler_style(static_cast<int>(kind)), {}, true};
    PlotSeries most{mean.name + ", at most", mean.style, {}, true, true};
    for (const Row& row : all.of(Part::samplers)) {
      if (row.sampler != kind) continue;
      mean.points.push_back({1.0 * row.samples, row.mean, {}});
      most.points.push_back({1.0 * row.samples, row.bound, {}});
    }
    mean.points.back().label = text("%.2f", mean.points.back().y);
    plot.series.insert(plot.series.end(), {mean, most});
  }
  return plot;
}

/// The noise that each sampler does not exceed against the time that it takes.
Plot plot_error_seconds(const Measurements& all) {
  const Rows samplers = all_of(all, Part::samplers);
  const Variant& variant = samplers.front()->variant;
  Plot plot{
      .title = "Error against seconds",
      .x_title = text("seconds for %d x %d pixels, %s, %s, one thread", noise_width, noise_height,
                      described_number(variant).c_str(), name_of_kernel(variant.degree).c_str()),
      .y_title = "root mean square error at most, levels of 255"};
  const auto point = [](const Row& row) -> PlotPoint {
    return {row.took.processor / 1000, row.bound, {}};
  };
  add_points(plot, samplers, point, sampler_name, sampler_style, true);
  plot.front = labelled_front(samplers, point, [](const Row& row) {
    return text("%s %d", name_of(row.sampler), row.samples);
  });
  return plot;
}

PlotPoint point_of(const Row& row) { return {row.took.processor, row.bound, {}}; }

/// Every filter: the time of a look-up, and how many levels of light it is off.
Plot plot_filter_error(const Measurements& all) {
  Plot plot{.title = "Filters: time against error, checkers to the horizon, one ray a pixel",
            .x_title = "time of a look-up in ns, double, one thread",
            .y_title = "root mean square error of light, 255 is white"};
  const Rows filters = all_of(all, Part::filters);
  add_points(
      plot, filters, point_of,
      [](const Row& row) { return row.name.substr(0, row.name.find(' ')); },
      [](int number) { return number; });
  plot.front = labelled_front(filters, point_of, [](const Row& row) { return row.name; });
  return plot;
}

/// Every way with all its samples: the time of a pixel and its error, and the front of each sky.
Plot plot_sky_error(const Measurements& all) {
  Plot plot{.title = "Skies: time against error; a line joins what no other under its sky beats",
            .x_title = "microseconds a pixel, packs of double, one thread",
            .y_title = "root mean square error, levels of 255"};
  constexpr std::array styles = {6, 1, 5};
  std::size_t at = 0;
  for (const std::string& sky : skies_of(all)) {
    const Rows rows = of_sky(all, sky);
    const int style = styles[at++ % styles.size()];
    add_points(
        plot, rows, point_of, [](const Row& row) { return row.sky + " sky"; },
        [style](int) { return style; });
    plot.series.push_back(
        {"", style,
         labelled_front(rows, point_of,
                        [](const Row& row) { return row.name + text(" %d", row.samples); }),
         true});
  }
  return plot;
}

// What to take.

/// How many times as fast: "4.7", or "3.9 to 5.2" where the times spread as on a busy machine.
std::string times_as_fast(const WorkTime& plain, const WorkTime& time) {
  const double ratio = plain.processor / time.processor;
  if (std::max(plain.spread, time.spread) <= quiet_spread) return text("%.1f", ratio);
  return text("%.1f to %.1f", ratio / time.spread, ratio * plain.spread);
}

/// The command that draws chapter 07 with a variant's number and for a budget.
std::string command_of(const Variant& variant, const std::string& budget) {
  std::string command = std::string("./course run 07 --number ") + name_of(variant.number);
  if (is_pack(variant.number) &&
      variant.instructions != usable_instructions(Instructions::avx512).back())
    command += std::string(" --instructions ") + name_of(variant.instructions);
  return command + (budget == "exact" ? "" : " --budget " + budget);
}

std::string recommended_place(const Measurements& all, Filter filter, const Budget& budget,
                              const Image& texture) {
  const Row* row = fastest(all, filter, budget);
  if (row == nullptr) return text("  %-9s nothing that was tried keeps to it\n", name_of(filter));
  const Row* plain = find_row(all.of(Part::places), {.filter = filter});
  std::string lines = text(
      "  %-9s %s: %s times as fast as plain double with this filter\n            at most %.1e "
      "texels off; "
      "pixels that may change: %ld, levels: %d\n",
      name_of(filter),
      (described_number(row->variant) + ", " + name_of_kernel(row->variant.degree)).c_str(),
      times_as_fast(plain->took, row->took).c_str(), row->bound, row->may_change,
      row->levels_bound);
  if (filter != Filter::nearest) return lines;
  const int degree = row->variant.degree;
  lines += "            " + command_of(row->variant, budget_for(degree, texture)) + "\n";
  if (degree > 0) {
    lines +=
        "            (chapter 07's --budget is the polynomial's share alone; rounding adds the "
        "rest of the bound)\n";
  }
  return lines;
}

std::string recommended_light(const Measurements& all, const Budget& budget) {
  const Row* row = fastest_light(all, budget);
  if (row == nullptr) return "  light     nothing that was tried keeps to it\n";
  return text(
      "  light     %s, texels as %s: %s times as fast as plain double\n            at most %.2f "
      "levels off, not rounded; pixels that may change: %ld, levels: %d\n            %s\n"
      "            (float is left out where its places may take the neighboring texel)\n",
      described_number(row->variant).c_str(), described_light(row->variant).c_str(),
      times_as_fast(all.of(Part::curves).front().took, row->took).c_str(), row->bound,
      row->may_change, row->levels_bound, command_of(row->variant, to_text(budget)).c_str());
}

std::string recommended_samples(const Measurements& all, double levels) {
  const Row* row = fastest(all, Part::samplers, levels);
  if (row == nullptr) return "  samples   more than were tried\n";
  const char* kind = name_of(row->sampler);
  return text(
      "  samples   %s, %d a pixel: noise of at most %.2f levels, root mean square\n            "
      "./course run 07 --sampler %s --samples %d\n",
      kind, row->samples, row->bound, kind, row->samples);
}

std::string recommended_filter(const Measurements& all, double levels) {
  const Row* row = fastest(all, Part::filters, levels);
  if (row == nullptr) return "  filter    nothing that was tried keeps to it\n";
  return text(
      "  filter    %s: %.2f levels of light off on checkers to the horizon, root mean square\n"
      "            ./course run 09 %s\n",
      row->name.c_str(), row->bound, options_of(row->name).c_str());
}

std::string recommended_skies(const Measurements& all, double levels) {
  std::string lines;
  for (const std::string& sky : skies_of(all)) {
    const Row* row = fastest(all, Part::skies, levels, sky);
    const std::string start = text("  %-9s ", lines.empty() ? "sky" : "") + sky + ": ";
    if (row == nullptr) {
      lines += start + "nothing that was tried keeps to it\n";
      continue;
    }
    // The sun is in chapter 12's own sky; for another one the user has a picture.
    lines += start + text(
                         "%s, %d samples per pixel: %.2f levels off, root mean square\n"
                         "            ./course run 12%s --light %s --samples %d\n",
                         row->name.c_str(), row->samples, row->bound,
                         sky == "sun" ? "" : " --sky FILE", row->name.c_str(), row->samples);
  }
  return lines;
}

}  // namespace

Machine measuring_machine(Instructions widest) {
  std::vector<std::string> packs;
  for (const Instructions each : usable_instructions(widest)) packs.emplace_back(name_of(each));
  return this_machine(TEXMAP_FLAGS, packs);
}

const char* name_of(Filter filter) { return filter == Filter::nearest ? "nearest" : "bilinear"; }
const char* name_of(TexelFormat format) { return format == TexelFormat::roots ? "roots" : "bytes"; }
const char* name_of(SamplerKind kind) {
  return std::array{"random", "stratified", "multi-jitter",
                    "sobol"}[static_cast<std::size_t>(kind)];
}
const char* name_of(Curve curve) {
  return std::array{"none", "power", "exact", "4 terms",
                    "3 terms"}[static_cast<std::size_t>(curve)];
}
std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}
std::string described_number(const Variant& variant) {
  const std::string number = name_of(variant.number);
  return is_pack(variant.number) ? number + " of " + name_of(variant.instructions) : number;
}
std::string described_light(const Variant& variant) {
  return name_of(variant.format) + std::string(", ") + name_of(variant.curve);
}
std::string columns_of_light(const Variant& variant) {
  return text("%-6s %-8s", name_of(variant.format), name_of(variant.curve));
}

std::vector<std::string> skies_of(const Measurements& all) {
  std::vector<std::string> names;
  for (const Row& row : all.of(Part::skies)) {
    if (names.empty() || names.back() != row.sky) names.push_back(row.sky);
  }
  return names;
}

std::string errors_text(const Measurements& all, const Row& row) {
  if (row.part == Part::filters)
    return text("%-14s %8.4f %8.2f %12.1f", row.name.c_str(), row.mean, row.bound, row.reads);
  if (row.part != Part::skies) {
    return text(" %8.1e %8.1e %8.1e %6ld %7ld %4d %7d", row.worst, row.mean, row.bound, row.changed,
                row.may_change, row.levels, row.levels_bound);
  }
  std::string errors =
      text("%-9s%-15s", row.sky.c_str(), (row.name + (row.chosen ? " *" : "")).c_str());
  for (const Row* one : of_sky(all, row.sky)) {
    if (one->name == row.name) errors += text(" %8.2f", one->bound);
  }
  return errors;
}

std::string skipped_text(const Measurements& all) {
  std::string counts;
  bool skipped = false;
  for (const Rounds& each : all.rounds) {
    counts += text("%s%d of %d", counts.empty() ? "" : ", ", each.timed, each.wanted);
    skipped = skipped || each.timed < each.wanted;
  }
  if (!skipped) return "";
  return "\nThe machine is busy or slow: timing took longer than --seconds allows. Rounds timed: " +
         counts + ".\nFewer rounds make times less sure; errors have no part in it.\n";
}

std::string busy_text(const Measurements& all) {
  long busy = 0;
  double widest = 1;
  for (const Row& row : all.rows) {
    busy += row.took.spread > quiet_spread ? 1 : 0;
    widest = std::max(widest, row.took.spread);
  }
  if (busy == 0) return "";
  return text(
      "\nThis machine was busy: %ld of %zu times spread by more than 10 %% (median over shortest), "
      "the widest by\n%.0f %%. Ways whose times could be equal count as equally fast; of these the "
      "most exact is recommended.\n",
      busy, all.rows.size(), 100 * (widest - 1));
}

std::string table_of(const Measurements& all) {
  return all.machine.text() + "\n\n" + table_of_places(all, Filter::nearest) +
         table_of_places(all, Filter::bilinear) +
         table_of_light(all, Part::curves,
                        "From texels through light to sRGB bytes; time 1 is that of plain double "
                        "with the power") +
         table_of_light(all, Part::formats,
                        text("The same with %d rays per pixel, %d x %d pixels; time 1 is that of "
                             "plain double with bytes",
                             all.of(Part::formats).front().samples, noise_width, noise_height)) +
         table_of_noise(all) + "\n" + table_of_filters(all) + "\n" + table_of_skies(all) +
         judge_line() + skipped_text(all) + busy_text(all);
}

std::string json_of(const Measurements& all) {
  const auto rows = [&all](Part part) {
    return Json::list_of(all.of(part), [](const Row& row) { return json_of(row); });
  };
  return Json::object({{"machine", all.machine.json()},
                       {"width", all.width},
                       {"height", all.height},
                       {"places", rows(Part::places)},
                       {"curves", rows(Part::curves)},
                       {"kept", rows(Part::formats)},
                       {"noise_width", noise_width},
                       {"noise_height", noise_height},
                       {"noise", rows(Part::samplers)},
                       {"filters", rows(Part::filters)},
                       {"skies", rows(Part::skies)}},
                      true)
             .text +
         "\n";
}

std::string budget_for(int degree, const Image& texture) {
  if (degree == 0) return "exact";
  const UvError kernel =
      kernel_bound(degree < 23 ? NumberKind::float_ : NumberKind::double_, degree);
  const double worst = std::max(kernel.u * texture.width, kernel.v * texture.height);
  std::string budget;
  for (int digits = 1; digits <= 17; ++digits) {
    const double unit = std::pow(10.0, std::floor(std::log10(worst)) + 1 - digits);
    budget = text("texels=%.*g", digits, std::ceil(worst / unit) * unit);
    if (choose_uv_kernel(parse_budget(budget), texture.width, texture.height).terms == degree)
      break;
  }
  return budget;
}

std::string recommendation(const Measurements& all, const Budget& budget, const Image& texture) {
  std::string lines = "For " + to_text(budget) + ":\n";
  for (const Filter filter : {Filter::nearest, Filter::bilinear})
    lines += recommended_place(all, filter, budget, texture);
  if (budget.unit != Budget::Unit::levels) return lines;
  return lines + recommended_light(all, budget) + recommended_samples(all, budget.limit) +
         recommended_filter(all, budget.limit) + recommended_skies(all, budget.limit);
}

std::vector<Plot> plots_of(const Measurements& all) {
  return {plot_speed_error(all),   plot_speed_levels(all), plot_error_samples(all),
          plot_error_seconds(all), plot_filter_error(all), plot_sky_error(all)};
}

}  // namespace texmap::chapter_13
