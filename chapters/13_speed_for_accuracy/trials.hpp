// The trials: how far off every variant is, and how long it takes.
#pragma once
#include <functional>
#include <vector>

#include "bounds.hpp"
#include "engine/measure/interleaved.hpp"
#include "engine/render/film.hpp"
#include "sampling/samplers.hpp"
#include "texture/image.hpp"

namespace texmap::chapter_13 {

/// Called once for each part of the work that is done.
using Tick = std::function<void()>;

/// The picture of a variant, one ray per pixel.
[[nodiscard]] Image picture_of(const Globe& globe, const View<>& view, const Variant& variant,
                               int threads = 1);

/// The picture that variants are compared with: by the reference formula, in Judge.
[[nodiscard]] Image reference_picture(const Globe& globe, const View<>& view, Filter filter,
                                      int threads = 0);

/// The light that a view shows, gathered with a variant's number, kernel and texels.
[[nodiscard]] Film sampled(const Globe& globe, const View<>& view, const Variant& variant,
                           const Sampler& sampler, int threads);

/// The reference of places: where each pixel's ray meets the globe, by the reference formula in
/// Judge.
[[nodiscard]] std::vector<ReferenceHit> reference_hits(const Globe& globe, const View<>& view);

/// Counts the pixels that differ between a picture and its reference, and their largest difference.
void compare_bytes(const Image& image, const Image& reference, Errors& errors);

/// How far off the places and the bytes of a variant are in a view, and how far they can be.
///
/// @param reference  the reference_picture of the variant's filter
[[nodiscard]] Errors errors_of_places(const Globe& globe, const View<>& view,
                                      const Variant& variant, const std::vector<ReferenceHit>& hits,
                                      const Image& reference);
/// Fills in the errors of all variants. One that differs from another in its instructions alone has
/// the other's.
void find_errors_of_places(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                           const Tick& tick);

/// How far off a variant's levels and bytes are in a view, and how far they can be. The reference
/// is the exact curve of the texels' bytes, drawn with the same number: where a place is off, both
/// are.
[[nodiscard]] Errors errors_of_light(const Globe& globe, const View<>& view, Variant variant);

void find_errors_of_curves(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                           const Tick& tick);

/// The same of a sampled picture; the reference has the same samples.
[[nodiscard]] Errors errors_of_samples(const Globe& globe, const View<>& view,
                                       const Variant& variant, const Sampler& sampler, int threads);

/// The light of a film as levels of 255 on the sRGB curve, not rounded to bytes.
[[nodiscard]] std::vector<double> levels_of(const Film& film);

/// How often things are timed.
struct Rounds {
  int wanted = 0, timed = 0;  ///< fewer than wanted where the time limit was reached
};

/// How the timing of a run goes.
struct Timing {
  int rounds;       ///< wanted
  TimeLimit limit;  ///< of all timings of the run together
  Tick tick;
  std::vector<Rounds> done = {};  ///< of the timings so far
};

/// The times of works, noted in `timing`, which ticks for the first `ticks` works of every round,
/// and for skipped rounds all at once.
[[nodiscard]] std::vector<WorkTime> timed_alternately(const std::vector<Work>& works, int rounds,
                                                      std::size_t ticks, Timing& timing);

/// Fills in the times of all trials, taken alternately on one thread; `time` is a part of the first
/// one's.
void time_trials(std::vector<Trial>& trials, const Globe& globe, const View<>& view,
                 Timing& timing);

/// What plain double takes when nothing else is timed.
[[nodiscard]] WorkTime time_alone(const Globe& globe, const View<>& view);

/// True if two times of one work could be the same on a busy machine: within a quarter. Those below
/// a millisecond depend on what the caches hold, and say nothing.
[[nodiscard]] bool agree(const WorkTime& a, const WorkTime& b);
/// Errors: std::runtime_error if plain double alone and among others do not: every ratio would be
/// wrong.
void require_agreement(const WorkTime& alone, const WorkTime& among);

/// The same as time_trials, and a check of it: the first trial, plain double, must take as long
/// among the others as it took `alone` before any wide instructions ran in this process.
/// Errors: those of require_agreement, after three timings.
void time_trials_beside(const WorkTime& alone, std::vector<Trial>& trials, const Globe& globe,
                        const View<>& view, Timing& timing);

}  // namespace texmap::chapter_13
