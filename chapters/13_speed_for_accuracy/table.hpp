// The table: all that was tried, as text to read and as JSON for other programs.
#pragma once
#include "figures_json.hpp"
#include "words.hpp"

namespace texmap::chapter_13 {

/// All that was measured in one run.
struct Measurements {
  int width = 0, height = 0;     ///< of the pictures of places and curves, pixels
  std::vector<Trial> places;     ///< the first is plain double
  std::vector<Trial> curves;     ///< the first is plain double
  std::vector<Trial> kept = {};  ///< the first is plain double's bytes
  Way exact = {};                ///< the fastest that changes nothing: the samplers draw with it
  std::vector<Noise> noise = {};
  std::vector<Rounds> rounds = {};  ///< of the four timings, in the order above
};

/// The trial of a way, or nullptr.
[[nodiscard]] inline const Trial* find_trial(const std::vector<Trial>& trials, const Way& way) {
  for (const Trial& trial : trials) {
    if (trial.way == way) return &trial;
  }
  return nullptr;
}

/// The times of a number and a kernel with each set of instructions, as parts of plain double's; - where there is none.
[[nodiscard]] inline std::string times_of(const std::vector<Trial>& trials, Way way) {
  std::string times;
  for (const Instructions instructions : {Instructions::baseline, Instructions::avx2, Instructions::avx512}) {
    way.instructions = instructions;
    const Trial* trial = find_trial(trials, way);
    times += trial == nullptr ? "        -" : printed("%9.3f", trial->time);
  }
  return times;
}

/// The right half of a row: what does not depend on the clock.
[[nodiscard]] inline std::string errors_text(const Trial& trial) {
  const Errors& e = trial.errors;
  const std::array<double, 3> off = trial.way.curve == Curve::none
                                        ? std::array{e.worst_texels, e.mean_texels, e.texels_bound}
                                        : std::array{e.worst_unrounded, e.mean_unrounded, e.unrounded_bound};
  return printed(" %8.1e %8.1e %8.1e %6ld %7ld %4d %7d", off[0], off[1], off[2], e.changed, e.may_change, e.levels,
                 e.levels_bound);
}

[[nodiscard]] inline std::string table_of_places(const Measurements& all, Filter filter) {
  std::string table = printed("%s, %d x %d pixels, one ray a pixel; time 1 is plain double's %.1f ms with the nearest texel\n",
                              filter == Filter::nearest ? "Nearest texel" : "Bilinear filter", all.width, all.height,
                              all.places.front().milliseconds);
  table +=
      printed("%-23s%27s %26s %14s %12s\n", "", "time by instructions", "place off by, texels", "pixels off", "levels off");
  table += printed("%-12s %-10s%9s%9s%9s %8s %8s %8s %6s %7s %4s %7s\n", "number", "kernel", "baseline", "avx2", "avx512",
                   "worst", "mean", "at most", "seen", "at most", "seen", "at most");
  for (const Trial& trial : all.places) {
    if (trial.way.filter != filter || trial.way.instructions != Instructions::baseline) continue;
    table += printed("%-12s %-10s", name_of(trial.way.number), name_of_kernel(trial.way.degree).c_str());
    table += times_of(all.places, trial.way);
    table += errors_text(trial) + "\n";
  }
  return table;
}

/// How a way keeps texels and how it makes bytes of them, as two columns.
[[nodiscard]] inline std::string columns_of_light(const Way& way) {
  return printed("%-6s %-8s", name_of(way.texels), name_of(way.curve));
}

/// @param title  the line above
[[nodiscard]] inline std::string table_of_light(const std::vector<Trial>& trials, const std::string& title) {
  std::string table = title + "\n";
  table += printed("%-51s%26s %14s %12s\n", "", "levels off, not rounded", "pixels off", "levels off");
  table += printed("%-12s %-13s %-6s %-8s %8s %8s %8s %8s %6s %7s %4s %7s\n", "number", "instructions", "texels", "curve",
                   "time", "worst", "mean", "at most", "seen", "at most", "seen", "at most");
  for (const Trial& trial : trials) {
    table += printed("%-12s %-13s %s %8.3f", name_of(trial.way.number), name_of(trial.way.instructions),
                     columns_of_light(trial.way).c_str(), trial.time);
    table += errors_text(trial) + "\n";
  }
  return table;
}

[[nodiscard]] inline std::string table_of_noise(const Measurements& all) {
  std::string table =
      printed("Samples: root mean square error in levels of 255, and milliseconds for %d x %d pixels (%s, %s)\n", noise_width,
              noise_height, name_of(all.exact.number), name_of(all.exact.instructions));
  table += "        ";
  for (const SamplerKind kind : sampler_kinds) table += printed("  %-22s", name_of(kind));
  table += "\nsamples ";
  for (std::size_t i = 0; i < sampler_kinds.size(); ++i) table += "   mean at most       ms";
  table += "\n";
  for (const int samples : sample_counts) {
    table += printed("%7d ", samples);
    for (const Noise& noise : all.noise) {
      if (noise.samples == samples) table += printed(" %7.2f %7.2f %8.2f", noise.rmse, noise.rmse_bound, noise.milliseconds);
    }
    table += "\n";
  }
  return table;
}

/// What to know of the times if rounds were skipped; empty if none were.
[[nodiscard]] inline std::string skipped_text(const Measurements& all) {
  std::string counts;
  bool skipped = false;
  for (const Rounds& each : all.rounds) {
    counts += printed("%s%d of %d", counts.empty() ? "" : ", ", each.timed, each.wanted);
    skipped = skipped || each.timed < each.wanted;
  }
  if (!skipped) return "";
  return "\nThe machine is busy or slow: timing took longer than --seconds allows. Rounds timed: " + counts +
         ".\nFewer rounds make times less sure; errors have no part in it.\n";
}

[[nodiscard]] inline std::string table_of(const Measurements& all) {
  return table_of_places(all, Filter::nearest) + "\n" + table_of_places(all, Filter::bilinear) + "\n" +
         table_of_light(all.curves, "From texels through light to sRGB bytes; time 1 is that of plain double with the power") +
         "\n" +
         table_of_light(all.kept,
                        printed("The same with %d rays a pixel, %d x %d pixels; time 1 is that of plain double with bytes",
                                kept_samples, noise_width, noise_height)) +
         "\n" + table_of_noise(all) + skipped_text(all);
}

/// The same as JSON: an object with a list for each part of the table.
[[nodiscard]] inline std::string json_of(const Measurements& all) {
  const auto trial_json = [](const Trial& trial) {
    const Errors& e = trial.errors;
    std::string json =
        printed(R"(    {"number": "%s", "instructions": "%s", "degree": %d, "filter": "%s", "curve": "%s", "texels": "%s", )",
                name_of(trial.way.number), name_of(trial.way.instructions), trial.way.degree, name_of(trial.way.filter),
                name_of(trial.way.curve), name_of(trial.way.texels));
    json += "\"milliseconds\": " + round_trip(trial.milliseconds) + ", \"time\": " + round_trip(trial.time);
    if (trial.way.curve == Curve::none) {
      json += ", \"worst_texels\": " + round_trip(e.worst_texels) + ", \"mean_texels\": " + round_trip(e.mean_texels) +
              ", \"texels_bound\": " + round_trip(e.texels_bound);
    } else {
      json += ", \"worst_unrounded\": " + round_trip(e.worst_unrounded) +
              ", \"mean_unrounded\": " + round_trip(e.mean_unrounded) +
              ", \"unrounded_bound\": " + round_trip(e.unrounded_bound);
    }
    return json + printed(R"(, "changed": %ld, "may_change": %ld, "levels": %d, "levels_bound": %d})", e.changed, e.may_change,
                          e.levels, e.levels_bound);
  };
  const auto list = [](const auto& all_of_them, const auto& one) {
    std::string json = "[\n";
    for (std::size_t i = 0; i < all_of_them.size(); ++i)
      json += one(all_of_them[i]) + (i + 1 < all_of_them.size() ? ",\n" : "\n");
    return json + "  ]";
  };
  return printed("{\n  \"width\": %d,\n  \"height\": %d,\n  \"places\": ", all.width, all.height) +
         list(all.places, trial_json) + ",\n  \"curves\": " + list(all.curves, trial_json) +
         ",\n  \"kept\": " + list(all.kept, trial_json) +
         printed(",\n  \"noise_width\": %d,\n  \"noise_height\": %d,\n  \"noise\": ", noise_width, noise_height) +
         list(all.noise,
              [](const Noise& noise) {
                return printed(R"(    {"sampler": "%s", "samples": %d, "rmse": )", name_of(noise.kind), noise.samples) +
                       round_trip(noise.rmse) + ", \"rmse_bound\": " + round_trip(noise.rmse_bound) +
                       ", \"milliseconds\": " + round_trip(noise.milliseconds) + "}";
              }) +
         "\n}\n";
}

}  // namespace texmap::chapter_13
