// The ways to draw that are tried: one row each, with its bound, what was seen of its errors, and
// its time. The table, the JSON, the plots and the recommendations walk the rows.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/interleaved.hpp"
#include "engine/compare/machine.hpp"
#include "engine/compare/plot.hpp"
#include "engine/draw/film.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/fast/budget.hpp"
#include "engine/fast/turns.hpp"
#include "engine/files/stopwatch.hpp"
#include "number/kinds/judge.hpp"
#include "sampling/samplers.hpp"
#include "scenes.hpp"

namespace texmap::chapter_13 {

/// One way to draw the globe.
struct Variant {
  NumberKind number = NumberKind::double_;
  Instructions instructions = Instructions::baseline;
  int degree = 0;  ///< of the (u, v) kernel's arc tangent; 0 for the reference formula
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;

  bool operator==(const Variant&) const = default;
};

/// What the rows of a run are about, in its order. Errors are in levels of 255, but for places.
enum class Part {
  places,    ///< every number, kernel and filter: how far off a place is, in texels
  curves,    ///< from texels through light to bytes: how far off a channel is before rounding
  samplers,  ///< samplers and samples: root mean squares over pixels and channels
};
inline constexpr std::array all_parts = {Part::places, Part::curves, Part::samplers};

/// A way that is tried.
struct Row {
  Part part;
  Variant variant = {};
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 1;  ///< rays per pixel

  double bound = 0;                  ///< never exceeded
  double worst = 0, mean = 0;        ///< seen; places nearer to the rim than least_cosine aside
  long changed = 0, may_change = 0;  ///< pixels with other bytes than the reference
  int levels = 0, levels_bound = 0;  ///< the largest change of a byte

  WorkTime took = {0, 0, 1};  ///< for one picture on one thread
  double time = 0;            ///< as a part of what the first row of its part took
};

/// Rows that something is said about.
using Rows = std::vector<const Row*>;

/// All that was measured in one run.
struct Measurements {
  Machine machine;
  int width = 0, height = 0;  ///< of the pictures of places and curves, pixels
  std::array<std::vector<Row>, all_parts.size()> parts = {};
  int skipped = 0;  ///< rounds of timing, because the time limit was reached
  double rays = 0;  ///< that were timed

  [[nodiscard]] std::vector<Row>& of(Part part) { return parts[static_cast<std::size_t>(part)]; }
  [[nodiscard]] const std::vector<Row>& of(Part part) const {
    return parts[static_cast<std::size_t>(part)];
  }
  /// Those of a part that `may_be` is true of.
  template <class MayBe>
  [[nodiscard]] Rows some_of(Part part, const MayBe& may_be) const {
    Rows some;
    for (const Row& row : of(part)) {
      if (may_be(row)) some.push_back(&row);
    }
    return some;
  }
};

/// Called with how many parts of a phase of the run are done, and how many it has.
using Tick = std::function<void(int done, int total)>;

// Which ways are tried, and how long they take (measure.cpp).

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
/// Says that every ratio would be wrong; nothing if two times of plain double, alone and among
/// others, are within a quarter, or so short that they depend on what the caches hold.
[[nodiscard]] std::string disagreement(const WorkTime& alone, const WorkTime& among);
/// The same as time_rows, and a check of it: the first row, plain double, must take as long as it
/// took `alone` before any wide instructions ran in this process.
/// Errors: std::runtime_error with the disagreement, after three timings.
void time_rows_beside(WorkTime alone, std::span<Row> rows, const Globe& globe, const View<>& view,
                      Timing& timing);

// How far off they are (errors.cpp).

/// The least cosine that the figures of places include: rays that pass the center within 0.99
/// radii, as in docs/numbers.md. Nearer to the rim a rounding of the ray may go a long way on the
/// globe.
inline constexpr double least_cosine = 0.141;

/// The worst error of the (u, v) kernel of a degree: stated by the kernels themselves, and for the
/// reference formula in docs/numbers.md.
[[nodiscard]] UvError kernel_bound(NumberKind number, int degree);

/// What another view by another seed does not exceed: the mean of those seen and 6 standard
/// deviations. Of normally distributed errors one more than `noise_views` exceeds it with a chance
/// of 1 in 2600: Student's distribution with 7 degrees of freedom at 6 / sqrt(1 + 1/8).
[[nodiscard]] double noise_bound(const std::vector<double>& errors);

/// The views of samplers, each of another part of the globe, and their size.
inline constexpr int noise_views = 8, noise_width = 80, noise_height = 60;
[[nodiscard]] View<> noise_view(const Globe& globe, int view);

/// Where a pixel's ray meets the globe, by the judge.
struct ReferenceHit {
  bool met = false;
  double cosine = 0;    ///< of the angle between normal and ray
  double from_rim = 0;  ///< how far from touching the globe the ray passes, in radii
  double round = 0;     ///< length of the circle of this v, as a part of the equator's
  Uv<Judge> uv{};
};

/// The reference of places, row by row, and the picture of it.
[[nodiscard]] std::vector<ReferenceHit> reference_hits(const Globe& globe, const View<>& view);
[[nodiscard]] Image picture_of_hits(const Globe& globe, const View<>& view, Filter filter,
                                    const std::vector<ReferenceHit>& hits);
/// Fills in the errors of a row of places.
void find_errors_of_place(Row& row, const Globe& globe, const View<>& view,
                          const std::vector<ReferenceHit>& hits);

/// The picture of a variant, one ray per pixel.
[[nodiscard]] Image picture_of(const Globe& globe, const View<>& view, const Variant& variant,
                               int threads = 1);
/// The picture that variants are compared with: by the reference formula, in Judge.
[[nodiscard]] Image reference_picture(const Globe& globe, const View<>& view, Filter filter);
/// The light that a view shows, gathered with a variant's number and kernel.
[[nodiscard]] Film sampled(const Globe& globe, const View<>& view, const Variant& variant,
                           const Sampler& sampler, int threads);
/// The light of a film as levels of 255 on the sRGB curve, not rounded to bytes.
[[nodiscard]] std::vector<double> levels_of(const Film& film);
/// Root mean square difference of two pictures' levels.
[[nodiscard]] double rms_difference(const std::vector<double>& a, const std::vector<double>& b);

/// Where two pictures differ, in the colors of `compare`'s maps.
///
/// @param reach  each pixel is drawn as far to all sides, so that a single one is seen; the larger
///               difference covers others
[[nodiscard]] Image differences(const Image& a, const Image& b, int reach);

/// Fills in the errors of the rows of one part, which may be a few of them.
///
/// @param view  of all but samplers, which have noise_views
void find_errors(std::span<Row> rows, const Globe& globe, const View<>& view, int threads,
                 const Tick& tick);

// Which is best (measure.cpp).

/// Times with a smaller ratio are treated as equal.
inline constexpr double same_time = 1.05;
/// A time with a larger spread was taken on a busy machine.
inline constexpr double quiet_spread = 1.1;

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

// What is said of them (report.cpp).

inline const char* name_of(SamplerKind kind) {
  return std::array{"random", "stratified", "multi-jitter",
                    "sobol"}[static_cast<std::size_t>(kind)];
}
inline const char* name_of(Filter filter) {
  return filter == Filter::nearest ? "nearest" : "bilinear";
}
inline const char* name_of(Curve curve) {
  return std::array{"none", "power", "exact", "4 terms",
                    "3 terms"}[static_cast<std::size_t>(curve)];
}
inline std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}
/// What a row calculates with, such as: float-pack of avx2.
[[nodiscard]] std::string number_of(const Row& row);
/// What else makes it: a kernel, a curve, or a sampler and its samples.
[[nodiscard]] std::string choice_of(const Row& row);

/// The machine as it is now, how this chapter was compiled, and the packs up to `widest`.
[[nodiscard]] Machine measuring_machine(Instructions widest);

/// Of a row's line in the table the names at its left, and the errors at its right.
[[nodiscard]] std::string names_text(const Row& row);
[[nodiscard]] std::string errors_text(const Row& row);
/// What to know of the times if the machine was busy; empty if it was not.
[[nodiscard]] std::string busy_text(const Measurements& all);
[[nodiscard]] std::string table_of(const Measurements& all);
/// The same as JSON: an object with a list for each part. A place by the nearest texel has the
/// command of chapter 07 that draws with its number and kernel.
///
/// @param texture  the globe's
[[nodiscard]] std::string json_of(const Measurements& all, const Image& texture);
/// A plot of each part.
[[nodiscard]] std::vector<Plot> plots_of(const Measurements& all);

/// The shortest budget in texels for which choose_uv_kernel takes the kernel of this degree;
/// `exact` for the reference formula.
[[nodiscard]] std::string budget_for(int degree, const Image& texture);
/// What to take for a budget, in a few lines of at most 110 columns.
[[nodiscard]] std::string recommendation(const Measurements& all, const Budget& budget,
                                         const Image& texture);

// The sheet: what some of the variants change in the picture. It shows no times: it is the same on
// every machine (show.cpp).

/// The plots' files in the order of plots_of, then the JSON file: x_speed_error.svg and so on,
/// beside x.png. There are none if the picture goes to a device.
[[nodiscard]] std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out);

/// The view of one picture of a sheet of this size.
[[nodiscard]] View<> view_of_sheet(const Globe& globe, int width, int height);
/// @param threads  as RenderSettings has them
[[nodiscard]] Image draw_sheet(const Globe& globe, int width, int height, int threads,
                               const Tick& tick);

}  // namespace texmap::chapter_13
