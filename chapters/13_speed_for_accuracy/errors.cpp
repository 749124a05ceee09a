// Draws the globe with every number, and says how far off each picture is and can be at most: the
// templates of scenes.hpp are compiled here.
//
// Places. The ray through a pixel has 6 unit roundoffs u of its direction (docs/numbers.md), which
// are 6 u distance / radius at the globe, and the eye's own rounding is 1 of these; the robust form
// misjudges a ray as if it passed 3 u distance / radius elsewhere: 10 u distance / radius together.
// A ray that passes `a` radii elsewhere meets the globe a / cosine radians elsewhere, and 4.5 u are
// the normal's own.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/compare/difference.hpp"
#include "engine/render/develop.hpp"
#include "math/srgb.hpp"
#include "ways.hpp"

namespace texmap::chapter_13 {
namespace {

// What is known before a way is tried.

/// Where a pixel's ray meets the globe, by the judge.
struct ReferenceHit {
  bool met = false;
  double cosine = 0;    ///< of the angle between normal and ray
  double from_rim = 0;  ///< how far from touching the globe the ray passes, in radii
  double round = 0;     ///< length of the circle of this v, as a part of the equator's
  Uv<Judge> uv{};
};

/// The unit roundoff of a number, or of each lane of a pack.
double roundoff_of(NumberKind number) {
  if (is_float(number)) return static_cast<double>(unit_roundoff<float>());
  if (number == NumberKind::extended) return static_cast<double>(unit_roundoff<long double>());
  return unit_roundoff<double>();
}

/// How far the ray through a pixel may pass from where it should, at the globe, in radii.
double ray_bound(const Globe& globe, NumberKind number) {
  return 10 * roundoff_of(number) * globe.away / globe.sphere.radius;
}

/// How far a normal can be off, in half turns.
double normal_bound(const Globe& globe, NumberKind number, double cosine) {
  return (ray_bound(globe, number) / cosine + 4.5 * roundoff_of(number)) / std::numbers::pi;
}

/// How far a place can be off at most, in texels along u or v, for all hits that are not nearer to
/// the rim than `least_cosine`, for any view: the kernel's error and the normal's.
double texels_bound(const Globe& globe, NumberKind number, int degree) {
  const UvError kernel = kernel_bound(number, degree);
  const double angle = normal_bound(globe, number, least_cosine);
  return std::max((kernel.u + angle / 2) * globe.nearest.image.width,
                  (kernel.v + angle) * globe.nearest.image.height);
}

/// How far a place on the texture can be off, in texels along u and along v.
struct PlaceBound {
  double columns = 0, rows = 0;
};

/// How far the place that is looked up can be off; near the poles a little way is much along u. 2
/// unit roundoffs of 1 are those of the look-up (texel.hpp, bilinear.hpp), and 2 of double those of
/// the place that is compared here.
PlaceBound place_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit) {
  const UvError kernel = kernel_bound(variant.number, variant.degree);
  const double angle = normal_bound(globe, variant.number, hit.cosine);
  const double round = std::max(hit.round - angle, 1e-9);
  const double look_up = 2 * roundoff_of(variant.number) + 2 * unit_roundoff<double>();
  return {(kernel.u + angle / 2 / round + look_up) * globe.nearest.image.width,
          (kernel.v + angle + look_up) * globe.nearest.image.height};
}

/// The largest difference, in levels of 255 after rounding to bytes, between the color at a place
/// and those of the places around.
///
/// Texels are plain between their edges, and a filtered color is bilinear between the lines of
/// their centers: all that there is, or the least and the largest, is where these lines and the
/// sides of the rectangle of `off` cross.
/// @param lines  where they lie between two whole numbers: 0 for edges, 0.5 for centers
/// @param room   levels that mixing may be off by
template <class Texture>
int levels_around(const Texture& texture, double x, double y, const PlaceBound& off, double lines,
                  double room) {
  const auto between = [lines](double at, double reach) {
    std::vector<double> all = {at - reach};
    const auto first = static_cast<int>(std::floor(at - reach - lines)) + 1;
    for (int k = first; k + lines <= at + reach; ++k) all.push_back(k + 0.5);
    all.push_back(at + reach);
    return all;
  };
  const auto channels_at = [&](double column, double row) {
    const double u = column / texture.image.width;
    const Rgb color = texture(Uv<double>{u - std::floor(u), row / texture.image.height});
    return std::array{color.r * 255, color.g * 255, color.b * 255};
  };
  const auto right = channels_at(x, y);
  const auto rows = between(y, off.rows);
  int levels = 0;
  for (const double column : between(x, off.columns)) {
    for (const double row : rows) {
      const auto other = channels_at(column, row);
      for (std::size_t k = 0; k < 3; ++k) {
        const double byte = std::floor(right[k] + 0.5);
        levels = std::max({levels, static_cast<int>(byte - std::floor(other[k] - room + 0.5)),
                           static_cast<int>(std::floor(other[k] + room + 0.5) - byte)});
      }
    }
  }
  return levels;
}

/// By how many levels of 255 a pixel can be off; 0 if no rounding can change its bytes. A pixel
/// may change by all 255 if its ray is so near to the rim that a rounding may take it past it.
int levels_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit) {
  if (hit.from_rim <= ray_bound(globe, variant.number)) return 255;
  if (!hit.met) return 0;
  const Image& image = globe.nearest.image;
  const PlaceBound off = place_bound(globe, variant, hit);
  if (off.columns >= image.width || off.rows >= image.height) return 255;
  const auto x = static_cast<double>(hit.uv.u * Judge(image.width));
  const auto y = static_cast<double>(hit.uv.v * Judge(image.height));
  if (variant.filter == Filter::nearest) return levels_around(globe.nearest, x, y, off, 0, 0);
  const double mixing = 255 * 8 * roundoff_of(variant.number);  // 8 unit roundoffs are allowed for
  return levels_around(globe.bilinear, x, y, off, 0.5, mixing);
}

// What is seen.

OneRayScene scene_of(const Globe& globe, const Variant& variant) {
  return {&globe, {variant.degree}, variant.filter, variant.curve, variant.format};
}

/// work(std::type_identity<Real>{}) with the type of a number. Packs of all widths calculate the
/// same (tests/packs): errors are found with those that every machine has.
template <class Work>
void with_real(NumberKind number, const Work& work) {
  switch (number) {
    case NumberKind::float_:
      return work(std::type_identity<float>{});
    case NumberKind::extended:
      return work(std::type_identity<long double>{});
    case NumberKind::float_pack:
      return work(std::type_identity<Pack<float>>{});
    case NumberKind::double_pack:
      return work(std::type_identity<Pack<double>>{});
    default:
      return work(std::type_identity<double>{});
  }
}

/// visit(pixel, at) for all pixels: at(k) is the number k of those that `numbers_along` makes of
/// the pixel's ray.
///
/// @param numbers_along  called with rays of Real; gives an array of Reals
template <class Real, class NumbersAlong, class Visit>
void for_each_pixel(const View<>& view, const NumbersAlong& numbers_along, const Visit& visit) {
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; column += static_cast<int>(lanes<Real>)) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns =
          from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      const auto numbers = numbers_along(ray_through(view, columns, Real(row)));
      for (std::size_t i = 0; i < lanes<Real> && column + static_cast<int>(i) < view.width; ++i) {
        visit(static_cast<std::size_t>(row * view.width + column) + i,
              [&](std::size_t k) { return lane(numbers[k], i); });
      }
    }
  }
}

/// The reference of places: where each pixel's ray meets the globe, by the reference formula.
std::vector<ReferenceHit> reference_hits(const Globe& globe, const View<>& view) {
  std::vector<ReferenceHit> hits;
  const auto along = [&](const Ray<Judge>& ray) {
    const Vec3<Judge> moment =
        cross(ray.origin - number_cast<Judge>(globe.sphere.center), ray.direction);
    const Judge passes = length(moment) / Judge(globe.sphere.radius);
    const Judge distance = distance_to(globe.sphere, ray);
    ReferenceHit& hit = hits.emplace_back();
    hit.met = distance < infinity<Judge>();
    hit.from_rim = static_cast<double>(abs(passes - Judge(1)));
    if (hit.met) {
      const Vec3<Judge> normal = normal_at(globe.sphere, ray, distance);
      hit.cosine = static_cast<double>(-dot(normal, ray.direction));
      hit.round = static_cast<double>(sqrt(square(normal.x) + square(normal.z)));
      hit.uv = uv_rtiow(normal);
    }
    return std::array<Judge, 0>{};
  };
  for_each_pixel<Judge>(view, along, [](std::size_t, const auto&) {});
  return hits;
}

/// Compares the places that numbers of type Real find with the reference's.
template <class Real>
void measure_places(Row& row, const Globe& globe, const View<>& view,
                    const std::vector<ReferenceHit>& hits) {
  const PlannedMapping mapping{row.variant.degree};
  double sum = 0;
  long count = 0;
  const auto place_along = [&](const Ray<Real>& ray) {
    const Real distance = distance_to(globe.sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    const Uv<Real> uv = mapping(normal_at(globe.sphere, ray, select(met, distance, Real(1))));
    return std::array{uv.u, uv.v};
  };
  for_each_pixel<Real>(view, place_along, [&](std::size_t pixel, const auto& at) {
    const ReferenceHit& hit = hits[pixel];
    if (!hit.met || hit.cosine < least_cosine) return;
    const Judge across = abs(Judge(at(0)) - hit.uv.u);  // u = 0 and u = 1 are one place
    const Judge along_u =
        min(across, Judge(1) - across) * Judge(hit.round) * Judge(globe.nearest.image.width);
    const Judge along_v = abs(Judge(at(1)) - hit.uv.v) * Judge(globe.nearest.image.height);
    const auto texels = static_cast<double>(max(along_u, along_v));
    row.worst = std::max(row.worst, texels);
    sum += texels;
    ++count;
  });
  row.mean = count > 0 ? sum / static_cast<double>(count) : 0;
}

/// Errors of places and their bytes.
void find_errors_of_place(Row& row, const Globe& globe, const View<>& view,
                          const std::vector<ReferenceHit>& hits, const Image& reference) {
  row.bound = texels_bound(globe, row.variant.number, row.variant.degree);
  for (const ReferenceHit& hit : hits) {
    const int levels = levels_bound(globe, row.variant, hit);
    row.may_change += levels > 0 ? 1 : 0;
    row.levels_bound = std::max(row.levels_bound, levels);
  }
  with_real(row.variant.number, [&]<class Real>(std::type_identity<Real>) {
    measure_places<Real>(row, globe, view, hits);
  });
  compare_bytes(picture_of(globe, view, row.variant, 0), reference, row);
}

/// States how far off a row's levels can be, and compares them before they are bytes: each pixel's
/// red, green and blue. A pixel may change if the bound takes a level of the reference across an
/// edge between two bytes.
void compare_levels(Row& row, const std::vector<double>& levels,
                    const std::vector<double>& reference) {
  row.bound = unrounded_bound(row.variant, row.samples);
  row.levels_bound = rounded_bound(row.bound);
  bool may_change = false;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double off = std::abs(levels[i] - reference[i]);
    row.worst = std::max(row.worst, off);
    row.mean += off;
    may_change = may_change || std::floor(reference[i] - row.bound + 0.5) <
                                   std::floor(reference[i] + row.bound + 0.5);
    if (i % 3 != 2) continue;
    row.may_change += may_change ? 1 : 0;
    may_change = false;
  }
  row.mean /= static_cast<double>(levels.size());
}

/// The levels of a picture with one ray per pixel, before they are rounded to bytes.
std::vector<double> unrounded_levels(const Globe& globe, const View<>& view,
                                     const Variant& variant) {
  const OneRayScene scene = scene_of(globe, variant);
  std::vector<double> levels;
  with_real(variant.number, [&]<class Real>(std::type_identity<Real>) {
    const auto levels_along = [&](const Ray<Real>& ray) {
      const Color<Real> light = scene.color_along(ray);
      return std::array{scene.level_of_light(light.r), scene.level_of_light(light.g),
                        scene.level_of_light(light.b)};
    };
    for_each_pixel<Real>(view, levels_along, [&](std::size_t, const auto& at) {
      for (std::size_t k = 0; k < 3; ++k) levels.push_back(static_cast<double>(at(k)));
    });
  });
  return levels;
}

/// The reference is the exact curve of the texels' bytes, drawn with the same number: where a place
/// is off, both are.
void find_errors_of_light(Row& row, const Globe& globe, const View<>& view) {
  Variant variant = row.variant;
  variant.instructions = Instructions::baseline;
  Variant exact = variant;
  exact.curve = Curve::exact;
  exact.format = TexelFormat::bytes;
  compare_levels(row, unrounded_levels(globe, view, variant), unrounded_levels(globe, view, exact));
  compare_bytes(picture_of(globe, view, variant, 0), picture_of(globe, view, exact, 0), row);
}

/// The same of the mean of many rays.
void find_errors_of_samples(Row& row, const Globe& globe, const View<>& view, std::uint32_t seed,
                            int threads) {
  const Sampler sampler(row.sampler, row.samples, seed);
  Variant of_bytes = row.variant;
  of_bytes.format = TexelFormat::bytes;
  const Film film = sampled(globe, view, row.variant, sampler, threads);
  const Film reference = sampled(globe, view, of_bytes, sampler, threads);
  compare_levels(row, levels_of(film), levels_of(reference));
  compare_bytes(develop(film, Transfer::srgb), develop(reference, Transfer::srgb), row);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void find_errors_of_places(std::span<Row> rows, const Globe& globe, const View<>& view,
                           const Tick& tick) {
  const auto hits = reference_hits(globe, view);
  const std::array references = {reference_picture(globe, view, Filter::nearest),
                                 reference_picture(globe, view, Filter::bilinear)};
  for (Row& row : rows) {
    Variant first = row.variant;
    first.instructions = Instructions::baseline;
    if (row.variant == first) {
      const auto& reference = references[static_cast<std::size_t>(first.filter)];
      find_errors_of_place(row, globe, view, hits, reference);
    } else {
      const Variant own = row.variant;
      row = *find_row(rows, first);
      row.variant = own;
    }
    tick();
  }
}

/// The errors of samplers, each view with a seed of its own.
void find_errors_of_samplers(std::span<Row> rows, const Globe& globe, int threads,
                             const Tick& tick) {
  const auto levels = [&](const Row& row, int view, SamplerKind kind, int samples, int seed) {
    const Sampler sampler(kind, samples, static_cast<std::uint32_t>(seed));
    return levels_of(sampled(globe, noise_view(globe, view), row.variant, sampler, threads));
  };
  std::vector<std::vector<double>> references;
  for (int i = 0; i < noise_views; ++i) {
    references.push_back(levels(rows[0], i, SamplerKind::sobol, converged_samples, 1000 + i));
    tick();
  }
  for (Row& row : rows) {
    std::vector<double> errors;
    errors.reserve(noise_views);
    for (int i = 0; i < noise_views; ++i) {
      errors.push_back(rms_difference(levels(row, i, row.sampler, row.samples, i),
                                      references[static_cast<std::size_t>(i)]));
    }
    row.mean = mean_of(errors);
    row.bound = noise_bound(errors);
    tick();
  }
}

}  // namespace

View<> Globe::view(int width, int height, double east, double up) const {
  const double to_radians = std::numbers::pi / 180;
  const double out = away * std::cos(up * to_radians);
  const Point eye{out * std::sin(east * to_radians), away * std::sin(up * to_radians),
                  out * std::cos(east * to_radians)};
  return view_of(Camera{.eye = eye, .target = sphere.center, .fov_y_degrees = 16}, width, height);
}

View<> noise_view(const Globe& globe, int view) {
  return globe.view(noise_width, noise_height, 45 * view, view % 2 == 0 ? 25 : -25);
}

UvError kernel_bound(NumberKind number, int degree) {
  const double roundoff = roundoff_of(number);
  return with_uv_mapping(degree, [&](const auto& mapping) -> UvError {
    using Mapping = std::decay_t<decltype(mapping)>;
    if constexpr (requires { Mapping::template worst<double>; }) {
      if (is_float(number)) return Mapping::template worst<float>;
      return Mapping::template worst<double>;
    } else {
      const double texels = is_float(number)                               ? 0.001
                            : roundoff == roundoff_of(NumberKind::double_) ? 2e-12
                                                                           : 1e-15;
      return {texels / 8192, texels / 4096};  // stated in texels of 8192 by 4096
    }
  });
}

double unrounded_bound(const Variant& variant, int rays) {
  if (variant.curve == Curve::exact && variant.format == TexelFormat::bytes) return 0;
  const double polynomial = variant.curve == Curve::three  ? fits::SrgbCurve<3>::worst
                            : variant.curve == Curve::four ? fits::SrgbCurve<4>::worst
                                                           : 0;
  const double roots = variant.format == TexelFormat::roots ? RootTexture::worst_levels : 0;
  // Light has 10 unit roundoffs of table, root, square and sky, and each of its own is at most 112
  // levels (255 * 1.055 / 2.4); the curve has 6 of 255 levels, in the variant and in the reference:
  // 5000 are enough. Both sums of a mean have 250 for each ray but the first, and both films round
  // light to 2^-32 of itself.
  const double film = rays > 1 ? 2 * 112 * 0x1p-32 : 0;
  return polynomial + roots + film + (5000 + 250.0 * (rays - 1)) * roundoff_of(variant.number);
}

int rounded_bound(double unrounded) { return static_cast<int>(std::ceil(unrounded)); }

double noise_bound(const std::vector<double>& errors) {
  const double mean = mean_of(errors);
  double squares = 0;
  for (const double error : errors) squares += square(error - mean);
  return mean + 6 * std::sqrt(squares / static_cast<double>(errors.size() - 1));
}

Image picture_of(const Globe& globe, const View<>& view, const Variant& variant, int threads) {
  const OneRayScene scene = scene_of(globe, variant);
  const RenderSettings settings{.threads = threads, .instructions = variant.instructions};
  return run_in_number(DrawWork<OneRayScene>{scene, view, settings}, variant.number,
                       variant.instructions);
}

Image reference_picture(const Globe& globe, const View<>& view, Filter filter, int threads) {
  return render<Judge>(ReferenceScene{&globe, filter}, view, {.threads = threads});
}

Film sampled(const Globe& globe, const View<>& view, const Variant& variant, const Sampler& sampler,
             int threads) {
  const ManyRayScene scene{{{globe.sphere, {{variant.degree}, {&globe, variant.format}}}},
                           {.sky = {.below = globe.sky, .above = globe.sky}}};
  return gather(scene, scene.objects, view, {sampler}, {}, variant.number,
                {.threads = threads, .instructions = variant.instructions});
}

std::vector<double> levels_of(const Film& film) {
  std::vector<double> levels;
  for (int row = 0; row < film.height(); ++row) {
    for (int column = 0; column < film.width(); ++column) {
      const Rgb light = film.light(column, row);
      for (const double channel : {light.r, light.g, light.b})
        levels.push_back(255 * srgb_encode(channel));
    }
  }
  return levels;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += square(a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

void compare_bytes(const Image& image, const Image& reference, Row& row) {
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const int levels = channel_difference(image.pixels[i], reference.pixels[i]);
    row.changed += levels > 0 ? 1 : 0;
    row.levels = std::max(row.levels, levels);
  }
}

void find_errors(std::span<Row> rows, const Globe& globe, const View<>& view, int threads,
                 const Tick& tick, std::uint32_t seed) {
  const Part part = rows.front().part;
  if (part == Part::places) return find_errors_of_places(rows, globe, view, tick);
  if (part == Part::samplers) return find_errors_of_samplers(rows, globe, threads, tick);
  for (Row& row : rows) {
    if (part == Part::curves) find_errors_of_light(row, globe, view);
    if (part == Part::formats) find_errors_of_samples(row, globe, view, seed, threads);
    tick();
  }
}

}  // namespace texmap::chapter_13
