// What is said of the rows: the table, JSON, the plots, and what to take for a budget. All of them
// walk the rows of a part.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "12_environment_map/front.hpp"
#include "engine/kernels/kernel_plan.hpp"
#include "engine/measure/json.hpp"
#include "engine/measure/text.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {
namespace {

using TextOf = std::function<std::string(const Row&)>;
using PointOf = std::function<PlotPoint(const Row&)>;

/// The options that draw chapter 09's scene by a filter: "anisotropic 4" is a filter and its taps.
std::string options_of(const Row& row) {
  const std::size_t space = row.name.find(' ');
  std::string options = "--filter " + row.name.substr(0, space);
  if (space != std::string::npos) options.append(" --taps ").append(row.name.substr(space + 1));
  return options;
}

Rows of_sky(const Measurements& all, const std::string& sky) {
  return all.some_of(Part::skies, [&](const Row& row) { return row.sky == sky; });
}
/// One way under one sky, with all its samples.
Rows of_way(const Measurements& all, const Row& way) {
  return all.some_of(Part::skies,
                     [&](const Row& row) { return row.sky == way.sky && row.name == way.name; });
}

std::string number_of(const Row& row) { return described_number(row.variant); }
std::string light_of(const Row& row) { return described_light(row.variant); }
std::string sampler_of(const Row& row) { return name_of(row.sampler); }

// The table.

constexpr const char* errors_head = "    worst     mean  at most   seen at most seen at most\n";

/// A title and heads, and the lines of a part's rows.
std::string table(const Measurements& all, Part part, std::string head, const TextOf& line) {
  for (const Row& row : all.of(part)) head += line(row);
  return head;
}

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
  const std::string title = text(
      "%s, %d x %d pixels, one ray per pixel; time 1 is plain double's %.1f ms with the nearest "
      "texel\n",
      filter == Filter::nearest ? "Nearest texel" : "Bilinear filter", all.width, all.height,
      rows.front().took.processor);
  const std::string heads =
      "                            time by instructions spread       place off by, texels     "
      "pixels off   levels off\n"
      "number       kernel     baseline     avx2   avx512     ";
  return table(all, Part::places, title + heads + errors_head, [&](const Row& row) -> std::string {
    const Variant& variant = row.variant;
    if (variant.filter != filter || variant.instructions != Instructions::baseline) return "";
    return text("%-12s %-10s", name_of(variant.number), name_of_kernel(variant.degree).c_str()) +
           times_of(rows, variant) + errors_text(all, row) + "\n";
  });
}

std::string table_of_light(const Measurements& all, Part part, const std::string& title) {
  const std::string heads =
      "\n                                                 spread    levels off, not rounded     "
      "pixels off   levels off\n"
      "number       instructions texels curve        time     ";
  return table(all, part, title + heads + errors_head, [&](const Row& row) {
    return text("%-12s %-12s %s %8.3f%5.2f", name_of(row.variant.number),
                name_of(row.variant.instructions), columns_of_light(row.variant).c_str(), row.time,
                row.took.spread) +
           errors_text(all, row) + "\n";
  });
}

std::string table_of_noise(const Measurements& all) {
  const Variant& drawn_with = all.of(Part::samplers).front().variant;
  std::string lines = text(
      "Samples: root mean square error in levels of 255, and milliseconds for %d x %d pixels (%s, "
      "%s)\n        ",
      noise_width, noise_height, name_of(drawn_with.number), name_of(drawn_with.instructions));
  for (const SamplerKind kind : sampler_kinds) lines += text("  %-22s", name_of(kind));
  lines += "\nsamples ";
  for (std::size_t i = 0; i < sampler_kinds.size(); ++i) lines += "   mean at most       ms";
  for (const int samples : sample_counts) {
    lines += text("\n%7d ", samples);
    lines = table(all, Part::samplers, lines, [&](const Row& row) {
      if (row.samples != samples) return std::string();
      return text(" %7.2f %7.2f %8.2f", row.mean, row.bound, row.took.processor);
    });
  }
  return lines + "\n";
}

/// "+" for what is on a front, else a space.
const char* front_mark(const Rows& rows, const Row& row) {
  const Rows front = pareto_front(rows);
  return std::find(front.begin(), front.end(), &row) == front.end() ? " " : "+";
}

std::string table_of_filters(const Measurements& all) {
  return table(
      all, Part::filters,
      "Filters on checkers to the horizon (chapter 09): errors are root mean squares of light 0 to "
      "1;\ntimes 255 they are levels of light. + is on the front\n"
      "filter            error   levels  texels read  ns a look-up\n",
      [&](const Row& row) {
        return errors_text(all, row) +
               text(" %12.0f%s\n", row.took.processor, front_mark(all.some_of(Part::filters), row));
      });
}

std::string table_of_skies(const Measurements& all) {
  std::string counts, times;
  for (const Row* row : of_way(all, all.of(Part::skies).front())) {
    counts += text(" %8d", row->samples);
    times += text(" %8d ", row->samples);
  }
  const std::string head =
      text(
          "Ways to light matte objects by three skies (chapter 12), %d x %d pixels: root mean "
          "square error in levels\nof 255, and time on one thread. * is what --light auto takes, "
          "+ is on the front\n",
          chapter_12::front_width, chapter_12::front_height) +
      "                            levels off with samples          microseconds a pixel\n"
      "sky      way            " +
      counts + times + "\n";
  return table(all, Part::skies, head, [&](const Row& first) {
    const Rows way = of_way(all, first);
    if (way.front() != &first) return std::string();
    std::string line = errors_text(all, first);
    for (const Row* row : way)
      line += text(" %8.3g%s", row->took.processor, front_mark(of_sky(all, row->sky), *row));
    return line + "\n";
  });
}

// JSON.

/// An object of values under names, which are words.
Json named(const std::string& names, const std::vector<Json>& values) {
  std::istringstream words(names);
  Json object = nullptr;
  object.text = "{";
  for (const Json& value : values) {
    std::string name;
    words >> name;
    object.text += (object.text == "{" ? "" : ", ") + Json(name).text + ": " + value.text;
  }
  object.text += "}";
  return object;
}

Json json_of(const Row& row) {
  const Variant& v = row.variant;
  const auto& [processor, wall, spread] = row.took;
  if (row.part == Part::samplers) {
    return named("sampler samples rmse rmse_bound milliseconds wall_milliseconds spread",
                 {name_of(row.sampler), row.samples, row.mean, row.bound, processor, wall, spread});
  }
  if (row.part == Part::filters) {
    return named("name options error own_error levels reads nanoseconds spread",
                 {row.name, options_of(row), row.mean, row.own_error, row.bound, row.reads,
                  processor, spread});
  }
  if (row.part == Part::skies) {
    return named("sky way auto samples levels microseconds spread",
                 {row.sky, row.name, row.chosen, row.samples, row.bound, processor, spread});
  }
  const std::string errors = row.part == Part::places
                                 ? "worst_texels mean_texels texels_bound"
                                 : "worst_unrounded mean_unrounded unrounded_bound";
  return named(
      "number instructions degree filter curve texels milliseconds wall_milliseconds "
      "spread time " +
          errors + " changed may_change levels levels_bound",
      {name_of(v.number), name_of(v.instructions), v.degree, name_of(v.filter), name_of(v.curve),
       name_of(v.format), processor, wall, spread, row.time, row.worst, row.mean, row.bound,
       row.changed, row.may_change, row.levels, row.levels_bound});
}

// Plots.

const std::vector<int> all_styles = {0, 1, 2, 3, 4, 5, 6, 7, 8};

/// A plot with rows as points: a series for each name, in styles one after the other, and the front
/// with its labels. Of neighbors on it that are as fast only the most exact has one.
Plot with_rows(Plot plot, const Rows& rows, const PointOf& point, const TextOf& name,
               const TextOf& label, const std::vector<int>& styles = all_styles,
               bool joined = false) {
  for (const Row* row : rows) {
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const PlotSeries& each) { return each.name == name(*row); });
    if (series == plot.series.end()) {
      const int style = styles[plot.series.size() % styles.size()];
      series = plot.series.insert(series, {name(*row), style, {}, joined});
    }
    series->points.push_back(point(*row));
  }
  for (const Row* row : pareto_front(rows)) {
    const PlotPoint next = point(*row);
    if (!plot.front.empty() && next.x < same_time * plot.front.back().x)
      plot.front.back().label.clear();
    plot.front.push_back({next.x, next.y, label(*row)});
  }
  return plot;
}

PlotPoint time_and_bound(const Row& row) { return {row.took.processor, row.bound, {}}; }
std::string way_and_samples(const Row& row) {
  return (row.part == Part::samplers ? name_of(row.sampler) : row.name) + text(" %d", row.samples);
}

/// Every number with some kernels and the nearest texel: its time with its spread, and how far off
/// a place can be at most.
Plot plot_speed_error(const Measurements& all) {
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
            number_of(row) + ", " + (degree == 0 ? "atan2" : name_of_kernel(degree))};
  };
  return with_rows({"The trade: each way to draw the globe, its time and how far off it can be",
                    text("time of a picture, plain double with atan2 = 1 (%.1f ms); bars end at "
                         "the median",
                         all.of(Part::places).front().took.processor),
                    "texels off at most; a number is a polynomial's degree"},
                   shown, point, number_of, [](const Row&) { return ""; });
}

/// Every curve and both texel formats: the time, and how far off a channel can be at most, of which
/// the rounding to bytes is half a level.
Plot plot_speed_levels(const Measurements& all) {
  const auto point = [](const Row& row) -> PlotPoint {
    return {row.time, 0.5 + row.bound,
            row.variant.number == NumberKind::double_ ? light_of(row) : "",
            row.time * row.took.spread, number_of(row) + ", " + light_of(row)};
  };
  return with_rows({"Speed against error: from texels through light to bytes, one ray a pixel",
                    "time, plain double with the power = 1",
                    "a channel is off by at most, in levels of 255, rounding included"},
                   all.some_of(Part::curves), point, number_of, light_of);
}

/// The noise of each sampler: against its samples the mean, and dashed what it does not exceed;
/// and what it does not exceed against the time that it takes.
std::array<Plot, 2> plots_of_samplers(const Measurements& all) {
  Plot samples{.title = "Error against samples",
               .x_title = "samples a pixel",
               .y_title = "root mean square error, levels of 255",
               .x_ticks = {sample_counts.begin(), sample_counts.end()}};
  const std::vector<int> styles = {0, 4, 8, 1};
  for (std::size_t i = 0; i < sampler_kinds.size(); ++i) {
    PlotSeries mean{name_of(sampler_kinds[i]), styles[i], {}, true};
    PlotSeries most{mean.name + ", at most", mean.style, {}, true, true};
    for (const Row& row : all.of(Part::samplers)) {
      if (row.sampler != sampler_kinds[i]) continue;
      mean.points.push_back({1.0 * row.samples, row.mean, {}});
      most.points.push_back({1.0 * row.samples, row.bound, {}});
    }
    mean.points.back().label = text("%.2f", mean.points.back().y);
    samples.series.insert(samples.series.end(), {mean, most});
  }
  const Variant& variant = all.of(Part::samplers).front().variant;
  const std::string x_title =
      text("seconds for %d x %d pixels, %s, %s, one thread", noise_width, noise_height,
           described_number(variant).c_str(), name_of_kernel(variant.degree).c_str());
  const auto point = [](const Row& row) -> PlotPoint {
    return {row.took.processor / 1000, row.bound, {}};
  };
  return {
      samples,
      with_rows({"Error against seconds", x_title, "root mean square error at most, levels of 255"},
                all.some_of(Part::samplers), point, sampler_of, way_and_samples, styles, true)};
}

/// Every filter: the time of a look-up, and how many levels of light it is off.
Plot plot_filter_error(const Measurements& all) {
  return with_rows(
      {"Filters: time against error, checkers to the horizon, one ray a pixel",
       "time of a look-up in ns, double, one thread",
       "root mean square error of light, 255 is white"},
      all.some_of(Part::filters), time_and_bound,
      [](const Row& row) { return row.name.substr(0, row.name.find(' ')); }, &Row::name);
}

/// Every way with all its samples: the time of a pixel and its error, and the front of each sky.
Plot plot_sky_error(const Measurements& all) {
  Plot plot{"Skies: time against error; a line joins what no other under its sky beats",
            "microseconds a pixel, packs of double, one thread",
            "root mean square error, levels of 255"};
  for (const std::string& sky : skies_of(all)) {
    plot = with_rows(plot, of_sky(all, sky), time_and_bound,
                     [](const Row& row) { return row.sky + " sky"; }, way_and_samples,
                     {6, 6, 1, 1, 5, 5});  // a sky has two series
    plot.series.push_back({"", plot.series.back().style, std::move(plot.front), true});
    plot.front.clear();
  }
  return plot;
}

// What to take.

constexpr const char* next_line = "\n            ";
constexpr const char* nothing = "nothing that was tried keeps to it";

/// What to take for a purpose: some lines about a row, or one where there is none.
std::string advice(const char* purpose, const Row* row, const TextOf& what,
                   const std::string& none = nothing) {
  return text("  %-9s ", purpose) + (row == nullptr ? none : what(*row)) + "\n";
}

/// How many times as fast: "4.7", or "3.9 to 5.2" where the times spread as on a busy machine.
std::string times_as_fast(const Row& plain, const Row& row) {
  const double ratio = plain.took.processor / row.took.processor;
  if (std::max(plain.took.spread, row.took.spread) <= quiet_spread) return text("%.1f", ratio);
  return text("%.1f to %.1f", ratio / row.took.spread, ratio * plain.took.spread);
}

std::string pixels_that_may_change(const Row& row) {
  return text("; pixels that may change: %ld, levels: %d", row.may_change, row.levels_bound);
}

/// The command that draws chapter 07 with a variant's number and for a budget.
std::string command_of(const Variant& variant, const std::string& budget) {
  std::string command = std::string(next_line) + "./course run 07 --number ";
  command += name_of(variant.number);
  if (is_pack(variant.number) &&
      variant.instructions != usable_instructions(Instructions::avx512).back())
    command += std::string(" --instructions ") + name_of(variant.instructions);
  return command + (budget == "exact" ? "" : " --budget " + budget);
}

std::string about_place(const Measurements& all, const Row& row, const Image& texture) {
  const Variant& variant = row.variant;
  const Row* plain = find_row(all.of(Part::places), {.filter = variant.filter});
  std::string lines = number_of(row) + ", " + name_of_kernel(variant.degree) + ": " +
                      times_as_fast(*plain, row) +
                      " times as fast as plain double with this filter" + next_line +
                      text("at most %.1e texels off", row.bound) + pixels_that_may_change(row);
  if (variant.filter != Filter::nearest) return lines;
  lines += command_of(variant, budget_for(variant.degree, texture));
  if (variant.degree == 0) return lines;
  return lines + next_line +
         "(chapter 07's --budget is the polynomial's share alone; rounding adds the rest of the "
         "bound)";
}

std::string about_light(const Measurements& all, const Row& row, const Budget& budget) {
  return number_of(row) + ", texels as " + light_of(row) + ": " +
         times_as_fast(all.of(Part::curves).front(), row) + " times as fast as plain double" +
         next_line + text("at most %.2f levels off, not rounded", row.bound) +
         pixels_that_may_change(row) + command_of(row.variant, to_text(budget)) + next_line +
         "(float is left out where its places may take the neighboring texel)";
}

}  // namespace

Machine measuring_machine(Instructions widest) {
  std::vector<std::string> packs;
  for (const Instructions each : usable_instructions(widest)) packs.emplace_back(name_of(each));
  return this_machine(TEXMAP_FLAGS, packs);
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
  for (const Row* one : of_way(all, row)) errors += text(" %8.2f", one->bound);
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
  const std::string light =
      "From texels through light to sRGB bytes; time 1 is that of plain double with the power";
  const std::string many_rays = text(
      "The same with %d rays per pixel, %d x %d pixels; time 1 is that of plain double with "
      "bytes",
      all.of(Part::formats).front().samples, noise_width, noise_height);
  std::string tables = all.machine.text() + "\n";
  for (const std::string& each :
       {table_of_places(all, Filter::nearest), table_of_places(all, Filter::bilinear),
        table_of_light(all, Part::curves, light), table_of_light(all, Part::formats, many_rays),
        table_of_noise(all), table_of_filters(all), table_of_skies(all)})
    tables += "\n" + each;
  return tables +
         "How far one direction is off, as a part of its light: what --light auto compares\n" +
         all.choice + "\n" + judge_line() + skipped_text(all) + busy_text(all);
}

std::string json_of(const Measurements& all) {
  std::vector<std::pair<const char*, Json>> object = {
      {"machine", all.machine.json()}, {"width", all.width}, {"height", all.height}};
  for (const auto& [part, key] : {std::pair{Part::places, "places"},
                                  {Part::curves, "curves"},
                                  {Part::formats, "kept"},
                                  {Part::samplers, "noise"},
                                  {Part::filters, "filters"},
                                  {Part::skies, "skies"}}) {
    if (part == Part::samplers)
      object.insert(object.end(), {{"noise_width", noise_width}, {"noise_height", noise_height}});
    object.emplace_back(key,
                        Json::list_of(all.of(part), [](const Row& row) { return json_of(row); }));
  }
  return Json::object(object, true).text + "\n";
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
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    lines += advice(name_of(filter), fastest(all, filter, budget),
                    [&](const Row& row) { return about_place(all, row, texture); });
  }
  if (budget.unit != Budget::Unit::levels) return lines;
  lines += advice("light", fastest_light(all, budget),
                  [&](const Row& row) { return about_light(all, row, budget); });
  const auto about_samples = [](const Row& row) {
    const char* kind = name_of(row.sampler);
    return text(
        "%s, %d a pixel: noise of at most %.2f levels, root mean square%s"
        "./course run 07 --sampler %s --samples %d",
        kind, row.samples, row.bound, next_line, kind, row.samples);
  };
  const auto about_filter = [](const Row& row) {
    return text(
        "%s: %.2f levels of light off on checkers to the horizon, root mean square%s"
        "./course run 09 %s",
        row.name.c_str(), row.bound, next_line, options_of(row).c_str());
  };
  const auto about_sky = [](const Row& row) {
    // The sun is in chapter 12's own sky; for another one the user has a picture.
    const char* file = row.sky == "sun" ? "" : " --sky FILE";
    return text(
        "%s: %s, %d samples per pixel: %.2f levels off, root mean square%s"
        "./course run 12%s --light %s --samples %d",
        row.sky.c_str(), row.name.c_str(), row.samples, row.bound, next_line, file,
        row.name.c_str(), row.samples);
  };
  lines += advice("samples", fastest(all, Part::samplers, budget.limit), about_samples,
                  "more than were tried");
  lines += advice("filter", fastest(all, Part::filters, budget.limit), about_filter);
  const char* purpose = "sky";
  for (const std::string& sky : skies_of(all)) {
    lines += advice(purpose, fastest(all, Part::skies, budget.limit, sky), about_sky,
                    sky + ": " + nothing);
    purpose = "";
  }
  return lines;
}

std::vector<Plot> plots_of(const Measurements& all) {
  const auto [error_samples, error_seconds] = plots_of_samplers(all);
  return {plot_speed_error(all), plot_speed_levels(all), error_samples,
          error_seconds,         plot_filter_error(all), plot_sky_error(all)};
}

}  // namespace texmap::chapter_13
