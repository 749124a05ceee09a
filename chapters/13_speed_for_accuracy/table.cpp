// The table: all that was tried, as text to read and as JSON for other programs.
#include "table.hpp"

#include <algorithm>

#include "engine/measure/json.hpp"
#include "engine/measure/text.hpp"
#include "plots.hpp"

namespace texmap::chapter_13 {
namespace {

/// The times of a number and a kernel with each set of instructions, as parts of plain double's,
/// and their widest spread.
std::string times_of(const std::vector<Trial>& trials, Variant variant) {
  std::string times;
  double spread = 1;
  for (const Instructions instructions :
       {Instructions::baseline, Instructions::avx2, Instructions::avx512}) {
    variant.instructions = instructions;
    const Trial* trial = find_trial(trials, variant);
    times += trial == nullptr ? "        -" : text("%9.3f", trial->time);
    if (trial != nullptr) spread = std::max(spread, trial->took.spread);
  }
  return times + text("%5.2f", spread);
}

std::string table_of_places(const Measurements& all, Filter filter) {
  std::string table = text(
      "%s, %d x %d pixels, one ray per pixel; time 1 is plain double's %.1f ms with the nearest "
      "texel\n",
      filter == Filter::nearest ? "Nearest texel" : "Bilinear filter", all.width, all.height,
      all.places.front().took.processor);
  table += text("%-23s%25s%7s %26s %14s %12s\n", "", "time by instructions", "spread",
                "place off by, texels", "pixels off", "levels off");
  table +=
      text("%-12s %-10s%9s%9s%9s%5s %8s %8s %8s %6s %7s %4s %7s\n", "number", "kernel", "baseline",
           "avx2", "avx512", "", "worst", "mean", "at most", "seen", "at most", "seen", "at most");
  for (const Trial& trial : all.places) {
    const Variant& variant = trial.variant;
    if (variant.filter != filter || variant.instructions != Instructions::baseline) continue;
    table += text("%-12s %-10s", name_of(variant.number), name_of_kernel(variant.degree).c_str()) +
             times_of(all.places, variant) + errors_text(trial) + "\n";
  }
  return table + "\n";
}

std::string table_of_light(const std::vector<Trial>& trials, const std::string& title) {
  std::string table = title + "\n";
  table += text("%-48s%7s %26s %14s %12s\n", "", "spread", "levels off, not rounded", "pixels off",
                "levels off");
  table += text("%-12s %-12s %-6s %-8s %8s%5s %8s %8s %8s %6s %7s %4s %7s\n", "number",
                "instructions", "texels", "curve", "time", "", "worst", "mean", "at most", "seen",
                "at most", "seen", "at most");
  for (const Trial& trial : trials) {
    table += text("%-12s %-12s %s %8.3f%5.2f", name_of(trial.variant.number),
                  name_of(trial.variant.instructions), columns_of_light(trial.variant).c_str(),
                  trial.time, trial.took.spread) +
             errors_text(trial) + "\n";
  }
  return table + "\n";
}

std::string table_of_noise(const Measurements& all) {
  std::string table = text(
      "Samples: root mean square error in levels of 255, and milliseconds for %d x %d pixels (%s, "
      "%s)\n        ",
      noise_width, noise_height, name_of(all.exact.number), name_of(all.exact.instructions));
  for (const SamplerKind kind : sampler_kinds) table += text("  %-22s", name_of(kind));
  table += "\nsamples ";
  for (std::size_t i = 0; i < sampler_kinds.size(); ++i) table += "   mean at most       ms";
  table += "\n";
  for (const int samples : sample_counts) {
    table += text("%7d ", samples);
    for (const Noise& noise : all.noise) {
      if (noise.samples == samples)
        table += text(" %7.2f %7.2f %8.2f", noise.rmse, noise.rmse_bound, noise.took.processor);
    }
    table += "\n";
  }
  return table;
}

/// "+" for what is on a front, else a space.
const char* front_mark(const std::vector<Tradeoff>& front, std::size_t index) {
  const bool on_it = std::any_of(front.begin(), front.end(),
                                 [index](const Tradeoff& each) { return each.index == index; });
  return on_it ? "+" : " ";
}

std::string table_of_filters(const Fronts& fronts) {
  std::string table = text(
      "Filters on checkers to the horizon (chapter 09): errors are root mean squares of light 0 to "
      "1;\ntimes 255 they are levels of light. + is on the front\n%-14s %8s %8s %12s %13s\n",
      "filter", "error", "levels", "texels read", "ns a look-up");
  const std::vector<Tradeoff> front = front_of_filters(fronts);
  for (std::size_t i = 0; i < fronts.filters.size(); ++i) {
    table += errors_text(fronts.filters[i]) +
             text(" %12.0f%s\n", fronts.filters[i].nanoseconds, front_mark(front, i));
  }
  return table;
}

std::string table_of_skies(const Fronts& fronts) {
  std::string table = text(
      "Ways to light matte objects by three skies (chapter 12), %d x %d pixels: root mean square "
      "error in levels\nof 255, and time on one thread. * is what --light auto takes, + is on the "
      "front\n",
      chapter_12::front_width, chapter_12::front_height);
  table += text("%-24s%27s %29s\n%-9s%-15s", "", "levels off with samples", "microseconds a pixel",
                "sky", "way");
  std::string row, times;
  for (std::size_t i = 0; i < fronts.skies.size(); ++i) {
    const SkyCost& one = fronts.skies[i];
    if (i > 0 && one.way != fronts.skies[0].way) break;
    row += text(" %8d", one.samples);
    times += text(" %8d ", one.samples);
  }
  table += row + times;
  for (std::size_t i = 0; i < fronts.skies.size(); ++i) {
    const SkyCost& one = fronts.skies[i];
    if (i == 0 || one.way != fronts.skies[i - 1].way || one.sky != fronts.skies[i - 1].sky)
      table.append("\n").append(errors_text(fronts, one.sky, one.way));
    table += text(" %8.3g%s", one.microseconds, front_mark(front_of_sky(fronts, one.sky), i));
  }
  return table +
         "\nHow far one direction is off, as a part of its light: what --light auto compares\n" +
         fronts.choice + "\n";
}

Json json_of(const Trial& trial) {
  const Variant& v = trial.variant;
  const Errors& e = trial.errors;
  const bool places = v.curve == Curve::none;
  return Json::object(
      {{"number", name_of(v.number)},
       {"instructions", name_of(v.instructions)},
       {"degree", v.degree},
       {"filter", name_of(v.filter)},
       {"curve", name_of(v.curve)},
       {"texels", name_of(v.format)},
       {"milliseconds", trial.took.processor},
       {"wall_milliseconds", trial.took.wall},
       {"spread", trial.took.spread},
       {"time", trial.time},
       {places ? "worst_texels" : "worst_unrounded", places ? e.worst_texels : e.worst_unrounded},
       {places ? "mean_texels" : "mean_unrounded", places ? e.mean_texels : e.mean_unrounded},
       {places ? "texels_bound" : "unrounded_bound", places ? e.texels_bound : e.unrounded_bound},
       {"changed", e.changed},
       {"may_change", e.may_change},
       {"levels", e.levels},
       {"levels_bound", e.levels_bound}});
}

Json json_of(const Noise& noise) {
  return Json::object({{"sampler", name_of(noise.kind)},
                       {"samples", noise.samples},
                       {"rmse", noise.rmse},
                       {"rmse_bound", noise.rmse_bound},
                       {"milliseconds", noise.took.processor},
                       {"wall_milliseconds", noise.took.wall},
                       {"spread", noise.took.spread}});
}

Json json_of(const FilterCost& filter) {
  return Json::object({{"name", filter.name},
                       {"options", filter.options},
                       {"error", filter.error},
                       {"own_error", filter.own_error},
                       {"levels", filter.levels()},
                       {"reads", filter.reads},
                       {"nanoseconds", filter.nanoseconds},
                       {"spread", filter.spread}});
}

Json json_of(const SkyCost& cost) {
  return Json::object({{"sky", cost.sky},
                       {"way", cost.way},
                       {"auto", cost.chosen},
                       {"samples", cost.samples},
                       {"levels", cost.error},
                       {"microseconds", cost.microseconds},
                       {"spread", cost.spread}});
}

}  // namespace

Machine measuring_machine(Instructions widest) {
  std::vector<std::string> names;
  for (const Instructions each : usable_instructions(widest)) names.emplace_back(name_of(each));
  return this_machine(TEXMAP_FLAGS, names);
}

std::string errors_text(const Trial& trial) {
  const Errors& e = trial.errors;
  const std::array<double, 3> off =
      trial.variant.curve == Curve::none
          ? std::array{e.worst_texels, e.mean_texels, e.texels_bound}
          : std::array{e.worst_unrounded, e.mean_unrounded, e.unrounded_bound};
  return text(" %8.1e %8.1e %8.1e %6ld %7ld %4d %7d", off[0], off[1], off[2], e.changed,
              e.may_change, e.levels, e.levels_bound);
}

std::string errors_text(const FilterCost& filter) {
  return text("%-14s %8.4f %8.2f %12.1f", filter.name.c_str(), filter.error, filter.levels(),
              filter.reads);
}

std::string errors_text(const Fronts& fronts, const std::string& sky, const std::string& way) {
  std::string errors;
  bool chosen = false;
  for (const SkyCost& one : fronts.skies) {
    if (one.sky != sky || one.way != way) continue;
    errors += text(" %8.2f", one.error);
    chosen = one.chosen;
  }
  return text("%-9s%-15s", sky.c_str(), (way + (chosen ? " *" : "")).c_str()) + errors;
}

std::string columns_of_light(const Variant& variant) {
  return text("%-6s %-8s", name_of(variant.format), name_of(variant.curve));
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
  std::vector<double> spreads;
  for (const auto* trials : {&all.places, &all.curves, &all.texel_formats}) {
    for (const Trial& trial : *trials) spreads.push_back(trial.took.spread);
  }
  for (const Noise& noise : all.noise) spreads.push_back(noise.took.spread);
  for (const FilterCost& filter : all.fronts.filters) spreads.push_back(filter.spread);
  for (const SkyCost& cost : all.fronts.skies) spreads.push_back(cost.spread);
  const auto busy = std::count_if(spreads.begin(), spreads.end(),
                                  [](double spread) { return spread > quiet_spread; });
  if (busy == 0) return "";
  return text(
      "\nThis machine was busy: %ld of %zu times spread by more than 10 %% (median over shortest), "
      "the widest by\n%.0f %%. Ways whose times could be equal count as equally fast; of these the "
      "most exact is recommended.\n",
      static_cast<long>(busy), spreads.size(),
      100 * (*std::max_element(spreads.begin(), spreads.end()) - 1));
}

std::string table_of(const Measurements& all) {
  return all.machine.text() + "\n\n" + table_of_places(all, Filter::nearest) +
         table_of_places(all, Filter::bilinear) +
         table_of_light(all.curves,
                        "From texels through light to sRGB bytes; time 1 is that of plain double "
                        "with the power") +
         table_of_light(all.texel_formats,
                        text("The same with %d rays per pixel, %d x %d pixels; time 1 is that of "
                             "plain double with bytes",
                             texel_format_samples, noise_width, noise_height)) +
         table_of_noise(all) + "\n" + table_of_filters(all.fronts) + "\n" +
         table_of_skies(all.fronts) + judge_line() + skipped_text(all) + busy_text(all);
}

std::string json_of(const Measurements& all) {
  const auto item = [](const auto& element) { return json_of(element); };
  return Json::object({{"machine", all.machine.json()},
                       {"width", all.width},
                       {"height", all.height},
                       {"places", Json::list_of(all.places, item)},
                       {"curves", Json::list_of(all.curves, item)},
                       {"kept", Json::list_of(all.texel_formats, item)},
                       {"noise_width", noise_width},
                       {"noise_height", noise_height},
                       {"noise", Json::list_of(all.noise, item)},
                       {"filters", Json::list_of(all.fronts.filters, item)},
                       {"skies", Json::list_of(all.fronts.skies, item)}},
                      true)
             .text +
         "\n";
}

}  // namespace texmap::chapter_13
