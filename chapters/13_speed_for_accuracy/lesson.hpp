// The lesson of this chapter: what each saving of time costs in accuracy, measured on the machine that runs it.
#pragma once
#include <string>

#include "recommendation.hpp"
#include "report.hpp"
#include "running.hpp"
#include "sheet.hpp"
#include "standard_streams.hpp"
#include "studio.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_13 {

struct Lesson {
  static constexpr const char* idea = "what each saving of time costs in accuracy, measured on this machine";

  TextureFile texture{"earth.png"};
  std::string budget;
  int rounds = 20;
  int seconds = 60;

  void options(CommandLine& line) {
    texture.declare(line);
    line.text("--budget", "BUDGET", budget, "recommend for this too: exact, texels=0.001 or levels=2");
    line.whole("--rounds", rounds, 1, 10000, "how often each way is timed; the shortest time counts");
    line.whole("--seconds", seconds, 1, 1000000, "of timing, after which rounds are skipped beyond the fifth");
  }

  /// What is varied: the number with the (u, v) kernel and the filter, then the curve to bytes, then the samples.
  [[nodiscard]] Measurements measure(const Globe& globe, const View& view, const RenderSettings& settings,
                                     const Tick& tick) const {
    Measurements all{view.width, view.height, all_places(settings.instructions), all_curves(settings.instructions)};

    // How errors are judged: by the same picture in extended precision, and beside each stands what was stated before.
    judge_places(all.places, globe, view, tick);
    judge_curves(all.curves, globe, view, tick);

    // How time is taken: all by turns, one thread, the shortest of all rounds, as a part of plain double's.
    Timing timing{rounds, Patience(1000.0 * seconds, 5), tick};
    time_trials(all.places, globe, view, timing);
    time_trials(all.curves, globe, view, timing);

    // Many samples: texels as bytes and as roots; then the samplers, with the fastest that changes nothing, since what they are
    // judged by is a picture of many more.
    all.kept = try_kept(globe, settings.instructions, settings.threads, timing);
    all.exact = fastest(all.places, Filter::nearest, {})->way;
    all.noise = measure_noise(globe, all.exact, settings.threads, tick);
    time_noise(all.noise, globe, all.exact, timing);
    all.rounds = timing.done;
    return all;
  }

  void show(Studio& studio) const {
    const std::vector<Budget> budgets = budgets_with(budget);
    refuse_what_is_varied(studio);
    check_report(studio.out);
    studio.prefer_size(1312, 1090);
    const Globe globe(texture.load());
    const SheetLayout layout(studio.width, studio.height);
    const View view = globe.view(layout.panel_width, layout.panel_height);

    Measurements all;
    Ticks ticks(stages_of(rounds, studio.instructions));
    studio.remark = [&ticks] { return ticks.remark(); };
    (void)studio.timed(0, [&](const RenderSettings& settings) {
      all = measure(globe, view, settings, [&] { ticks(settings); });
      return Image();
    });
    const Image sheet = studio.timed(rays_of(all), [&](const RenderSettings& settings) {
      return draw_sheet(globe, studio.width, studio.height, settings.threads, [&] { ticks(settings); });
    });

    if (!studio.quiet) print(table_of(all) + "\n" + recommendations(all, budgets, globe.nearest.image));
    write_report(studio.out, all);
    studio.save(sheet);
  }
};

}  // namespace texmap::chapter_13
