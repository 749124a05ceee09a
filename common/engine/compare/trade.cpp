// What each way to draw one picture costs in time and in accuracy.
#include "engine/compare/trade.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/compare/difference.hpp"
#include "engine/compare/plot.hpp"
#include "engine/files/stopwatch.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

/// Errors below are drawn here: a logarithmic axis has no 0.
constexpr double least_error = 1e-3;

const Way& first_of(const TradePart& part) { return part.ways.front(); }

double ratio(const Way& way, const TradePart& part) {
  return way.took.processor / first_of(part).took.processor;
}

/// "float-pack avx2", "samples 16": what its words say, without what all of them have.
std::string label_of(const Way& way) {
  std::string label = way.words;
  for (const std::string common : {"--number ", "--instructions ", "--"}) {
    for (std::size_t at = 0; (at = label.find(common)) != std::string::npos;)
      label.erase(at, common.size());
  }
  return label;
}

/// The fastest of the ways that may be taken, if it saves time; else the first.
template <class May>
const Way& fastest(const TradePart& part, const May& may) {
  const Way* best = &first_of(part);
  for (const Way& way : part.ways) {
    if (may(way) && way.took.processor * same_time < best->took.processor) best = &way;
  }
  return *best;
}

/// The words of the ways that no other one beats in both time and error.
std::vector<std::string> front_of(const TradePart& part) {
  std::vector<std::string> front;
  for (const Way& way : part.ways) {
    if (std::none_of(part.ways.begin(), part.ways.end(), [&way](const Way& other) {
          return other.took.processor < way.took.processor && other.error <= way.error;
        }))
      front.push_back(way.words);
  }
  return front;
}

/// The time of a work alone. Before each run the cache is filled with other data, as the other
/// works would fill it.
WorkTime time_alone(const Work& work, int rounds) {
  std::vector<char> others(std::size_t{1} << 28);
  const Work fill_cache = [&] {
    for (std::size_t at = 0; at < others.size(); at += 64) ++others[at];  // in each cache line
  };
  return work_times({fill_cache, work}, rounds).back();
}

}  // namespace

void measure_trade(std::vector<TradePart>& parts, double seconds,
                   const std::function<void(int, int)>& report) {
  const int count = static_cast<int>(parts.size());
  for (int i = 0; i < count; ++i) {
    TradePart& part = parts[static_cast<std::size_t>(i)];
    const Image right = part.right();
    std::vector<Work> works;
    const Stopwatch first_round;
    for (Way& way : part.ways) {
      const Figures figures = measure(right, way.draw(), {}, Detail::pixels);
      way.changed = figures.pixels_different;
      way.levels = figures.worst.levels;
      way.error = figures.root_mean_square_error;
      works.emplace_back([&way] { static_cast<void>(way.draw()); });
    }
    const double rounds_in_time = 1000 * seconds / first_round.milliseconds();
    const int rounds = static_cast<int>(std::clamp(rounds_in_time, 2.0, 50.0));
    const WorkTime alone = i == 0 ? time_alone(works.front(), std::max(rounds / 5, 1)) : WorkTime{};
    const std::vector<WorkTime> times =
        work_times(works, rounds, [&](int done, int all) { report(i * all + done, count * all); });
    for (std::size_t k = 0; k < times.size(); ++k) part.ways[k].took = times[k];
    // The first way of the others is no plain number. What slowed it alone is over.
    if (i > 0 || times.front().processor <= alone.processor) continue;
    const std::string wrong = disagreement(alone, times.front());
    if (!wrong.empty()) throw std::runtime_error(wrong);
  }
}

std::string table_of(const TradePart& part, const std::string& command) {
  std::size_t widest = 0;
  for (const Way& way : part.ways) widest = std::max(widest, way.words.size());
  const int width = static_cast<int>(widest);
  std::string lines = part.title + "\n" +
                      text("  %-*s        ms    time  pixels off  by levels  root mean square\n",
                           width, command.c_str());
  int busy = 0;
  for (const Way& way : part.ways) {
    busy += way.took.spread > quiet_spread ? 1 : 0;
    lines += text("  %-*s %9.1f %7.2f %11zu %10d %17.3f\n", width, way.words.c_str(),
                  way.took.processor, ratio(way, part), way.changed, way.levels, way.error);
  }
  if (busy > 0) {
    lines += text(
        "  The machine was busy: of %d of %zu ways the median took over 1.1 of the "
        "shortest time\n",
        busy, part.ways.size());
  }
  return lines;
}

std::string recommendation(const TradePart& part, const std::string& command) {
  std::string lines;
  const auto advise = [&](const std::string& purpose, const Way& way) {
    if (&way == &first_of(part)) {
      lines += "  " + purpose + ": nothing that was tried saves 5 %\n";
    } else {
      lines += text("  %s, %.1f times as fast:\n    ", purpose.c_str(), 1 / ratio(way, part)) +
               command + " " + way.words + "\n";
    }
  };
  const auto has_no_error = [](const Way& way) { return way.levels == 0; };
  const Way& same = fastest(part, has_no_error);
  if (!has_no_error(first_of(part))) {
    lines += "  the front (no other way is both faster and closer):\n";
    for (const std::string& words : front_of(part)) lines += "    " + words + "\n";
    return lines;
  }
  if (std::count_if(part.ways.begin(), part.ways.end(), has_no_error) > 1)
    advise("the same picture", same);
  for (const int levels : {1, 4}) {
    const Way& way = fastest(part, [&](const Way& each) { return each.levels <= levels; });
    if (&way != &same && way.levels > levels / 4)
      advise(text("seen: off by %d level%s or less", levels, levels == 1 ? "" : "s"), way);
  }
  return lines;
}

std::string plot_of(const std::vector<TradePart>& parts, const std::string& command) {
  Plot plot{command + ": each way to draw it, its time and its error",
            "milliseconds on one thread; bars end at the median",
            "root mean square error in levels of 255; 0.001 stands for less"};
  int style = 0;
  for (const TradePart& part : parts) {
    PlotSeries series{part.title.substr(0, part.title.find(':')), style++};
    for (const Way& way : part.ways) {
      const double time = way.took.processor;
      series.points.push_back(
          {time, std::max(way.error, least_error), label_of(way), time * way.took.spread});
    }
    plot.series.push_back(series);
  }
  return svg_of(plot);
}

}  // namespace texmap
