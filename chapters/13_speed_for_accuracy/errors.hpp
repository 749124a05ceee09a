// Draws the globe with every number, and says how far off each picture is, against the judge's.
#pragma once
#include <span>
#include <vector>

#include "engine/draw/film.hpp"
#include "number/kinds/judge.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {

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

}  // namespace texmap::chapter_13
