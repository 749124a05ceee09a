// The lesson of this chapter: what each saving of time costs in accuracy, measured on the machine that runs it.
#pragma once
#include <string>

#include "sheet.hpp"
#include "studio.hpp"
#include "table.hpp"
#include "texture_file.hpp"

namespace texmap::chapter_13 {

struct Lesson {
  static constexpr const char* idea = "what each saving of time costs in accuracy, measured on this machine";

  TextureFile texture{"earth.png"};
  int rounds = 12;

  void options(CommandLine& line) {
    texture.declare(line);
    line.whole("--rounds", rounds, 1, 10000, "how often each way is timed; the shortest time counts");
  }

  /// Everything is tried here, on one thread where time is taken.
  [[nodiscard]] Measurements measure(const Globe& globe, int width, int height, const RenderSettings& settings,
                                     const Tick& tick) const {
    Measurements all{width, height, all_places(settings.instructions), all_curves(settings.instructions), {}, {}};
    const View view = globe.view(width, height);
    judge_places(all.places, globe, view, tick);
    judge_curves(all.curves, globe, view, tick);
    time_trials(all.places, globe, view, rounds, tick);
    time_trials(all.curves, globe, view, rounds, tick);
    for (const Trial& trial : all.places) {
      if (trial.way.number == Number::double_pack && trial.way.degree == 0) all.exact = trial.way;
    }
    all.exact.filter = Filter::nearest;
    all.noise = measure_noise(globe, all.exact, settings.threads, tick);
    time_noise(all.noise, globe, all.exact, rounds / 4 + 1, tick);
    return all;
  }

  void show(Studio& studio) const {
    const Globe globe(texture.load());
    Measurements all;
    (void)studio.timed(1, [&](const RenderSettings& settings) {
      all = measure(globe, 400, 300, settings, [] {});
      return Image();
    });
    print(table_of(all));
    studio.save(Image(10,10));
  }
};

}  // namespace texmap::chapter_13
