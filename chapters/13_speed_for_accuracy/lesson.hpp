// The lesson of this chapter: what each saving of time costs in accuracy, measured on the machine
// that runs it.
#pragma once
#include "engine/run/command_line.hpp"
#include "engine/run/session.hpp"
#include "engine/run/texture_file.hpp"
#include "errors.hpp"
#include "measure.hpp"
#include "report.hpp"

namespace texmap::chapter_13 {

/// The user's choices of what is timed, and how long.
struct TradeOptions {
  std::string budget;  ///< to recommend a way for; empty: the usual ones alone
  Instructions widest = widest_instructions();
  int rounds = 20;
  int seconds = 60;

  void declare(Offer& offer);  ///< in show.cpp
};

struct Lesson : SheetLesson {
  static constexpr About about{
      .idea = "what each saving of time costs in accuracy, measured on this machine",
      .size = {1312, 1090},
  };

  TextureFile texture{"earth.png"};
  TradeOptions trade;

  Groups options() override { return {texture, trade}; }

  /// What is varied: the number with the (u, v) kernel and the filter, then the curve to bytes,
  /// then the samples.
  [[nodiscard]] Measurements measure(const Globe& globe, const View<>& view, int threads,
                                     const Tick& tick) const {
    Measurements all{measuring_machine(trade.widest), view.width, view.height};
    const WorkTime alone = time_alone(globe, view);  // no wide instructions have run yet
    for (const Part part : {Part::places, Part::curves, Part::samplers})
      all.of(part) = rows_of(part, trade.widest);

    // Errors: compared with the same picture in Judge. Times: on one thread, all alternately, the
    // shortest; plain double must take as long as it took alone.
    find_errors(all.of(Part::places), globe, view, threads, tick);
    find_errors(all.of(Part::curves), globe, view, threads, tick);
    Timing timing{trade.rounds, 1000.0 * trade.seconds, tick};
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
