// What is said of the rows: the table, JSON, the plots, and what to take for a budget. All of them
// walk the rows of a part.
#include <algorithm>
#include <cmath>

#include "engine/fast/kernel_plan.hpp"
#include "engine/files/json.hpp"
#include "engine/files/text.hpp"
#include "errors.hpp"
#include "measure.hpp"
#include "report.hpp"

namespace texmap::chapter_13 {
namespace {

// The table.

/// What stands above a part's lines.
std::string heads_of(const Measurements& all, Part part) {
  const Row& first = all.of(part).front();
  if (part == Part::samplers) {
    return text(
        "Samples: root mean square error in levels of 255, and milliseconds for %d x %d pixels "
        "(%s)\nsampler      samples    mean at most       ms\n",
        noise_width, noise_height, number_of(first).c_str());
  }
  const bool is_place = part == Part::places;
  return text(
             "%s, %d x %d pixels, one ray per pixel, packs of %s; time 1 is plain double's %.1f "
             "ms\n",
             is_place ? "The globe's places" : "The globe under a sky", all.width, all.height,
             all.machine.instructions.back().c_str(), first.took.processor) +
         (is_place ? "                                 spread       place off by, texels     "
                     "pixels off   levels off\nnumber       kernel     filter       time     "
                   : "                           spread    levels off, not rounded     pixels off  "
                     " levels off\nnumber       curve          time     ") +
         "    worst     mean  at most   seen at most seen at most\n";
}

/// The command that draws chapter 07 with a row's number, for a budget.
std::string command_of(const Row& row, const std::string& budget) {
  const Variant& variant = row.variant;
  std::string command = "./course run 07 --scene book --number ";
  command.append(name_of(variant.number));
  if (is_pack(variant.number) &&
      variant.instructions != usable_instructions(Instructions::avx512).back())
    command.append(" --instructions ").append(name_of(variant.instructions));
  return budget == "exact" ? command : command + " --budget " + budget;
}

// JSON.

Json json_of(const Row& row, const Image& texture) {
  const Variant& v = row.variant;
  const auto& [processor, wall, spread] = row.took;
  if (row.part == Part::samplers) {
    return Json::object({{"sampler", name_of(row.sampler)},
                         {"samples", row.samples},
                         {"rmse", row.mean},
                         {"rmse_bound", row.bound},
                         {"milliseconds", processor},
                         {"wall_milliseconds", wall},
                         {"spread", spread}});
  }
  const bool is_place = row.part == Part::places;
  const bool by_07 = is_place && v.filter == Filter::nearest;
  return Json::object({{"command", by_07 ? command_of(row, budget_for(v.degree, texture)) : ""},
                       {"number", name_of(v.number)},
                       {"instructions", name_of(v.instructions)},
                       {"degree", v.degree},
                       {"filter", name_of(v.filter)},
                       {"curve", name_of(v.curve)},
                       {"milliseconds", processor},
                       {"wall_milliseconds", wall},
                       {"spread", spread},
                       {"time", row.time},
                       {is_place ? "worst_texels" : "worst_unrounded", row.worst},
                       {is_place ? "mean_texels" : "mean_unrounded", row.mean},
                       {is_place ? "texels_bound" : "unrounded_bound", row.bound},
                       {"changed", row.changed},
                       {"may_change", row.may_change},
                       {"levels", row.levels},
                       {"levels_bound", row.levels_bound}});
}

// Plots.

/// Time across and error up. Of places and curves the time is a part of plain double's, and of
/// curves the rounding to bytes is half a level of the error.
PlotPoint point_of(const Row& row) {
  const double time = row.part == Part::samplers ? row.took.processor : row.time;
  const int degree = row.variant.degree;
  const std::string label = degree == 0 ? "atan2" : std::to_string(degree);
  return {time, row.bound + (row.part == Part::curves ? 0.5 : 0),
          row.part == Part::places ? label : "", time * row.took.spread};
}

/// A plot with rows as points: a series for each number or sampler, and the front with its
/// labels, unless each point has one. Of neighbors on it that are as fast only the most exact has.
Plot with_rows(Plot plot, const Rows& rows) {
  for (const Row* row : rows) {
    const std::string name = row->part == Part::samplers ? name_of(row->sampler) : number_of(*row);
    auto series = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const PlotSeries& each) { return each.name == name; });
    if (series == plot.series.end()) {
      const int style = static_cast<int>(plot.series.size()) % 9;
      series = plot.series.insert(series, {name, style, {}, row->part == Part::samplers});
    }
    series->points.push_back(point_of(*row));
  }
  for (const Row* row : pareto_front(rows)) {
    const PlotPoint next = point_of(*row);
    if (!plot.front.empty() && next.x < same_time * plot.front.back().x)
      plot.front.back().label.clear();
    plot.front.push_back({next.x, next.y, next.label.empty() ? choice_of(*row) : ""});
  }
  return plot;
}

// What to take.

constexpr const char* next_line = "\n            ";

/// How many times as fast: "4.7", or "3.9 to 5.2" where the times spread as on a busy machine.
std::string times_as_fast(const Row& plain, const Row& row) {
  const double ratio = plain.took.processor / row.took.processor;
  if (std::max(plain.took.spread, row.took.spread) <= quiet_spread) return text("%.1f", ratio);
  return text("%.1f to %.1f", ratio / row.took.spread, ratio * plain.took.spread);
}

/// How fast a row of places or curves is and how far off at most, and the command that draws
/// chapter 07 with its number and for a budget.
///
/// @param note  what else is to be known of a budget that is not exact
std::string about_picture(const Measurements& all, const Row& row, const std::string& budget,
                          const char* note) {
  const Variant& variant = row.variant;
  const auto is_alike = [&](const Row& other) { return other.variant.filter == variant.filter; };
  const Row& plain = *all.some_of(row.part, is_alike).front();
  const bool is_place = row.part == Part::places;
  std::string lines = number_of(row) + ", " + choice_of(row) + ": " + times_as_fast(plain, row) +
                      " times as fast as plain double" + (is_place ? " with this filter" : "") +
                      next_line;
  lines += is_place ? text("at most %.1e texels off", row.bound)
                    : text("at most %.2f levels off, not rounded", row.bound);
  lines += text("; pixels that may change: %ld, levels: %d", row.may_change, row.levels_bound);
  if (variant.filter != Filter::nearest) return lines;
  lines.append(next_line).append(command_of(row, budget));
  return budget == "exact" ? lines : lines + next_line + note;
}

}  // namespace

Machine measuring_machine(Instructions widest) {
  std::vector<std::string> packs;
  for (const Instructions each : usable_instructions(widest)) packs.emplace_back(name_of(each));
  return this_machine(TEXMAP_FLAGS, packs);
}

std::string number_of(const Row& row) {
  const std::string number = name_of(row.variant.number);
  return is_pack(row.variant.number) ? number + " of " + name_of(row.variant.instructions) : number;
}

std::string choice_of(const Row& row) {
  if (row.part == Part::places) return name_of_kernel(row.variant.degree);
  return row.part == Part::curves ? name_of(row.variant.curve)
                                  : text("%s %d", name_of(row.sampler), row.samples);
}

std::string names_text(const Row& row) {
  const Variant& variant = row.variant;
  if (row.part == Part::samplers) return text("%-12s %7d", name_of(row.sampler), row.samples);
  return text("%-12s %-10s", name_of(variant.number), choice_of(row).c_str()) +
         (row.part == Part::places ? text(" %-8s", name_of(variant.filter)) : "");
}

std::string errors_text(const Row& row) {
  if (row.part == Part::samplers)
    return text(" %7.2f %7.2f %8.2f", row.mean, row.bound, row.took.processor);
  return text(" %8.1e %8.1e %8.1e %6ld %7ld %4d %7d", row.worst, row.mean, row.bound, row.changed,
              row.may_change, row.levels, row.levels_bound);
}

std::string busy_text(const Measurements& all) {
  std::string lines;
  if (all.skipped > 0) {
    lines = text(
        "\nTiming took longer than --seconds allows, and %d rounds were left out. Errors have no "
        "part in it.\n",
        all.skipped);
  }
  long busy = 0, tried = 0;
  double widest = 1;
  for (const std::vector<Row>& rows : all.parts) {
    for (const Row& row : rows) {
      ++tried;
      busy += row.took.spread > quiet_spread ? 1 : 0;
      widest = std::max(widest, row.took.spread);
    }
  }
  if (busy == 0) return lines;
  return lines +
         text(
             "\nThis machine was busy: %ld of %ld times spread by more than 10 %% (median over "
             "shortest), the widest by\n%.0f %%. Ways whose times could be equal count as equally "
             "fast; of these the most exact is recommended.\n",
             busy, tried, 100 * (widest - 1));
}

std::string table_of(const Measurements& all) {
  std::string tables = all.machine.text() + "\n";
  for (const Part part : all_parts) {
    tables.append("\n").append(heads_of(all, part));
    for (const Row& row : all.of(part)) {
      tables += names_text(row);
      if (part != Part::samplers) tables += text(" %8.3f%5.2f", row.time, row.took.spread);
      tables += errors_text(row) + "\n";
    }
  }
  return tables + judge_line() + busy_text(all);
}

std::string json_of(const Measurements& all, const Image& texture) {
  std::vector<std::pair<const char*, Json>> object = {{"machine", all.machine.json()},
                                                      {"width", all.width},
                                                      {"height", all.height},
                                                      {"noise_width", noise_width},
                                                      {"noise_height", noise_height}};
  constexpr std::array keys = {"places", "curves", "noise"};
  for (const Part part : all_parts) {
    object.emplace_back(
        keys[static_cast<std::size_t>(part)],
        Json::list_of(all.of(part), [&](const Row& row) { return json_of(row, texture); }));
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
  const auto advise = [&lines](const char* purpose, const Row* row, const auto& what) {
    lines += text("  %-9s ", purpose) +
             (row == nullptr ? "nothing that was tried keeps to it" : what(*row)) + "\n";
  };
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    advise(name_of(filter), fastest(all, filter, budget), [&](const Row& row) {
      return about_picture(all, row, budget_for(row.variant.degree, texture),
                           "(chapter 07's --budget is the polynomial's share alone; rounding adds "
                           "the rest of the bound)");
    });
  }
  if (budget.unit != Budget::Unit::levels) return lines;
  advise("light", fastest_light(all, budget), [&](const Row& row) {
    return about_picture(all, row, to_text(budget),
                         "(float is left out where its places may take the neighboring texel)");
  });
  advise("samples",
         fastest(all.some_of(Part::samplers,
                             [&](const Row& row) { return row.bound <= budget.limit; })),
         [](const Row& row) {
           const char* kind = name_of(row.sampler);
           return text(
               "%s, %d a pixel: noise of at most %.2f levels, root mean square%s"
               "./course run 07 --scene book --sampler %s --samples %d",
               kind, row.samples, row.bound, next_line, kind, row.samples);
         });
  return lines;
}

std::vector<Plot> plots_of(const Measurements& all) {
  const Rows places = all.some_of(
      Part::places, [](const Row& row) { return row.variant.filter == Filter::nearest; });
  const auto every = [](const Row& /*row*/) { return true; };
  const Row& sample = all.of(Part::samplers).front();
  return {with_rows({"The trade: each way to draw the globe, its time and how far off it can be",
                     text("time of a picture, plain double with atan2 = 1 (%.1f ms); bars end at "
                          "the median",
                          all.of(Part::places).front().took.processor),
                     "texels off at most; a number is a polynomial's degree"},
                    places),
          with_rows({"Speed against error: from texels through light to bytes, one ray a pixel",
                     "time, plain double with the power = 1",
                     "a channel is off by at most, in levels of 255, rounding included"},
                    all.some_of(Part::curves, every)),
          with_rows({"Samplers: time against error, 1 to 256 samples a pixel",
                     text("milliseconds for %d x %d pixels, %s, %s, one thread", noise_width,
                          noise_height, number_of(sample).c_str(),
                          name_of_kernel(sample.variant.degree).c_str()),
                     "root mean square error at most, levels of 255"},
                    all.some_of(Part::samplers, every))};
}

}  // namespace texmap::chapter_13
