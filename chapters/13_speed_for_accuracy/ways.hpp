// The ways to draw that are tried: one row each, with its bound, what was seen of its errors, and
// its time. The table, the JSON, the plots and the recommendations walk the rows.
#pragma once
#include <array>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/kernels/budget.hpp"
#include "engine/kernels/turns.hpp"
#include "engine/measure/interleaved.hpp"
#include "engine/measure/machine.hpp"
#include "engine/measure/plot.hpp"
#include "engine/render/film.hpp"
#include "engine/render/number_names.hpp"
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
  TexelFormat format = TexelFormat::bytes;

  bool operator==(const Variant&) const = default;
};

/// What the rows of a run are about, in its order. Errors are in levels of 255, but for places.
enum class Part {
  places,    ///< every number, kernel and filter: how far off a place is, in texels
  curves,    ///< from texels through light to bytes: how far off a channel is before rounding
  formats,   ///< the same of both texel formats, with many rays per pixel
  samplers,  ///< samplers and samples: root mean squares over pixels and channels
  filters,   ///< of chapter 09, on checkers to the horizon: root mean squares of light
  skies,     ///< chapter 12's ways to light matte objects: root mean squares
};

/// A way that is tried.
struct Row {
  Part part;
  Variant variant = {};  ///< the plain one for filters and skies
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 1;        ///< rays per pixel
  std::string name = {};  ///< of a filter, with its taps; of a way to light, as --light has it
  std::string sky = {};   ///< of a way to light
  bool chosen = false;    ///< the way that `--light auto` takes

  double bound = 0;                  ///< never exceeded; of filters and skies, the error seen
  double worst = 0, mean = 0;        ///< seen; places nearer to the rim than least_cosine aside
  long changed = 0, may_change = 0;  ///< pixels with other bytes than the reference
  int levels = 0, levels_bound = 0;  ///< the largest change of a byte
  double reads = 0, own_error = 0;   ///< of a filter: texels per pixel; error against its ideal

  /// For one picture on one thread, milliseconds; a filter's look-up, nanoseconds; a pixel under a
  /// sky, microseconds.
  WorkTime took = {0, 0, 1};
  double time = 0;  ///< as a part of what the first row of its part took
};

/// Rows that something is said about.
using Rows = std::vector<const Row*>;

/// How often things are timed.
struct Rounds {
  int wanted = 0, timed = 0;  ///< fewer than wanted where the time limit was reached
};

/// All that was measured in one run.
struct Measurements {
  Machine machine;
  int width = 0, height = 0;   ///< of the pictures of places and curves, pixels
  std::vector<Row> rows = {};  ///< part by part; the first of each part is what times are parts of
  std::string choice = {};     ///< how far one direction is off under each sky
  double other_rays = 0;       ///< that were followed for filters and skies
  std::vector<Rounds> rounds = {};  ///< of each part

  void add(const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); }
  [[nodiscard]] std::span<Row> of(Part part);
  [[nodiscard]] std::span<const Row> of(Part part) const;
  /// Those of a part that `may_be` is true of; all of it without one.
  [[nodiscard]] Rows some_of(Part part, const std::function<bool(const Row&)>& may_be = {}) const;
};

// Which ways are tried.

/// The rows of a part but filters and skies, without errors and times. The first is plain double.
///
/// @param widest  the last set of instructions that packs are wanted of
[[nodiscard]] std::vector<Row> rows_of(Part part, Instructions widest);

/// The sets of instructions that this program has packs of and this machine can run.
[[nodiscard]] std::vector<Instructions> usable_instructions(Instructions widest);

/// The row of a variant, or nullptr.
[[nodiscard]] const Row* find_row(std::span<const Row> rows, const Variant& variant);

inline constexpr std::array sampler_kinds = {SamplerKind::random, SamplerKind::stratified,
                                             SamplerKind::multi_jitter, SamplerKind::sobol};
inline constexpr std::array sample_counts = {1, 4, 16, 64, 256};

// How far off they are (errors.cpp).

/// The least cosine that the figures of places include: rays that pass the center within 0.99
/// radii, as in docs/numbers.md. Nearer to the rim a rounding of the ray may go a long way on the
/// globe.
inline constexpr double least_cosine = 0.141;

/// The worst error of the (u, v) kernel of a degree: stated by the kernels themselves, and for the
/// reference formula in docs/numbers.md.
[[nodiscard]] UvError kernel_bound(NumberKind number, int degree);

/// By how many levels a channel, the mean of so many rays, can be off before it is rounded to a
/// byte, compared with the exact curve of the texel's bytes in the same number.
[[nodiscard]] double unrounded_bound(const Variant& variant, int rays = 1);
/// By how many levels bytes can differ if their channels differ by `unrounded` before rounding.
[[nodiscard]] int rounded_bound(double unrounded);

/// What another view by another seed does not exceed: the mean of those seen and 6 standard
/// deviations.
///
/// For normally distributed errors one more than `noise_views` = 8 exceeds it with a chance of 1 in
/// 2600: Student's distribution with 7 degrees of freedom at 6 / sqrt(1 + 1/8).
[[nodiscard]] double noise_bound(const std::vector<double>& errors);

/// The views of the parts with many rays, each of another part of the globe.
inline constexpr int noise_views = 8;
inline constexpr int noise_width = 80;
inline constexpr int noise_height = 60;
[[nodiscard]] View<> noise_view(const Globe& globe, int view);
/// Samples of the reference pictures. Their own noise is in all figures, and makes them larger.
inline constexpr int converged_samples = 1024;

/// The picture of a variant, one ray per pixel.
[[nodiscard]] Image picture_of(const Globe& globe, const View<>& view, const Variant& variant,
                               int threads = 1);
/// The picture that variants are compared with: by the reference formula, in Judge.
[[nodiscard]] Image reference_picture(const Globe& globe, const View<>& view, Filter filter,
                                      int threads = 0);
/// The light that a view shows, gathered with a variant's number, kernel and texels.
[[nodiscard]] Film sampled(const Globe& globe, const View<>& view, const Variant& variant,
                           const Sampler& sampler, int threads);
/// The light of a film as levels of 255 on the sRGB curve, not rounded to bytes.
[[nodiscard]] std::vector<double> levels_of(const Film& film);
/// Root mean square difference of two pictures' levels.
[[nodiscard]] double rms_difference(const std::vector<double>& a, const std::vector<double>& b);
/// Counts the pixels that differ between a picture and its reference, and their largest difference.
void compare_bytes(const Image& image, const Image& reference, Row& row);

/// Called once for each part of the work that is done.
using Tick = std::function<void()>;

/// Fills in the errors of the rows of one part, which may be a few of them. Of places that differ
/// in their instructions alone the first is drawn. The reference of texel formats is of bytes, with
/// the same samples.
///
/// @param view  of all but samplers, which have noise_views
/// @param seed  of the rays of texel formats
void find_errors(std::span<Row> rows, const Globe& globe, const View<>& view, int threads,
                 const Tick& tick, std::uint32_t seed = 0);

// How long they take (measure.cpp).

/// How the timing of a run goes.
struct Timing {
  int rounds;       ///< wanted
  TimeLimit limit;  ///< of all timings of the run together
  Tick tick;
  std::vector<Rounds> done = {};  ///< of the timings so far
};

/// Fills in the times of the rows of one part, taken alternately on one thread.
void time_rows(std::span<Row> rows, const Globe& globe, const View<>& view, Timing& timing);

/// What plain double takes when nothing else is timed.
[[nodiscard]] WorkTime time_alone(const Globe& globe, const View<>& view);
/// Says that every ratio would be wrong; nothing if two times of plain double, alone and among
/// others, could be the same on a busy machine: within a quarter. Those below a millisecond depend
/// on what the caches hold, and say nothing.
[[nodiscard]] std::string disagreement(const WorkTime& alone, const WorkTime& among);
/// The same as time_rows, and a check of it: the first row, plain double, must take as long among
/// the others as it took `alone` before any wide instructions ran in this process.
/// Errors: std::runtime_error with the disagreement, after three timings.
void time_rows_beside(WorkTime alone, std::span<Row> rows, const Globe& globe, const View<>& view,
                      Timing& timing);

/// Adds the rows of filters and skies, as chapters 09 and 12 measure them: errors first, which
/// depend neither on the clock nor on the threads, then times.
void measure_other_chapters(Measurements& all, int threads, Timing& timing);

/// A part of a run that the progress line names.
struct Phase {
  const char* name;
  std::size_t parts;  ///< ticks
};
/// All of a run, in their order.
[[nodiscard]] std::vector<Phase> phases_of(int rounds, Instructions widest);
/// About how many rays a whole run follows, without those of the sheet.
[[nodiscard]] double rays_of(const Measurements& all);

/// Counts the parts of a run that are done, for its progress line.
struct Ticks {
  std::vector<Phase> phases;
  std::size_t done = 0;

  void operator()(const RenderSettings& settings);
  /// What the line says at its end: the phase of the next part, nothing if all are done.
  [[nodiscard]] std::string remark() const;
};

// Which is best.

/// Times with a smaller ratio are treated as equal.
inline constexpr double same_time = 1.05;
/// A time with a larger spread was taken on a busy machine.
inline constexpr double quiet_spread = 1.1;

/// True if a row of places or curves keeps to a budget by its bounds, whatever was measured.
///
/// `exact` is what plain double draws with the reference formula; others draw the same if no
/// rounding can change a byte. Levels are the most that any pixel can change, outline and edges of
/// texels included.
[[nodiscard]] bool keeps_to(const Budget& budget, const Row& row);

/// Of rows the fastest, and of those that could be as fast, as far as the times' spread tells, the
/// most exact; nullptr of none.
[[nodiscard]] const Row* fastest(const Rows& rows);
/// The fastest of the places with a filter that keep to a budget.
[[nodiscard]] const Row* fastest(const Measurements& all, Filter filter, const Budget& budget);
/// The same of the curves, for a budget in levels: only of numbers that find every texel, since a
/// wrong one may be any number of levels off.
[[nodiscard]] const Row* fastest_light(const Measurements& all, const Budget& budget);
/// The same of samplers, filters, or the ways under a sky, with a bound of so many levels.
[[nodiscard]] const Row* fastest(const Measurements& all, Part part, double levels,
                                 const std::string& sky = {});

/// The Pareto front, from the fastest to the most exact: whatever is faster than one of them is
/// farther off. Of several as fast it has the most exact, of several as exact the fastest.
[[nodiscard]] Rows pareto_front(Rows rows);

// What is said of them (report.cpp).

/// A row's text that does not depend on the clock: the left part of a filter's, the right half of
/// the others'. Of a way under a sky: all its samples.
[[nodiscard]] std::string errors_text(const Measurements& all, const Row& row);
/// The machine as it is now, how this chapter was compiled, and the packs up to `widest`.
[[nodiscard]] Machine measuring_machine(Instructions widest);

inline const char* name_of(SamplerKind kind) {
  return std::array{"random", "stratified", "multi-jitter",
                    "sobol"}[static_cast<std::size_t>(kind)];
}
inline const char* name_of(Filter filter) {
  return filter == Filter::nearest ? "nearest" : "bilinear";
}
inline const char* name_of(TexelFormat format) {
  return format == TexelFormat::roots ? "roots" : "bytes";
}
inline const char* name_of(Curve curve) {
  return std::array{"none", "power", "exact", "4 terms",
                    "3 terms"}[static_cast<std::size_t>(curve)];
}
inline std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}
/// What a variant calculates with, such as: float-pack of avx2.
[[nodiscard]] std::string described_number(const Variant& variant);
/// Its texels and its curve, such as: roots, 4 terms; and as two columns of a table.
[[nodiscard]] std::string described_light(const Variant& variant);
[[nodiscard]] std::string columns_of_light(const Variant& variant);
/// The skies' names, in their order.
[[nodiscard]] std::vector<std::string> skies_of(const Measurements& all);

/// What to know of the times if rounds were skipped; empty if none were.
[[nodiscard]] std::string skipped_text(const Measurements& all);
/// The same if times spread by more than on a quiet machine.
[[nodiscard]] std::string busy_text(const Measurements& all);
[[nodiscard]] std::string table_of(const Measurements& all);
/// The same as JSON: an object with a list for each part.
[[nodiscard]] std::string json_of(const Measurements& all);

/// The shortest budget in texels for which choose_uv_kernel takes the kernel of this degree;
/// `exact` for the reference formula.
[[nodiscard]] std::string budget_for(int degree, const Image& texture);
/// What to take for a budget, in a few lines of at most 110 columns.
[[nodiscard]] std::string recommendation(const Measurements& all, const Budget& budget,
                                         const Image& texture);

/// The six plots of a run, in the order of names_of_report.
[[nodiscard]] std::vector<Plot> plots_of(const Measurements& all);

/// The files written beside the picture: for out/x.png, out/x_speed_error.svg and others; the last
/// one is the JSON. None if the picture goes to a device.
[[nodiscard]] std::vector<std::filesystem::path> names_of_report(const std::filesystem::path& out);

// The sheet: what some of the variants change in the picture. It shows no times: it is the same on
// every machine (show.cpp).

/// The view of one picture of a sheet of this size.
[[nodiscard]] View<> view_of_sheet(const Globe& globe, int width, int height);
/// @param threads  as RenderSettings has them
[[nodiscard]] Image draw_sheet(const Globe& globe, int width, int height, int threads,
                               const Tick& tick);

}  // namespace texmap::chapter_13
