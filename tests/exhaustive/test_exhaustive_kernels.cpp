// The kernels on every float of their domains: bound, range, and steps between neighboring floats.
// A step back is what a function falls where it should rise, or rises where it should fall.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/fast/power_kernel.hpp"
#include "engine/fast/root_texture.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "engine/fast/turns.hpp"
#include "engine/files/text.hpp"
#include "references.hpp"
#include "sampling/directions.hpp"

namespace texmap::test {
namespace {

constexpr double epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());

/// Below it, a float's square is less than half an ulp of what it is added to, and light is on the
/// straight part of its curve and less than a millionth of a level: more of the same.
constexpr float low = 0x1p-32F;

/// What `each(all)` adds for every degree of the arc tangent that is used with float.
template <class Each>
std::vector<Candidate> for_each_degree(const Each& each) {
  std::vector<Candidate> all;
  [&]<int... Degree>(std::integer_sequence<int, Degree...>) {
    (each.template operator()<Degree>(all), ...);
  }
  (std::integer_sequence<int, 5, 9, 17>());
  return all;
}

TEST_CASE("arc tangents keep their bound for every float from 2^-32 to 1") {
  check_all(every_float(low, 1), exact_eighth_turn, for_each_degree([]<int Degree>(auto& all) {
              using Fit = ArcTangentFit<Degree>;
              all.push_back({.name = "arc tangent of degree " + std::to_string(Degree),
                             .run = by_packs(eighth_turn<Degree, Floats>),
                             .bound = Fit::worst + 0.31 * epsilon,
                             .step_back = 0.32 * epsilon,
                             .highest = 0.125F + static_cast<float>(Fit::worst)});
            }));
  check_all(every_float(low, 1), exact_eighth_turn,
            {{.name = "atan2 of packs",
              .run = by_packs([](const Floats& t) { return atan2(t, Floats(1)); }),
              .bound = 2.4,
              .factor = static_cast<double>(2 * pi_digits),
              .in_ulps = true}});
}

/// turn_of_parts of the vector (1, t), (t, 1) or those mirrored: one octant.
template <int Degree>
Candidate octant(bool steep, bool ahead, bool below) {
  const double start = below ? (steep ? 0.75 : ahead ? 1 : 0.5) : (steep ? 0.25 : ahead ? 0 : 0.5);
  const bool falls = (steep == ahead) != below;
  return {.name = std::string("degree ") + std::to_string(Degree) +
                  (falls ? " before " : " from ") + std::to_string(start).substr(0, 4),
          .run = by_packs([=](const Floats& t) {
            const Floats one(1);
            const Floats height = steep ? one : t;
            return turn_of_parts<Degree>(below ? -height : height, steep ? t : one,
                                         Floats(ahead ? 1 : -1) > Floats(0));
          }),
          // The bound leaves 0.04 epsilons to the rounding of a slope.
          .bound = FastUnitMapping<Degree>::template worst<float>.u - 0.04 * epsilon,
          // On a diagonal two octants meet, each off by as much as the fit.
          .step_back = 2 * ArcTangentFit<Degree>::worst + 0.5 * epsilon,
          .highest = below_one<float>(),
          .falls = falls,
          .offset = start,
          .factor = falls ? -1. : 1.};
}

TEST_CASE("the whole angle keeps its bound for every float as slope, in all eight octants") {
  // Below 2^-12 an eighth turn is off by less than a thousandth of an epsilon.
  check_all(every_float(0x1p-12F, 1), exact_eighth_turn, for_each_degree([]<int Degree>(auto& all) {
              for (int number = 0; number < 8; ++number)
                all.push_back(octant<Degree>(number & 1, number & 2, number & 4));
            }));
  // And just below a whole turn it stays below it.
  check_all(every_float(std::numeric_limits<float>::denorm_min(), 0x1p-12F), exact_eighth_turn,
            {octant<17>(false, true, true)});
}

/// v of a point on a meridian at every height.
template <int Degree>
Candidate latitude(bool north) {
  return {.name = "v by degree " + std::to_string(Degree) + (north ? ", north" : ", south"),
          .run =
              [north](const Block& block, float* to) {
                for (std::size_t i = 0; i < Block::size; i += lanes<Floats>) {
                  const Floats y(Floats::Batch::load_aligned(block.x.data() + i));
                  const Floats x(Floats::Batch::load_aligned(block.beside.data() + i));
                  const Vec3<Floats> p{x, north ? y : -y, Floats(0)};
                  FastUnitMapping<Degree>{}(p).v.batch().store_unaligned(to + i);
                }
              },
          .bound = FastUnitMapping<Degree>::template worst<float>.v,
          .step_back = 1 * epsilon,
          .falls = !north,
          .offset = north ? 1. : 0.,
          .factor = north ? -1. : 1.};
}

TEST_CASE("v keeps its bound for every float as height, on a meridian") {
  check_all(every_float(low, 1), exact_from_pole, for_each_degree([]<int Degree>(auto& all) {
              for (const bool north : {true, false}) all.push_back(latitude<Degree>(north));
            }));
}

template <int Terms>
Candidate srgb_level_of(double step_back) {
  return {.name = "sRGB level, " + std::to_string(Terms) + " terms",
          .run = by_packs(srgb_level<Terms, Floats>),
          .bound = fits::SrgbCurve<Terms>::worst,
          .step_back = step_back,
          .lowest = -1.5F,
          .highest = 256.5F};
}
template <int Terms>
Candidate srgb_byte_of(double bound) {
  return {.name = "sRGB byte, " + std::to_string(Terms) + " terms",
          .run = by_packs(srgb_byte<Terms, Floats>),
          .bound = bound,
          .step_back = 1,
          .highest = 255};
}

TEST_CASE("sRGB levels and bytes keep their bound for every float; exact bytes are exact") {
  check_all(every_float(low, 1), exact_srgb_level,
            {srgb_level_of<3>(2e-5), srgb_level_of<4>(4e-5)});
  const auto exact = by_packs([](const Floats& light) { return srgb_byte_exact(light); });
  check_all(every_float(low, 1), exact_srgb_byte,
            {srgb_byte_of<3>(2),
             srgb_byte_of<4>(1),
             {.name = "exact sRGB byte", .run = exact, .highest = 255}});
}

TEST_CASE("sRGB's formulas keep their bound for every float from 0 to 1") {
  const Candidate encode{.name = "srgb_encode",
                         .run = one_by_one([](float light) { return srgb_encode(light); }),
                         .bound = 5,
                         .factor = 1. / 255,
                         .in_ulps = true};
  // The float nearest to 0.0031308 is above it, but takes the branch below: 7.4 ulp.
  const float joint = 0.0031308F;
  check_all(every_float(0, std::nextafter(joint, 0.F)), exact_srgb_level, {encode});
  check_all(every_float(std::nextafter(joint, 1.F), 1), exact_srgb_level, {encode});
  const auto decode = one_by_one([](float encoded) { return srgb_decode(encoded); });
  check_all(every_float(0, 1), exact_srgb_decode,
            {{.name = "srgb_decode", .run = decode, .bound = 8, .in_ulps = true}});
}

TEST_CASE("the root of light in ten bits is within its bound for every float from 2^-32 to 1") {
  std::vector<float> levels;
  for (int root = 0; root <= RootTexture::most; ++root) {
    const double light = square(static_cast<double>(root) / RootTexture::most);
    levels.push_back(static_cast<float>(255 * srgb_encode(light)));
  }
  const auto kept = one_by_one([&levels](float light) {
    const double root = std::sqrt(static_cast<double>(light)) * RootTexture::most;
    return levels[static_cast<std::size_t>(root + 0.5)];
  });
  check_all(every_float(low, 1), exact_srgb_level,
            {{.name = "ten bits of the root",
              .run = kept,
              .bound = RootTexture::worst_levels,
              .highest = 255.0001F}});
}

template <int Terms>
Candidate power_of(double n) {
  return {.name = "power " + shown(n, 4) + ", " + std::to_string(Terms) + " terms",
          .run = by_packs([kernel = PowerKernel<Terms>(n)](const Floats& w) { return kernel(w); }),
          .bound = PowerKernel<Terms>::template worst_levels<float> / 255,
          .step_back = 8 * epsilon,
          .falls = true};
}

TEST_CASE("powers keep their bound for every versine, and the versine of every cosine") {
  const auto check = [](const Inputs& versines, double n) {
    check_all(versines, exact_power(n), {power_of<3>(n), power_of<6>(n)});
  };
  for (const double n : {5., 100.}) check(every_float(low, 1), n);
  for (const double n :
       {0.5, 1., 2., 3., 8., 10., 15.9, 20., 32., 50., 64., 200., 500.5, 1000., 1e4, 1e30})
    check(versines_of_every_cosine(), n);
}

TEST_CASE("points on the circle keep their bound for every float from 2^-32 to 1/8") {
  Candidate part{.name = "cosine",
                 .run = by_packs([](const Floats& x) { return on_circle_eighth(x).cosine; }),
                 .bound = epsilon,
                 .step_back = 0.5 * epsilon,
                 .falls = true};
  check_all(every_float(low, 0.125F), exact_cosine, {part});
  part.name = "sine";
  part.run = by_packs([](const Floats& x) { return on_circle_eighth(x).sine; });
  part.falls = false;
  check_all(every_float(low, 0.125F), exact_sine, {part});
}

TEST_CASE("the disk: no sample of the outermost rings leaves it, all 2^24 of each") {
  // In exact arithmetic: in double, the squares of two floats have no error, and their sum 2^-53.
  for (const float out : {0.0F, 0x1p-24F, 0x1p-23F, 0x1p-22F, 1 - 0x1p-23F, 1 - 0x1p-24F}) {
    double longest = 0;
    for (int i = 0; i < 1 << 24; i += one_row_of) {
      const OnDisk<float> disk = uniform_disk<float>({out, static_cast<float>(i) * 0x1p-24F});
      const double x = disk.x;
      const double y = disk.y;
      longest = std::max(longest, x * x + y * y);
    }
    CHECK(longest < 1);
  }
}

}  // namespace
}  // namespace texmap::test
