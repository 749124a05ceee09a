// The trials: every way to draw the globe, how far off it is, and how long it takes.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "bounds.hpp"
#include "draw.hpp"
#include "interleaved.hpp"

namespace texmap::chapter_13 {

/// One way to draw the globe.
struct Way {
  Number number = Number::double_;
  Instructions instructions = Instructions::baseline;
  int degree = 0;  ///< of the (u, v) kernel's arc tangent; 0 for the reference formula
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;
  Texels texels = Texels::bytes;

  bool operator==(const Way&) const = default;
};

/// How far off a way is: what was measured, and beside each figure the one to rely on, which was known before.
struct Errors {
  double worst_texels = 0, mean_texels = 0, texels_bound = 0;  ///< hits that are not nearer to the rim than least_cosine
  double worst_unrounded = 0, mean_unrounded = 0, unrounded_bound = 0;  ///< with a curve: levels before they are bytes
  long changed = 0, may_change = 0;                                     ///< pixels whose bytes are not those of the judge
  int levels = 0, levels_bound = 0;                                     ///< the largest change of a channel, of 255
};

/// A way that was tried.
struct Trial {
  Way way;
  Errors errors;
  double milliseconds = 0;  ///< for one picture, on one thread: the shortest of all rounds
  double time = 0;          ///< as a part of plain double's time
};

/// What is said about the work under way: one call for each of its parts.
using Tick = std::function<void()>;

[[nodiscard]] inline bool is_pack(Number number) { return number == Number::float_pack || number == Number::double_pack; }

/// work(T{}) with the type of number that calculates in one lane.
template <class Work>
decltype(auto) with_number(Number number, const Work& work) {
  if (number == Number::float_ || number == Number::float_pack) return work(float{});
  if (number == Number::extended) return work(static_cast<long double>(0));
  return work(double{});
}

/// work(std::type_identity<Real>{}) with the type that a number calculates in. Packs of all widths calculate the same
/// (tests/packs), and are judged by those that every machine has.
template <class Work>
void with_real(Number number, const Work& work) {
  with_number(number, [&]<class T>(T) {
#ifdef TEXMAP_HAVE_PACKS
    if constexpr (sizeof(T) <= sizeof(double)) {
      if (is_pack(number)) return work(std::type_identity<Pack<T>>{});
    }
#endif
    work(std::type_identity<T>{});
  });
}

/// The (u, v) kernels that a number has a use for. Beyond degree 17 rounding is all that is left of float's errors, and below
/// degree 23 double is no better than float.
[[nodiscard]] inline std::vector<int> degrees_for(Number number) {
  if (number == Number::extended) return {0};
  if (number == Number::double_ || number == Number::double_pack) return {0, 23, 29, 35};
  return {0, 5, 7, 9, 11, 13, 15, 17};
}

/// The sets of instructions that this program has packs of and this machine can run.
///
/// @param widest  none beyond this
[[nodiscard]] inline std::vector<Instructions> usable_instructions([[maybe_unused]] Instructions widest) {
  std::vector<Instructions> usable = {Instructions::baseline};
#ifdef TEXMAP_WIDE_PACKS
  for (const Instructions wide : {Instructions::avx2, Instructions::avx512}) {
    if (machine_has(wide) && wide <= widest) usable.push_back(wide);
  }
#endif
  return usable;
}

/// Every number, as packs with every set of instructions, with every kernel it has a use for and both filters. The first is
/// plain double with the reference formula and the nearest texel, which the times of all others are parts of.
[[nodiscard]] inline std::vector<Trial> all_places(Instructions widest) {
  std::vector<Trial> trials;
  std::vector<Number> numbers = {Number::double_, Number::float_, Number::extended};
#ifdef TEXMAP_HAVE_PACKS
  numbers.insert(numbers.end(), {Number::float_pack, Number::double_pack});
#endif
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    for (const Number number : numbers) {
      for (const Instructions instructions : usable_instructions(is_pack(number) ? widest : Instructions::baseline)) {
        for (const int degree : degrees_for(number)) trials.push_back({{number, instructions, degree, filter}, {}});
      }
    }
  }
  return trials;
}

/// The numbers that differ in what they make of light, packs of the widest instructions alone.
[[nodiscard]] inline std::vector<std::pair<Number, Instructions>> numbers_of_light(Instructions widest) {
  [[maybe_unused]] const Instructions wide = usable_instructions(widest).back();
  std::vector<std::pair<Number, Instructions>> numbers = {{Number::double_, Instructions::baseline},
                                                          {Number::float_, Instructions::baseline}};
#ifdef TEXMAP_HAVE_PACKS
  numbers.insert(numbers.end(), {{Number::double_pack, wide}, {Number::float_pack, wide}});
#endif
  return numbers;
}

/// Every curve from light to bytes, with the numbers that differ in it; and those with which texels kept as roots are off by no
/// more than one level. Bytes and roots by turns, since a picture leaves its texels in the caches for the next.
[[nodiscard]] inline std::vector<Trial> all_curves(Instructions widest) {
  std::vector<Trial> trials;
  for (const auto& [number, instructions] : numbers_of_light(widest)) {
    for (const Curve curve : {Curve::formula, Curve::exact, Curve::four, Curve::three}) {
      trials.push_back({{number, instructions, 0, Filter::nearest, curve}, {}});
      if (curve == Curve::formula || curve == Curve::three) continue;
      trials.push_back({{number, instructions, 0, Filter::nearest, curve, Texels::roots}, {}});
    }
  }
  return trials;
}

/// Draws a scene in a way: as `draw` does, but for intervals, which bound pictures and do not draw them.
/// Errors: std::runtime_error for packs where the program was built without them.
template <class Scene>
[[nodiscard]] Image draw_in_way(const Scene& scene, const View& view, const Way& way, int threads) {
  const RenderSettings settings{.threads = threads, .instructions = way.instructions};
  if (way.number == Number::float_) return render<float>(scene, view, settings);
  if (way.number == Number::double_) return render<double>(scene, view, settings);
  if (way.number == Number::extended) return render<long double>(scene, view, settings);
#ifdef TEXMAP_WIDE_PACKS
  if (way.instructions == Instructions::avx512) {
    return draw_wide_packs<Instructions::avx512>(scene, view, way.number, settings);
  }
  if (way.instructions == Instructions::avx2) return draw_wide_packs<Instructions::avx2>(scene, view, way.number, settings);
#endif
#ifdef TEXMAP_HAVE_PACKS
  return draw_packs<xsimd::default_arch>(scene, view, way.number, settings);
#else
  throw std::runtime_error("there are no packs of numbers in this program");
#endif
}

[[nodiscard]] inline Shot shot_of(const Globe& globe, const Way& way) {
  return {&globe, mapping_of_degree(way.degree), way.filter, way.curve, way.texels};
}

[[nodiscard]] inline Image picture_of(const Globe& globe, const View& view, const Way& way, int threads = 1) {
  return draw_in_way(shot_of(globe, way), view, way, threads);
}

/// The judge of places: where each pixel's ray meets the globe, in extended precision, by the reference formula.
[[nodiscard]] inline std::vector<Sight> sights_of(const Globe& globe, const View& view) {
  using Real = long double;
  std::vector<Sight> sights;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const Ray<Real> ray = ray_through(view, Real(column), Real(row));
      const Vec3<Real> moment = cross(ray.origin - number_cast<Real>(globe.sphere.center), ray.direction);
      const Real passes = length(moment) / Real(globe.sphere.radius);
      const Real distance = distance_to(globe.sphere, ray);
      Sight sight{.met = distance < infinity<Real>(), .from_rim = static_cast<double>(abs(passes - 1))};
      if (sight.met) {
        const Vec3<Real> normal = normal_at(globe.sphere, ray, distance);
        const Uv<Real> uv = uv_rtiow(normal);
        sight.cosine = static_cast<double>(-dot(normal, ray.direction));
        sight.round = static_cast<double>(sqrt(square(normal.x) + square(normal.z)));
        sight.u = uv.u;
        sight.v = uv.v;
      }
      sights.push_back(sight);
    }
  }
  return sights;
}

/// visit(row, column, ray) for the rays of numbers of type Real through all pixels; of a pack, the first lane's column.
template <class Real, class Visit>
void for_each_ray(const View& view, const Visit& visit) {
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; column += static_cast<int>(lanes<Real>)) {
      const auto first = static_cast<Scalar<Real>>(column);
      const Real columns = from_lanes<Real>([first](std::size_t i) { return first + static_cast<Scalar<Real>>(i); });
      visit(row, column, ray_through(view, columns, Real(row)));
    }
  }
}

/// Compares the places that numbers of type Real find with the judge's.
template <class Real>
void measure_places(const Globe& globe, const View& view, int degree, const std::vector<Sight>& sights, Errors& errors) {
  const BudgetMapping mapping = mapping_of_degree(degree);
  const auto width = static_cast<long double>(globe.nearest.image.width);
  const auto height = static_cast<long double>(globe.nearest.image.height);
  double sum = 0;
  long count = 0;
  for_each_ray<Real>(view, [&](int row, int column, const Ray<Real>& ray) {
    const Real distance = distance_to(globe.sphere, ray);
    const Mask<Real> met = distance < infinity<Real>();
    if (!any(met)) return;
    const Uv<Real> uv = mapping(normal_at(globe.sphere, ray, select(met, distance, Real(1))));
    const auto u = all_lanes(uv.u);
    const auto v = all_lanes(uv.v);
    for (int i = 0; i < static_cast<int>(lanes<Real>) && column + i < view.width; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Sight& sight =
          sights[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(column + i)];
      if (!sight.met || sight.cosine < least_cosine) continue;
      const long double across = std::abs(static_cast<long double>(u[at]) - sight.u);  // u = 0 and u = 1 are one place
      const long double along_u = std::min(across, 1 - across) * static_cast<long double>(sight.round) * width;
      const long double along_v = std::abs(static_cast<long double>(v[at]) - sight.v) * height;
      const auto texels = static_cast<double>(std::max(along_u, along_v));
      errors.worst_texels = std::max(errors.worst_texels, texels);
      sum += texels;
      ++count;
    }
  });
  errors.mean_texels = count > 0 ? sum / static_cast<double>(count) : 0;
}

/// How many pixels of a view a number and a kernel may change, and by how much, before anything is drawn with them.
///
/// Pixels whose rays pass so near to the rim that a rounding may take them past it may change by all 255 levels.
template <class T>
void bound_picture(const Globe& globe, const Way& way, const std::vector<Sight>& sights, Errors& errors) {
  const double past_rim = ray_bound<T>(globe);
  for (const Sight& sight : sights) {
    int levels = 0;
    if (sight.from_rim <= past_rim) {
      levels = 255;
    } else if (sight.met) {
      const auto unit = static_cast<double>(unit_roundoff<T>());
      levels = levels_bound(globe, way.filter, sight, place_bound<T>(globe, way.degree, sight), unit);
    }
    errors.may_change += levels > 0 ? 1 : 0;
    errors.levels_bound = std::max(errors.levels_bound, levels);
  }
}

/// Counts what one picture shows otherwise than another of the same size.
inline void compare_bytes(const Image& image, const Image& judge, Errors& errors) {
  for (std::size_t i = 0; i < judge.pixels.size(); ++i) {
    const Rgb8 a = image.pixels[i];
    const Rgb8 b = judge.pixels[i];
    const int levels = std::max({abs(a.r - b.r), abs(a.g - b.g), abs(a.b - b.b)});
    errors.changed += levels > 0 ? 1 : 0;
    errors.levels = std::max(errors.levels, levels);
  }
}

/// How far off the places and the bytes of a way are in a view, and how far they can be.
///
/// @param judge  the view in extended precision, with the way's filter
[[nodiscard]] inline Errors errors_of_places(const Globe& globe, const View& view, const Way& way,
                                             const std::vector<Sight>& sights, const Image& judge) {
  Errors errors;
  with_number(way.number, [&]<class T>(T) {
    errors.texels_bound = texels_bound<T>(globe, way.degree);
    bound_picture<T>(globe, way, sights, errors);
  });
  with_real(way.number,
            [&]<class Real>(std::type_identity<Real>) { measure_places<Real>(globe, view, way.degree, sights, errors); });
  Way on_any_machine = way;
  on_any_machine.instructions = Instructions::baseline;
  compare_bytes(picture_of(globe, view, on_any_machine, 0), judge, errors);
  return errors;
}

/// Fills in the errors of all ways. A way that differs from another in its instructions alone has the other's.
inline void judge_places(std::vector<Trial>& trials, const Globe& globe, const View& view, const Tick& tick) {
  const auto sights = sights_of(globe, view);
  const auto judge = [&](Filter filter) { return picture_of(globe, view, {.number = Number::extended, .filter = filter}, 0); };
  const std::array<Image, 2> judges = {judge(Filter::nearest), judge(Filter::bilinear)};
  for (Trial& trial : trials) {
    const auto same = std::find_if(trials.begin(), trials.end(), [&trial](const Trial& other) {
      return other.way.number == trial.way.number && other.way.degree == trial.way.degree &&
             other.way.filter == trial.way.filter;
    });
    trial.errors = &*same != &trial
                       ? same->errors
                       : errors_of_places(globe, view, trial.way, sights, judges[trial.way.filter == Filter::nearest ? 0 : 1]);
    tick();
  }
}

/// Takes note of a pixel's levels before they are bytes, red, green and blue; `mean_unrounded` becomes a sum.
///
/// @return  true if the bound takes a level that is right across an edge between two bytes
inline bool note_pixel(const std::array<double, 3>& levels, const std::array<double, 3>& right, Errors& errors) {
  const double bound = errors.unrounded_bound;
  bool may_change = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double off = std::abs(levels[i] - right[i]);
    errors.worst_unrounded = std::max(errors.worst_unrounded, off);
    errors.mean_unrounded += off;
    may_change = may_change || std::floor(right[i] - bound + 0.5) < std::floor(right[i] + bound + 0.5);
  }
  return may_change;
}

/// What is stated of a way's levels before it is tried, each the mean of so many rays.
inline void state_levels(const Way& way, int rays, Errors& errors) {
  with_number(way.number, [&]<class T>(T) { errors.unrounded_bound = unrounded_bound<T>(way.curve, way.texels, rays); });
  errors.levels_bound = rounded_bound(errors.unrounded_bound);
}

/// Compares the levels that a shot shows, before they are bytes, with the judge's, in numbers of type Real.
template <class Real>
void measure_levels(const Shot& shot, const Shot& judge, const View& view, Errors& errors) {
  const auto levels_of = [](const Shot& how, const Ray<Real>& ray) {
    const Color<Real> light = how.color_along(ray);
    return std::array{all_lanes(how.level_of_light(light.r)), all_lanes(how.level_of_light(light.g)),
                      all_lanes(how.level_of_light(light.b))};
  };
  const auto in_lane = [](const auto& channels, std::size_t i) {
    return std::array{static_cast<double>(channels[0][i]), static_cast<double>(channels[1][i]),
                      static_cast<double>(channels[2][i])};
  };
  for_each_ray<Real>(view, [&](int, int column, const Ray<Real>& ray) {
    const auto levels = levels_of(shot, ray);
    const auto right = levels_of(judge, ray);
    for (std::size_t i = 0; i < lanes<Real> && column + static_cast<int>(i) < view.width; ++i) {
      errors.may_change += note_pixel(in_lane(levels, i), in_lane(right, i), errors) ? 1 : 0;
    }
  });
  errors.mean_unrounded /= 3.0 * view.width * view.height;
}

/// How far off a way's levels and bytes are in a view, and how far they can be. The judge is the exact curve of the texels'
/// bytes, drawn with the same number: where a place is off, both are.
[[nodiscard]] inline Errors errors_of_light(const Globe& globe, const View& view, Way way) {
  way.instructions = Instructions::baseline;
  Way exact = way;
  exact.curve = Curve::exact;
  exact.texels = Texels::bytes;
  Errors errors;
  state_levels(way, 1, errors);
  with_real(way.number, [&]<class Real>(std::type_identity<Real>) {
    measure_levels<Real>(shot_of(globe, way), shot_of(globe, exact), view, errors);
  });
  compare_bytes(picture_of(globe, view, way, 0), picture_of(globe, view, exact, 0), errors);
  return errors;
}

/// Fills in the errors of all curves and of texels kept in other ways.
inline void judge_curves(std::vector<Trial>& trials, const Globe& globe, const View& view, const Tick& tick) {
  for (Trial& trial : trials) {
    trial.errors = errors_of_light(globe, view, trial.way);
    tick();
  }
}

/// How often things are timed.
struct Rounds {
  int wanted = 0, timed = 0;  ///< fewer than wanted where patience ended
};

/// How the timing of a run goes.
struct Timing {
  int rounds;         ///< wanted
  Patience patience;  ///< with all timings of the run together
  Tick tick;
  std::vector<Rounds> done = {};  ///< of the timings so far
};

/// The shortest times of works that take turns, noted in `timing`, which ticks for the first `ticks` works of every round, and
/// for rounds that are skipped all at once.
[[nodiscard]] inline std::vector<double> timed_by_turns(const std::vector<Work>& works, int rounds, std::size_t ticks,
                                                        Timing& timing) {
  Rounds& noted = timing.done.emplace_back(Rounds{rounds});
  auto shortest = shortest_times(
      works, rounds,
      [&](int done, int) {
        if (static_cast<std::size_t>(done - 1) % works.size() < ticks) timing.tick();
      },
      [&](int round) {
        noted.timed = round;
        return timing.patience(round);
      });
  for (std::size_t i = 0; i < ticks * static_cast<std::size_t>(rounds - noted.timed); ++i) timing.tick();
  return shortest;
}

/// Fills in the times of all trials, taken by turns on one thread; `time` is a part of the first one's.
///
/// The first is what all others are measured by, and takes a turn after every tenth of them too, as does its like with the
/// other filter: were they disturbed in all rounds, every figure would be wrong. With more chances their time is rather too
/// short, so that nothing is called faster than it is.
inline void time_trials(std::vector<Trial>& trials, const Globe& globe, const View& view, Timing& timing) {
  std::vector<Work> works;
  std::vector<std::size_t> whose;
  const auto add = [&](std::size_t i) {
    works.emplace_back([&globe, &view, way = trials[i].way] { (void)picture_of(globe, view, way); });
    whose.push_back(i);
  };
  for (std::size_t i = 0; i < trials.size(); ++i) {
    add(i);
    if (i % 10 != 9) continue;
    for (std::size_t k = 0; k < trials.size(); ++k) {
      const Way& way = trials[k].way;
      if (way.number == Number::double_ && way.degree == 0 && way.curve == trials[0].way.curve) add(k);
    }
  }
  const auto shortest = timed_by_turns(works, timing.rounds, trials.size(), timing);
  for (Trial& trial : trials) trial.milliseconds = infinity<double>();
  for (std::size_t k = 0; k < works.size(); ++k) {
    Trial& trial = trials[whose[k]];
    trial.milliseconds = std::min(trial.milliseconds, shortest[k]);
  }
  for (Trial& trial : trials) trial.time = trial.milliseconds / trials[0].milliseconds;
}

}  // namespace texmap::chapter_13
