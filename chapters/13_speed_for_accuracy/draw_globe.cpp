// Draws the globe with every number: the templates of scenes.hpp are compiled here.
#include "engine/render/develop.hpp"
#include "scenes.hpp"
#include "trials.hpp"

namespace texmap::chapter_13 {
namespace {

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

/// visit(row, column, ray) for the rays of numbers of type Real through all pixels; of a pack, the
/// first lane's column.
template <class Real, class Visit>
void for_each_ray(const View<>& view, const Visit& visit) {
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; column += static_cast<int>(lanes<Real>)) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns =
          from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      visit(row, column, ray_through(view, columns, Real(row)));
    }
  }
}

/// Compares the places that numbers of type Real find with the reference's.
template <class Real>
void measure_places(const Globe& globe, const View<>& view, const PlannedMapping& mapping,
                    const std::vector<ReferenceHit>& hits, Errors& errors) {
  const Judge width(globe.nearest.image.width);
  const Judge height(globe.nearest.image.height);
  double sum = 0;
  long count = 0;
  for_each_ray<Real>(view, [&](int row, int column, const Ray<Real>& ray) {
    const Real distance = distance_to(globe.sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    if (!any(met)) return;
    const Uv<Real> uv = mapping(normal_at(globe.sphere, ray, select(met, distance, Real(1))));
    const auto u = all_lanes(uv.u);
    const auto v = all_lanes(uv.v);
    for (std::size_t i = 0; i < lanes<Real> && column + static_cast<int>(i) < view.width; ++i) {
      const ReferenceHit& hit =
          hits[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
               static_cast<std::size_t>(column) + i];
      if (!hit.met || hit.cosine < least_cosine) continue;
      const Judge across = abs(Judge(u[i]) - hit.uv.u);  // u = 0 and u = 1 are one place
      const Judge along_u = min(across, Judge(1) - across) * Judge(hit.round) * width;
      const Judge along_v = abs(Judge(v[i]) - hit.uv.v) * height;
      const auto texels = static_cast<double>(max(along_u, along_v));
      errors.worst_texels = std::max(errors.worst_texels, texels);
      sum += texels;
      ++count;
    }
  });
  errors.mean_texels = count > 0 ? sum / static_cast<double>(count) : 0;
}

/// Compares a pixel's levels before they are bytes, red, green and blue; `mean_unrounded` becomes a
/// sum, and the pixel may change if the bound takes a level of the reference across an edge between
/// two bytes.
void compare_levels(const std::array<double, 3>& levels, const std::array<double, 3>& reference,
                    Errors& errors) {
  const double bound = errors.unrounded_bound;
  bool may_change = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double off = std::abs(levels[i] - reference[i]);
    errors.worst_unrounded = std::max(errors.worst_unrounded, off);
    errors.mean_unrounded += off;
    may_change = may_change ||
                 std::floor(reference[i] - bound + 0.5) < std::floor(reference[i] + bound + 0.5);
  }
  errors.may_change += may_change ? 1 : 0;
}

/// Compares the levels that a scene shows, before they are bytes, with the reference's, in numbers
/// of type Real.
template <class Real>
void measure_levels(const OneRayScene& scene, const OneRayScene& reference, const View<>& view,
                    Errors& errors) {
  const auto levels_along = [](const OneRayScene& which, const Ray<Real>& ray) {
    const Color<Real> light = which.color_along(ray);
    return std::array{all_lanes(which.level_of_light(light.r)),
                      all_lanes(which.level_of_light(light.g)),
                      all_lanes(which.level_of_light(light.b))};
  };
  const auto in_lane = [](const auto& channels, std::size_t i) {
    return std::array{static_cast<double>(channels[0][i]), static_cast<double>(channels[1][i]),
                      static_cast<double>(channels[2][i])};
  };
  for_each_ray<Real>(view, [&](int, int column, const Ray<Real>& ray) {
    const auto levels = levels_along(scene, ray);
    const auto right = levels_along(reference, ray);
    for (std::size_t i = 0; i < lanes<Real> && column + static_cast<int>(i) < view.width; ++i)
      compare_levels(in_lane(levels, i), in_lane(right, i), errors);
  });
  errors.mean_unrounded /= 3.0 * view.width * view.height;
}

/// What is stated of a variant's levels before it is tried, each the mean of so many rays.
Errors stated_levels(const Variant& variant, int rays) {
  const double bound = unrounded_bound(variant, rays);
  return {.unrounded_bound = bound, .levels_bound = rounded_bound(bound)};
}

}  // namespace

Image picture_of(const Globe& globe, const View<>& view, const Variant& variant, int threads) {
  const OneRayScene scene = scene_of(globe, variant);
  const RenderSettings settings{.threads = threads, .instructions = variant.instructions};
  return run_in_number(DrawWork<OneRayScene>{scene, view, settings}, variant.number,
                       variant.instructions);
}

Film sampled(const Globe& globe, const View<>& view, const Variant& variant, const Sampler& sampler,
             int threads) {
  const ManyRayScene scene{{{globe.sphere, {{variant.degree}, {&globe, variant.format}}}},
                           {.sky = {.below = globe.sky, .above = globe.sky}}};
  return gather(scene, scene.objects, view, {sampler}, {}, variant.number,
                {.threads = threads, .instructions = variant.instructions});
}

Image reference_picture(const Globe& globe, const View<>& view, Filter filter, int threads) {
  return render<Judge>(ReferenceScene{&globe, filter}, view, {.threads = threads});
}

std::vector<ReferenceHit> reference_hits(const Globe& globe, const View<>& view) {
  using Real = Judge;
  std::vector<ReferenceHit> hits;
  for_each_ray<Real>(view, [&](int, int, const Ray<Real>& ray) {
    const Vec3<Real> moment =
        cross(ray.origin - number_cast<Real>(globe.sphere.center), ray.direction);
    const Real passes = length(moment) / Real(globe.sphere.radius);
    const Real distance = distance_to(globe.sphere, ray);
    ReferenceHit hit{.met = distance < infinity<Real>(),
                     .from_rim = static_cast<double>(abs(passes - Real(1)))};
    if (hit.met) {
      const Vec3<Real> normal = normal_at(globe.sphere, ray, distance);
      hit.cosine = static_cast<double>(-dot(normal, ray.direction));
      hit.round = static_cast<double>(sqrt(square(normal.x) + square(normal.z)));
      hit.uv = uv_rtiow(normal);
    }
    hits.push_back(hit);
  });
  return hits;
}

Errors errors_of_places(const Globe& globe, const View<>& view, const Variant& variant,
                        const std::vector<ReferenceHit>& hits, const Image& reference) {
  Errors errors{.texels_bound = texels_bound(globe, variant.number, variant.degree)};
  for (const ReferenceHit& hit : hits) {
    const int levels = levels_bound(globe, variant, hit);
    errors.may_change += levels > 0 ? 1 : 0;
    errors.levels_bound = std::max(errors.levels_bound, levels);
  }
  with_real(variant.number, [&]<class Real>(std::type_identity<Real>) {
    measure_places<Real>(globe, view, {variant.degree}, hits, errors);
  });
  Variant on_any_machine = variant;
  on_any_machine.instructions = Instructions::baseline;
  compare_bytes(picture_of(globe, view, on_any_machine, 0), reference, errors);
  return errors;
}

Errors errors_of_light(const Globe& globe, const View<>& view, Variant variant) {
  variant.instructions = Instructions::baseline;
  Variant exact = variant;
  exact.curve = Curve::exact;
  exact.format = TexelFormat::bytes;
  Errors errors = stated_levels(variant, 1);
  with_real(variant.number, [&]<class Real>(std::type_identity<Real>) {
    measure_levels<Real>(scene_of(globe, variant), scene_of(globe, exact), view, errors);
  });
  compare_bytes(picture_of(globe, view, variant, 0), picture_of(globe, view, exact, 0), errors);
  return errors;
}

Errors errors_of_samples(const Globe& globe, const View<>& view, const Variant& variant,
                         const Sampler& sampler, int threads) {
  Variant of_bytes = variant;
  of_bytes.format = TexelFormat::bytes;
  const Film film = sampled(globe, view, variant, sampler, threads);
  const Film reference = sampled(globe, view, of_bytes, sampler, threads);
  const std::vector<double> levels = levels_of(film);
  const std::vector<double> right = levels_of(reference);
  Errors errors = stated_levels(variant, sampler.samples());
  for (std::size_t i = 0; i < levels.size(); i += 3) {
    compare_levels({levels[i], levels[i + 1], levels[i + 2]},
                   {right[i], right[i + 1], right[i + 2]}, errors);
  }
  errors.mean_unrounded /= static_cast<double>(levels.size());
  compare_bytes(develop(film, Transfer::srgb), develop(reference, Transfer::srgb), errors);
  return errors;
}

}  // namespace texmap::chapter_13
