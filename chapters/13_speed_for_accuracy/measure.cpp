// Which ways are tried, how long they take, and which is best.
#include <algorithm>
#include <stdexcept>

#include "engine/files/text.hpp"
#include "errors.hpp"
#include "measure.hpp"

namespace texmap::chapter_13 {
namespace {

/// The (u, v) kernels that are useful for a number: beyond degree 17 rounding is all that is left
/// of float's errors, and below degree 23 double is no better than float.
std::vector<int> degrees_for(NumberKind number) {
  if (number == NumberKind::extended) return {0};
  if (is_float(number)) return {0, 5, 9, 17};
  return {0, 23, 35};
}

}  // namespace

std::vector<Instructions> usable_instructions(Instructions widest) {
  std::vector<Instructions> usable;
  for (const Instructions each : all_instructions) {
    if (each <= widest && has_packs_of(each)) usable.push_back(each);
  }
  return usable;
}

std::vector<Row> rows_of(Part part, Instructions widest) {
  std::vector<Row> rows;
  if (part == Part::samplers) {
    for (const SamplerKind kind : sampler_kinds) {
      for (const int samples : sample_counts) rows.push_back({part, {}, kind, samples});
    }
    return rows;
  }
  const auto add = [&, packs = usable_instructions(widest).back()](Variant variant) {
    if (is_pack(variant.number)) variant.instructions = packs;
    rows.push_back({part, variant});
  };
  using enum NumberKind;
  if (part == Part::places) {
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
      for (const NumberKind number : {double_, float_, extended, float_pack, double_pack}) {
        for (const int degree : degrees_for(number))
          add({.number = number, .degree = degree, .filter = filter});
      }
    }
    return rows;
  }
  for (const NumberKind number : {double_, float_, double_pack, float_pack}) {
    for (const Curve curve : {Curve::formula, Curve::exact, Curve::four, Curve::three})
      add({.number = number, .curve = curve});
  }
  return rows;
}

// Times.

void time_rows(std::span<Row> rows, const Globe& globe, const View<>& view, Timing& timing) {
  const bool many_rays = rows.front().part == Part::samplers;
  const View<> seen = many_rays ? noise_view(globe, 0) : view;
  std::vector<Row*> in_turn;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    in_turn.push_back(&rows[i]);
    if (i % 10 != 9 || many_rays) continue;
    // All others are measured by the first, so it and its like with the other filter take more
    // turns: once a round, always behind the same wide packs, it came out a third too slow.
    for (Row& row : rows) {
      if (row.variant.number == NumberKind::double_ && row.variant.degree == 0 &&
          row.variant.curve == rows[0].variant.curve)
        in_turn.push_back(&row);
    }
  }
  std::vector<Work> works;
  works.reserve(in_turn.size());
  for (const Row* row : in_turn) {
    works.emplace_back([&globe, &seen, row, many_rays] {
      if (many_rays) {
        (void)sampled(globe, seen, row->variant, Sampler(row->sampler, row->samples), 1);
      } else {
        (void)picture_of(globe, seen, row->variant);
      }
    });
  }
  // Sampled pictures take longer, and their ratios are larger.
  const int rounds = many_rays ? timing.rounds / 4 + 1 : timing.rounds;
  int timed = 0;
  const auto times = work_times(works, rounds, timing.tick, [&](int round) {
    timed = round;
    return round >= 5 && timing.watch.milliseconds() >= timing.milliseconds;
  });
  timing.skipped += rounds - timed;
  if (timed < rounds && timing.tick) timing.tick(1, 1);
  for (Row& row : rows) row.took = WorkTime();
  for (std::size_t i = 0; i < in_turn.size(); ++i) {
    if (times[i].processor < in_turn[i]->took.processor) in_turn[i]->took = times[i];
    timing.rays += 1.0 * in_turn[i]->samples * seen.width * seen.height * (timed + 1);
  }
  for (Row& row : rows) row.time = row.took.processor / rows[0].took.processor;
}

WorkTime time_alone(const Globe& globe, const View<>& view) {
  const std::vector<Work> work = {[&] { (void)picture_of(globe, view, {}); }};
  return work_times(work, rounds_within(200, work, 7, 100)).front();
}

void time_rows_beside(WorkTime alone, std::span<Row> rows, const Globe& globe, const View<>& view,
                      Timing& timing) {
  std::string wrong;
  for (int attempt = 0; attempt < 3; ++attempt) {
    time_rows(rows, globe, view, timing);
    wrong = disagreement(alone, rows[0].took);
    if (wrong.empty()) return;
    // The machine may have been slow at the start. What wide code does to plain numbers lasts.
    alone.processor = std::min(alone.processor, time_alone(globe, view).processor);
  }
  throw std::runtime_error(wrong);
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
    const Variant place{.number = row.variant.number, .instructions = row.variant.instructions};
    return keeps_to(budget, row) &&
           !all.some_of(
                   Part::places,
                   [&](const Row& other) { return other.variant == place && keeps_to({}, other); })
                .empty();
  }));
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
