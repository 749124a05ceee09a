// The lesson of this chapter: what each saving of time costs in accuracy, measured on the machine
// that runs it.
#pragma once
#include "engine/app/command_line.hpp"
#include "engine/app/session.hpp"
#include "engine/app/texture_file.hpp"
#include "recommendation.hpp"

namespace texmap::chapter_13 {

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "what each saving of time costs in accuracy, measured on this machine",
      .size = {1312, 1090},
      .without = {"--number", "--samples", "--zoom"},
  };

  TextureFile texture{"earth.png"};
  std::string budget;
  Instructions widest = widest_instructions();
  int rounds = 20;
  int seconds = 60;

  void options(CommandLine& line) override {
    texture.declare(line);
    line.text("--budget", "BUDGET", budget,
              "also recommend a way for this allowed error: exact, texels=0.001 or levels=2");
    line.choice<Instructions>("--instructions", widest,
                              {{"baseline", Instructions::baseline},
                               {"avx2", Instructions::avx2},
                               {"avx512", Instructions::avx512}},
                              "the widest vector instructions that packs may use");
    line.whole("--rounds", rounds, 1, 10000,
               "how often to time each variant; the shortest time counts");
    line.whole("--seconds", seconds, 1, 1000000,
               "after so many seconds of timing, skip every round beyond the fifth");
  }
  void prepare(Session& session) override { session.settings.instructions = widest; }

  /// What is varied: the number with the (u, v) kernel and the filter, then the curve to bytes,
  /// then the samples.
  [[nodiscard]] Measurements measure(const Globe& globe, const View<>& view, int threads,
                                     const Tick& tick) const {
    Measurements all{measuring_machine(widest), view.width, view.height, all_places(widest),
                     all_curves(widest)};
    const WorkTime alone = time_alone(globe, view);  // no wide instructions have run yet

    // Errors: compared with the same picture in Judge. Times: on one thread, all alternately, the
    // shortest; plain double must take as long as it took alone.
    find_errors_of_places(all.places, globe, view, tick);
    find_errors_of_curves(all.curves, globe, view, tick);
    Timing timing{rounds, TimeLimit(1000.0 * seconds, 5), tick};
    time_trials_beside(alone, all.places, globe, view, timing);
    time_trials(all.curves, globe, view, timing);

    // Many samples: texel formats, then samplers, drawn by the fastest variant that changes
    // nothing.
    all.texel_formats = measure_texel_formats(globe, widest, threads, tick);
    time_texel_formats(all.texel_formats, globe, timing);
    all.exact = fastest(all.places, Filter::nearest, {})->variant;
    all.noise = measure_noise(globe, all.exact, threads, tick);
    time_noise(all.noise, globe, all.exact, timing);

    // What chapters 09 and 12 let you choose: filters, and ways to light by a sky.
    all.fronts = measure_fronts(threads, timing);
    all.rounds = timing.done;
    return all;
  }

  void show(Session& session) override;  ///< in show.cpp
};

}  // namespace texmap::chapter_13
