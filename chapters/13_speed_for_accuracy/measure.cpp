// Which ways are tried, how long they take, how far a run is, and which way is best.
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "09_texture_filtering/comparison.hpp"
#include "12_environment_map/front.hpp"
#include "engine/kernels/kernel_plan.hpp"
#include "engine/measure/text.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {
namespace {

/// Samples of the pictures that compare texel formats: there texels take more of the time.
constexpr int format_samples = 64;

/// The (u, v) kernels that are useful for a number: beyond degree 17 rounding is all that is left
/// of float's errors, and below degree 23 double is no better than float.
std::vector<int> degrees_for(NumberKind number) {
  if (number == NumberKind::extended) return {0};
  if (is_float(number)) return {0, 5, 7, 9, 11, 13, 15, 17};
  return {0, 23, 29, 35};
}

/// How many rounds sampled pictures are timed: they take longer, and their ratios are larger.
int noise_rounds(int rounds) { return rounds / 4 + 1; }

bool has_many_rays(Part part) { return part == Part::formats || part == Part::samplers; }

/// The times of works, noted in `timing`, which ticks for the first `ticks` works of every round,
/// and for skipped rounds all at once.
std::vector<WorkTime> timed_alternately(const std::vector<Work>& works, int rounds,
                                        std::size_t ticks, Timing& timing) {
  Rounds& noted = timing.done.emplace_back(Rounds{rounds});
  auto times = work_times(
      works, rounds,
      [&](int done, int) {
        if (static_cast<std::size_t>(done - 1) % works.size() < ticks) timing.tick();
      },
      [&](int round) {
        noted.timed = round;
        return timing.limit(round);
      });
  for (std::size_t i = 0; i < ticks * static_cast<std::size_t>(rounds - noted.timed); ++i)
    timing.tick();
  return times;
}

}  // namespace

std::span<Row> Measurements::of(Part part) {
  const auto [first, last] =
      std::equal_range(rows.begin(), rows.end(), Row{part},
                       [](const Row& a, const Row& b) { return a.part < b.part; });
  return {rows.data() + (first - rows.begin()), static_cast<std::size_t>(last - first)};
}
std::span<const Row> Measurements::of(Part part) const {
  return const_cast<Measurements*>(this)->of(part);  // NOLINT: which changes nothing
}
Rows Measurements::some_of(Part part, const std::function<bool(const Row&)>& may_be) const {
  Rows some;
  for (const Row& row : of(part)) {
    if (!may_be || may_be(row)) some.push_back(&row);
  }
  return some;
}

std::vector<Instructions> usable_instructions(Instructions widest) {
  std::vector<Instructions> usable;
  for (const Instructions each : all_instructions) {
    if (each <= widest && has_packs_of(each)) usable.push_back(each);
  }
  return usable;
}

std::vector<Row> rows_of(Part part, Instructions widest) {
  std::vector<Row> rows;
  const std::vector<Instructions> usable = usable_instructions(widest);
  if (part == Part::samplers) {
    for (const SamplerKind kind : sampler_kinds) {
      for (const int samples : sample_counts) rows.push_back({part, {}, kind, samples});
    }
    return rows;
  }
  if (part == Part::places) {
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
      for (const NumberKind number : {NumberKind::double_, NumberKind::float_, NumberKind::extended,
                                      NumberKind::float_pack, NumberKind::double_pack}) {
        for (const Instructions instructions :
             is_pack(number) ? usable : std::vector{Instructions::baseline}) {
          for (const int degree : degrees_for(number))
            rows.push_back({part, {number, instructions, degree, filter}});
        }
      }
    }
    return rows;
  }
  // Bytes and roots take turns, because a picture leaves its texels in the caches for the next.
  // Roots stand only where the curve is at most one level off.
  constexpr TexelFormat bytes = TexelFormat::bytes, roots = TexelFormat::roots;
  std::vector<std::pair<Curve, TexelFormat>> ways = {{Curve::exact, bytes}, {Curve::exact, roots}};
  if (part == Part::curves) {
    ways.insert(ways.begin(), {Curve::formula, bytes});
    ways.insert(ways.end(), {{Curve::four, bytes}, {Curve::four, roots}, {Curve::three, bytes}});
  }
  for (const NumberKind number :
       {NumberKind::double_, NumberKind::float_, NumberKind::double_pack, NumberKind::float_pack}) {
    const Instructions instructions = is_pack(number) ? usable.back() : Instructions::baseline;
    for (const auto& [curve, format] : ways) {
      rows.push_back({part,
                      {number, instructions, 0, Filter::nearest, curve, format},
                      SamplerKind::sobol,
                      part == Part::curves ? 1 : format_samples});
    }
  }
  return rows;
}

const Row* find_row(std::span<const Row> rows, const Variant& variant) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return row.variant == variant; });
  return found == rows.end() ? nullptr : &*found;
}

// Times.

void time_rows(std::span<Row> rows, const Globe& globe, const View<>& view, Timing& timing) {
  const bool many_rays = has_many_rays(rows.front().part);
  const View<> seen = many_rays ? noise_view(globe, 0) : view;
  std::vector<Work> works;
  std::vector<Row*> row_of_work;
  const auto add = [&](Row& row) {
    works.emplace_back([&globe, &seen, &row, many_rays] {
      if (many_rays) {
        (void)sampled(globe, seen, row.variant, Sampler(row.sampler, row.samples), 1);
      } else {
        (void)picture_of(globe, seen, row.variant);
      }
    });
    row_of_work.push_back(&row);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    add(rows[i]);
    if (i % 10 != 9 || many_rays) continue;
    // All others are measured by the first, so it and its like with the other filter are timed more
    // often: if they were disturbed in all rounds, every figure would be wrong. Their time is
    // rather too short: nothing is called faster than it is.
    for (Row& row : rows) {
      if (row.variant.number == NumberKind::double_ && row.variant.degree == 0 &&
          row.variant.curve == rows[0].variant.curve)
        add(row);
    }
  }
  // Every row ticks once in a round.
  const int rounds = many_rays ? noise_rounds(timing.rounds) : timing.rounds;
  const auto times = timed_alternately(works, rounds, rows.size(), timing);
  for (Row& row : rows) row.took = WorkTime();
  for (std::size_t k = 0; k < works.size(); ++k) {
    WorkTime& took = row_of_work[k]->took;
    if (times[k].processor < took.processor) took = times[k];
  }
  for (Row& row : rows) row.time = row.took.processor / rows[0].took.processor;
}

WorkTime time_alone(const Globe& globe, const View<>& view) {
  const std::vector<Work> work = {[&] { (void)picture_of(globe, view, {}); }};
  return work_times(work, rounds_within(200, work, 7, 100)).front();
}

std::string disagreement(const WorkTime& alone, const WorkTime& among) {
  const auto [shorter, longer] = std::minmax(alone.processor, among.processor);
  if (longer < 1 || longer <= 1.25 * shorter) return "";
  return text(
      "plain double took %.1f ms for a picture before packs were timed, and %.1f ms among "
      "them. Every ratio would be wrong, so none is shown. Either this machine changed its "
      "speed meanwhile: run again when nothing else runs. Or packs leave the processor in a "
      "state that slows plain numbers: with --instructions baseline both times are then equal",
      alone.processor, among.processor);
}

void time_rows_beside(WorkTime alone, std::span<Row> rows, const Globe& globe, const View<>& view,
                      Timing& timing) {
  const auto first = timing.done.size();
  for (int attempt = 0; attempt < 3; ++attempt) {
    timing.done.resize(first);
    time_rows(rows, globe, view, timing);
    if (disagreement(alone, rows[0].took).empty()) return;
    // The machine may have been slow at the start. What wide code does to plain numbers lasts.
    alone.processor = std::min(alone.processor, time_alone(globe, view).processor);
    if (disagreement(alone, rows[0].took).empty()) return;
  }
  throw std::runtime_error(disagreement(alone, rows[0].took));
}

void measure_other_chapters(Measurements& all, int threads, Timing& timing) {
  chapter_09::FilterComparison filters = chapter_09::filter_comparison({}, threads);
  timing.tick();
  filters.note_times(timed_alternately(filters.works, timing.rounds, filters.works.size(), timing));
  for (const chapter_09::FilterFigures& one : filters.figures) {
    all.rows.push_back({.part = Part::filters,
                        .name = one.name,
                        .bound = 255 * one.error,
                        .mean = one.error,
                        .reads = one.reads,
                        .own_error = one.own_error,
                        .took = {one.nanoseconds, one.nanoseconds, one.spread}});
  }
  chapter_12::SkyComparison skies = chapter_12::compare_skies(threads, timing.tick);
  skies.note_times(
      timed_alternately(skies.works, noise_rounds(timing.rounds), skies.works.size(), timing));
  all.choice = skies.choice;
  all.other_rays = filters.rays + skies.paths;
  for (const chapter_12::SkyFigures& one : skies.figures) {
    all.rows.push_back({.part = Part::skies,
                        .samples = one.samples,
                        .name = one.way,
                        .sky = one.sky,
                        .chosen = one.chosen,
                        .bound = one.error,
                        .mean = one.error,
                        .took = {one.microseconds, one.microseconds, one.spread}});
    all.other_rays += 1.0 * chapter_12::timed_width * chapter_12::timed_height * one.samples *
                      (timing.done.back().timed + 1);
  }
}

// How far a run is.

std::vector<Phase> phases_of(int rounds, Instructions widest) {
  const auto rows = [widest](Part part) { return rows_of(part, widest).size(); };
  const auto runs = [](int timed) { return static_cast<std::size_t>(timed) + 1; };
  const std::size_t few = runs(noise_rounds(rounds));
  const std::size_t filters = chapter_09::filters_compared;
  const std::size_t skies = chapter_12::skies_compared;
  const std::size_t of_a_sky = chapter_12::figures_of_a_sky;
  return {{"errors of places", rows(Part::places)},
          {"errors of curves", rows(Part::curves)},
          {"times of places", rows(Part::places) * runs(rounds)},
          {"times of curves", rows(Part::curves) * runs(rounds)},
          {"texels with many rays", rows(Part::formats) * (few + 1)},
          {"errors of samplers", noise_views + rows(Part::samplers)},
          {"times of samplers", rows(Part::samplers) * few},
          {"errors of filters", 1},
          {"times of filters", filters * runs(rounds)},
          {"errors of skies", skies * (1 + of_a_sky)},
          {"times of skies", skies * of_a_sky * few},
          {"sheet", 16}};
}

double rays_of(const Measurements& all) {
  double rays = all.other_rays + 1.0 * noise_width * noise_height * noise_views * converged_samples;
  for (const Row& row : all.rows) {
    if (row.part >= Part::filters) break;
    const double pixels =
        has_many_rays(row.part) ? noise_width * noise_height : 1.0 * all.width * all.height;
    // Before timing there is one, too, and for the errors one or those of all views.
    const int others = 1 + (row.part == Part::samplers ? noise_views : 1);
    rays += pixels * row.samples * (all.rounds[static_cast<std::size_t>(row.part)].timed + others);
  }
  return rays;
}

void Ticks::operator()(const RenderSettings& settings) {
  const std::size_t total =
      std::accumulate(phases.begin(), phases.end(), std::size_t(0),
                      [](std::size_t sum, const Phase& phase) { return sum + phase.parts; });
  done = std::min(done + 1, total);
  if (settings.progress) settings.progress(static_cast<int>(done), static_cast<int>(total));
}

std::string Ticks::remark() const {
  std::size_t before = 0;
  for (const Phase& phase : phases) {
    before += phase.parts;
    if (done < before) return std::string(", ") + phase.name;
  }
  return "";
}

// Which is best.

bool keeps_to(const Budget& budget, const Row& row) {
  if (budget.unit == Budget::Unit::texels) return row.bound <= budget.limit;
  if (budget.unit == Budget::Unit::levels) return row.levels_bound <= budget.limit;
  return row.variant.degree == 0 &&
         (row.variant.number == NumberKind::double_ || row.may_change == 0);
}

const Row* fastest(const Rows& rows) {
  WorkTime shortest;
  for (const Row* row : rows) {
    if (row->took.processor < shortest.processor) shortest = row->took;
  }
  const Row* best = nullptr;
  for (const Row* row : rows) {
    const double same = std::max({same_time, row->took.spread, shortest.spread});
    if (row->took.processor > same * shortest.processor) continue;
    if (best == nullptr || row->bound < best->bound) best = row;
  }
  return best;
}

const Row* fastest(const Measurements& all, Filter filter, const Budget& budget) {
  return fastest(all.some_of(Part::places, [&](const Row& row) {
    return row.variant.filter == filter && keeps_to(budget, row);
  }));
}

const Row* fastest_light(const Measurements& all, const Budget& budget) {
  return fastest(all.some_of(Part::curves, [&](const Row& row) {
    const Row* place = find_row(all.of(Part::places), {.number = row.variant.number,
                                                       .instructions = row.variant.instructions});
    return keeps_to(budget, row) && place != nullptr && keeps_to({}, *place);
  }));
}

const Row* fastest(const Measurements& all, Part part, double levels, const std::string& sky) {
  return fastest(
      all.some_of(part, [&](const Row& row) { return row.sky == sky && row.bound <= levels; }));
}

Rows pareto_front(Rows rows) {
  std::sort(rows.begin(), rows.end(), [](const Row* a, const Row* b) {
    const double time = a->took.processor, other = b->took.processor;
    return time < other || (time == other && a->bound < b->bound);
  });
  Rows front;
  for (const Row* next : rows) {
    if (front.empty() || next->bound < front.back()->bound) front.push_back(next);
  }
  return front;
}

}  // namespace texmap::chapter_13
