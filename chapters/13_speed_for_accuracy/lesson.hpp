// The lesson of this chapter: what each saving of time costs in accuracy, measured on the machine
// that runs it.
#pragma once
#include "engine/app/command_line.hpp"
#include "engine/app/session.hpp"
#include "engine/app/texture_file.hpp"
#include "ways.hpp"

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
    Measurements all{measuring_machine(widest), view.width, view.height};
    const WorkTime alone = time_alone(globe, view);  // no wide instructions have run yet
    for (const Part part : {Part::places, Part::curves, Part::samplers})
      all.of(part) = rows_of(part, widest);

    // Errors: compared with the same picture in Judge. Times: on one thread, all alternately, the
    // shortest; plain double must take as long as it took alone.
    find_errors(all.of(Part::places), globe, view, threads, tick);
    find_errors(all.of(Part::curves), globe, view, threads, tick);
    Timing timing{rounds, 1000.0 * seconds, tick};
    time_rows_beside(alone, all.of(Part::places), globe, view, timing);
    time_rows(all.of(Part::curves), globe, view, timing);

    // Samplers, drawn by the fastest variant that changes nothing.
    const Variant exact = fastest(all, Filter::nearest, {})->variant;
    for (Row& row : all.of(Part::samplers)) row.variant = exact;
    find_errors(all.of(Part::samplers), globe, view, threads, tick);
    time_rows(all.of(Part::samplers), globe, view, timing);
    all.skipped = timing.skipped;
    all.rays = timing.rays;
    return all;
  }

  void draw_all(Session& session) override;  ///< in show.cpp
};

}  // namespace texmap::chapter_13
