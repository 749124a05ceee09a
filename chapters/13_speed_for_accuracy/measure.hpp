// Which ways are tried, how long they take, and which is best.
#pragma once
#include <span>
#include <vector>

#include "engine/fast/budget.hpp"
#include "engine/files/stopwatch.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {

/// The rows of a part, without errors and times. The first is plain double.
///
/// @param widest  the widest instructions that packs may be made of
[[nodiscard]] std::vector<Row> rows_of(Part part, Instructions widest);

/// The sets of instructions that this program has packs of and this machine can run.
[[nodiscard]] std::vector<Instructions> usable_instructions(Instructions widest);

inline constexpr std::array sampler_kinds = {SamplerKind::random, SamplerKind::stratified,
                                             SamplerKind::multi_jitter, SamplerKind::sobol};
inline constexpr std::array sample_counts = {1, 4, 16, 64, 256};

/// How the timing of a run goes.
struct Timing {
  int rounds;           ///< wanted
  double milliseconds;  ///< of all timings together: then rounds beyond the fifth are skipped
  Tick tick;
  Stopwatch watch = {};
  int skipped = 0;  ///< rounds
  double rays = 0;
};

/// Fills in the times of the rows of one part, taken alternately on one thread.
void time_rows(std::span<Row> rows, const Globe& globe, const View<>& view, Timing& timing);

/// What plain double takes when nothing else is timed.
[[nodiscard]] WorkTime time_alone(const Globe& globe, const View<>& view);
/// The same as time_rows, and a check of it: the first row, plain double, must take as long as it
/// took `alone` before any wide instructions ran in this process.
/// Errors: std::runtime_error with the disagreement, after three timings.
void time_rows_beside(WorkTime alone, std::span<Row> rows, const Globe& globe, const View<>& view,
                      Timing& timing);

/// True if a row of places or curves keeps to a budget by its bounds, whatever was measured. It is
/// `exact` if it is plain double with the reference formula, or if no rounding can change a byte.
[[nodiscard]] bool keeps_to(const Budget& budget, const Row& row);

/// Of rows the fastest, and of those that could be as fast, as far as the times' spread tells, the
/// most exact; nullptr of none. Or of the places with a filter that keep to a budget.
[[nodiscard]] const Row* fastest(const Rows& rows);
[[nodiscard]] const Row* fastest(const Measurements& all, Filter filter, const Budget& budget);
/// The same of the curves, for a budget in levels: only of numbers that find every texel, since a
/// wrong one may be any number of levels off.
[[nodiscard]] const Row* fastest_light(const Measurements& all, const Budget& budget);
/// The Pareto front, from the fastest to the most exact: whatever is faster than one of them is
/// farther off. Of several as fast it has the most exact, of several as exact the fastest.
[[nodiscard]] Rows pareto_front(Rows rows);

}  // namespace texmap::chapter_13
