// Draws the globe with every number, and says how far off each picture is and can be at most: the
// templates of scenes.hpp are compiled here.
//
// Places. The ray through a pixel has 6 unit roundoffs u of its direction (docs/numbers.md), which
// are 6 u distance / radius at the globe, and the eye's own rounding is 1 of these; the robust form
// misjudges a ray as if it passed (5 + 1.2 distance / radius) u elsewhere. From 3 radii away on
// that is at most 3 u distance / radius: 10 together.
// A ray that passes `a` radii elsewhere meets the globe a / cosine radians elsewhere, and 4.5 u are
// the normal's own.
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <numeric>

#include "engine/compare/difference.hpp"
#include "engine/draw/develop.hpp"
#include "engine/draw/threads.hpp"
#include "errors.hpp"
#include "math/srgb.hpp"

namespace texmap::chapter_13 {
namespace {

// What is known before a way is tried.

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

/// How far the place that is looked up can be off, in texels along u and along v; near the poles a
/// little way is much along u. 2 unit roundoffs of 1 are those of the look-up (texel.hpp,
/// bilinear.hpp), and 2 of double those of the place that is compared here.
UvError place_bound(const Globe& globe, const Variant& variant, const ReferenceHit& hit) {
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
int levels_around(const Texture& texture, double x, double y, const UvError& off, double lines,
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
  const auto rows = between(y, off.v);
  int levels = 0;
  for (const double column : between(x, off.u)) {
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
  const UvError off = place_bound(globe, variant, hit);
  if (off.u >= image.width || off.v >= image.height) return 255;
  const auto x = static_cast<double>(hit.uv.u * Judge(image.width));
  const auto y = static_cast<double>(hit.uv.v * Judge(image.height));
  if (variant.filter == Filter::nearest) return levels_around(globe.nearest, x, y, off, 0, 0);
  const double mixing = 255 * 8 * roundoff_of(variant.number);  // 8 unit roundoffs are allowed for
  return levels_around(globe.bilinear, x, y, off, 0.5, mixing);
}

// What is seen.

OneRayScene scene_of(const Globe& globe, const Variant& variant) {
  return {&globe, {variant.degree}, variant.filter, variant.curve};
}

/// The three numbers that `along` makes of each pixel's ray, calculated with a number, row by row.
/// Packs of all widths calculate the same (tests/packs): those that every machine has are used.
///
/// @param along  called with rays of any Real; gives an array of Reals
template <class Along>
std::vector<std::array<Judge, 3>> along_rays(NumberKind number, const View<>& view,
                                             const Along& along) {
  std::vector<std::array<Judge, 3>> pixels;
  const auto visit = [&]<class Real>(std::type_identity<Real>) {
    for (int row = 0; row < view.height; ++row) {
      for (int column = 0; column < view.width; column += static_cast<int>(lanes<Real>)) {
        const auto first = static_cast<Scalar<Real>>(column);
        const Real columns = from_lanes<Real>(
            [first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
        const std::array<Real, 3> three = along(ray_through(view, columns, Real(row)));
        for (std::size_t i = 0; i < lanes<Real> && column + static_cast<int>(i) < view.width; ++i) {
          pixels.push_back(
              {Judge(lane(three[0], i)), Judge(lane(three[1], i)), Judge(lane(three[2], i))});
        }
      }
    }
  };
  if (number == NumberKind::float_) visit(std::type_identity<float>{});
  if (number == NumberKind::double_) visit(std::type_identity<double>{});
  if constexpr (wide_numbers) {
    if (number == NumberKind::extended) visit(std::type_identity<long double>{});
  }
  if constexpr (pack_numbers) {
    if (number == NumberKind::float_pack) visit(std::type_identity<Pack<float>>{});
    if (number == NumberKind::double_pack) visit(std::type_identity<Pack<double>>{});
  }
  return pixels;
}

/// Counts the pixels that differ between a picture and its reference, and their largest difference.
void compare_bytes(const Image& image, const Image& reference, Row& row) {
  const Figures figures = texmap::measure(image, reference, {}, Detail::pixels);
  row.changed = static_cast<long>(figures.pixels_different);
  row.levels = figures.worst.levels;
}

/// By how many levels a channel can be off before it is rounded to a byte, compared with the exact
/// curve in the same number.
double unrounded_bound(const Variant& variant) {
  if (variant.curve == Curve::exact) return 0;
  const double polynomial = variant.curve == Curve::three  ? fits::SrgbCurve<3>::worst
                            : variant.curve == Curve::four ? fits::SrgbCurve<4>::worst
                                                           : 0;
  // Light has 10 unit roundoffs of table, root, square and sky, and each of its own is at most 112
  // levels (255 * 1.055 / 2.4); the curve has 6 of 255 levels, in the variant and in the reference:
  // 5000 are enough.
  return polynomial + 5000 * roundoff_of(variant.number);
}

/// States how far off a row's levels can be, and compares each pixel's red, green and blue before
/// and after they are bytes. A pixel may change if the bound takes a level of the reference across
/// an edge between two bytes. The reference is the exact curve, drawn with the same number: where a
/// place is off, both are.
void find_errors_of_curve(Row& row, const Globe& globe, const View<>& view) {
  Variant exact = row.variant;
  exact.curve = Curve::exact;
  const auto levels_of = [&](const Variant& variant) {
    const OneRayScene scene = scene_of(globe, variant);
    return along_rays(variant.number, view, [&]<class Real>(const Ray<Real>& ray) {
      const Color<Real> light = scene.color_along(ray);
      return std::array{scene.level_of_light(light.r), scene.level_of_light(light.g),
                        scene.level_of_light(light.b)};
    });
  };
  const auto levels = levels_of(row.variant), reference = levels_of(exact);
  row.bound = unrounded_bound(row.variant);
  row.levels_bound = static_cast<int>(std::ceil(row.bound));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    bool may_change = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto right = static_cast<double>(reference[i][k]);
      const double off = std::abs(static_cast<double>(levels[i][k]) - right);
      row.worst = std::max(row.worst, off);
      row.mean += off / (3 * static_cast<double>(levels.size()));
      may_change =
          may_change || std::floor(right - row.bound + 0.5) < std::floor(right + row.bound + 0.5);
    }
    row.may_change += may_change ? 1 : 0;
  }
  compare_bytes(picture_of(globe, view, row.variant), picture_of(globe, view, exact), row);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Samples of the samplers' references. Their own noise is in all figures, and makes them larger.
constexpr int converged_samples = 1024;

/// The errors of samplers, each view with a seed of its own.
void find_errors_of_samplers(std::span<Row> rows, const Globe& globe, int threads,
                             const Tick& tick) {
  int done = 0;
  const auto told = [&] { tick(++done, noise_views + static_cast<int>(rows.size())); };
  const auto levels = [&](const Row& row, int view, const Sampler& sampler) {
    return levels_of(sampled(globe, noise_view(globe, view), row.variant, sampler, threads));
  };
  std::vector<std::vector<double>> references;
  for (int i = 0; i < noise_views; ++i) {
    const auto seed = static_cast<std::uint32_t>(1000 + i);
    references.push_back(levels(rows[0], i, Sampler(SamplerKind::sobol, converged_samples, seed)));
    told();
  }
  for (Row& row : rows) {
    std::vector<double> errors;
    errors.reserve(noise_views);
    for (std::uint32_t i = 0; i < noise_views; ++i) {
      const Sampler sampler(row.sampler, row.samples, i);
      errors.push_back(rms_difference(levels(row, static_cast<int>(i), sampler), references[i]));
    }
    row.mean = mean_of(errors);
    row.bound = noise_bound(errors);
    told();
  }
}

}  // namespace

std::vector<ReferenceHit> reference_hits(const Globe& globe, const View<>& view) {
  std::vector<ReferenceHit> hits;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Ray<Judge> ray = ray_through(view, Judge(column), Judge(row));
      const Vec3<Judge> moment =
          cross(ray.origin - number_cast<Judge>(globe.sphere.center), ray.direction);
      const Judge passes = length(moment) / Judge(globe.sphere.radius);
      const Judge distance = distance_to(globe.sphere, ray);
      ReferenceHit& hit = hits.emplace_back();
      hit.met = distance < infinity<Judge>();
      hit.from_rim = static_cast<double>(abs(passes - Judge(1)));
      if (!hit.met) continue;
      const Vec3<Judge> normal = normal_at(globe.sphere, ray, distance);
      hit.cosine = static_cast<double>(-dot(normal, ray.direction));
      hit.round = static_cast<double>(sqrt(square(normal.x) + square(normal.z)));
      hit.uv = uv_rtiow(normal);
    }
  }
  return hits;
}

Image picture_of_hits(const Globe& globe, const View<>& view, Filter filter,
                      const std::vector<ReferenceHit>& hits) {
  Image image(view.width, view.height);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    Color<Judge> color = number_cast<Judge>(globe.sky);
    if (hits[i].met) {
      const Uv<Judge>& uv = hits[i].uv;
      color = filter == Filter::nearest ? globe.nearest(uv) : globe.bilinear(uv);
    }
    const auto byte = [](const Judge& channel) {  // the middle of it: see OneRayScene
      return byte_of(static_cast<double>(channel + Judge(0.5 / 255)));
    };
    image.pixels[i] = {byte(color.r), byte(color.g), byte(color.b)};
  }
  return image;
}

void find_errors_of_place(Row& row, const Globe& globe, const View<>& view,
                          const std::vector<ReferenceHit>& hits) {
  const PlannedMapping mapping{row.variant.degree};
  const auto places = along_rays(row.variant.number, view, [&]<class Real>(const Ray<Real>& ray) {
    const Real distance = distance_to(globe.sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    const Uv<Real> uv = mapping(normal_at(globe.sphere, ray, select(met, distance, Real(1))));
    return std::array<Real, 3>{uv.u, uv.v, Real(0)};
  });
  row.bound = texels_bound(globe, row.variant.number, row.variant.degree);
  long count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const ReferenceHit& hit = hits[i];
    const int levels = levels_bound(globe, row.variant, hit);
    row.may_change += levels > 0 ? 1 : 0;
    row.levels_bound = std::max(row.levels_bound, levels);
    if (!hit.met || hit.cosine < least_cosine) continue;
    const Judge across = abs(places[i][0] - hit.uv.u);  // u = 0 and u = 1 are one place
    const Judge along_u =
        min(across, Judge(1) - across) * Judge(hit.round) * Judge(globe.nearest.image.width);
    const Judge along_v = abs(places[i][1] - hit.uv.v) * Judge(globe.nearest.image.height);
    const auto texels = static_cast<double>(max(along_u, along_v));
    row.worst = std::max(row.worst, texels);
    row.mean += texels;
    ++count;
  }
  if (count > 0) row.mean /= static_cast<double>(count);
  compare_bytes(picture_of(globe, view, row.variant),
                picture_of_hits(globe, view, row.variant.filter, hits), row);
}

View<> Globe::view(int width, int height, double east, double up) const {
  const double to_radians = std::numbers::pi / 180;
  const double out = away * cos(up * to_radians);
  const Point eye{out * sin(east * to_radians), away * sin(up * to_radians),
                  out * cos(east * to_radians)};
  return view_of(Camera{.eye = eye, .target = sphere.center, .fov_y_degrees = 16}, width, height);
}

View<> noise_view(const Globe& globe, int view) {
  return globe.view(noise_width, noise_height, 45 * view, view % 2 == 0 ? 25 : -25);
}

UvError kernel_bound(NumberKind number, int degree) {
  if (degree != 0) return worst_uv_error(degree, is_float(number));
  // The reference formula's is stated in texels of 8192 by 4096.
  const double texels = is_float(number) ? 0.001 : number == NumberKind::extended ? 1e-15 : 2e-12;
  return {texels / 8192, texels / 4096};
}

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

Image reference_picture(const Globe& globe, const View<>& view, Filter filter) {
  return picture_of_hits(globe, view, filter, reference_hits(globe, view));
}

Film sampled(const Globe& globe, const View<>& view, const Variant& variant, const Sampler& sampler,
             int threads) {
  const ManyRayScene scene{{},
                           {{globe.sphere, {&globe, {variant.degree}}}},
                           {.sky = {.below = globe.sky, .above = globe.sky}}};
  const auto bounds =
      bounds_of_view(scene.objects, scene.stage.sky, scene.lens, {}, sampler.samples());
  return gather(scene, scene.objects, view, {sampler}, bounds, variant.number,
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

Image differences(const Image& a, const Image& b, int reach) {
  return image_of(a.width, a.height, [&](int column, int row) {
    int levels = 0;
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, a.height - 1); ++y) {
      for (int x = std::max(column - reach, 0); x <= std::min(column + reach, a.width - 1); ++x)
        levels = std::max(levels, channel_difference(a.at(x, y), b.at(x, y)));
    }
    return difference_color(levels);
  });
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += square(a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

void find_errors(std::span<Row> rows, const Globe& globe, const View<>& view, int threads,
                 const Tick& tick) {
  const Part part = rows.front().part;
  if (part == Part::samplers) return find_errors_of_samplers(rows, globe, threads, tick);
  const auto hits = reference_hits(globe, view);
  int done = 0;
  std::mutex one_by_one;
  for_each_row(static_cast<int>(rows.size()), threads, {}, [&](int i) {
    Row& row = rows[static_cast<std::size_t>(i)];
    if (part == Part::places) find_errors_of_place(row, globe, view, hits);
    if (part == Part::curves) find_errors_of_curve(row, globe, view);
    const std::lock_guard lock(one_by_one);
    tick(++done, static_cast<int>(rows.size()));
  });
}

}  // namespace texmap::chapter_13
