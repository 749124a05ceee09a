// The kernels on every float of their domains: bound, range, and steps between neighboring floats.
// A step back is what a function falls where it should rise, or rises where it should fall.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/kernels/power_kernel.hpp"
#include "engine/kernels/root_texture.hpp"
#include "engine/kernels/srgb_kernel.hpp"
#include "engine/kernels/turns.hpp"
#include "engine/measure/text.hpp"
#include "references.hpp"
#include "sampling/directions.hpp"

namespace texmap::test {
namespace {

using Floats = Pack<float>;

constexpr double epsilon = static_cast<double>(std::numeric_limits<float>::epsilon());

/// The largest difference of a reference from `exact`, over 2000 blocks of floats from 0 to `last`,
/// in units of itself or of 1e-30 where that is more.
template <class Exact>
double reference_error(float last, const Prepare& prepare, const Exact& exact) {
  const Inputs inputs = every_float(0, last);
  Block block;
  double worst = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    inputs.fill(i * (inputs.count / 2000), block.x);
    prepare(block);
    for (std::size_t k = 0; k < Block::size; k += 31) {
      const long double should = exact(static_cast<long double>(block.x[k]));
      const long double off = std::abs(static_cast<long double>(block.exact[k]) - should);
      worst = std::max(worst, static_cast<double>(off / std::max(std::abs(should), 1e-30L)));
    }
  }
  return worst;
}

TEST_CASE("the references are right to 13 digits or more") {
  constexpr long double turn = 2 * pi_digits;
  const auto arc_tangent = [](long double t) { return std::atan(t) / turn; };
  CHECK(reference_error(1, exact_eighth_turn, arc_tangent) < 1e-14);
  const auto from_pole = [](long double y) {
    const double height = static_cast<double>(y);
    const float around = static_cast<float>(std::sqrt((1 - height) * (1 + height)));
    return 2 * std::atan2(static_cast<long double>(around), y) / turn;
  };
  CHECK(reference_error(1, exact_from_pole, from_pole) < 1e-14);
  const auto cosine = [](long double x) { return std::cos(x * turn); };
  CHECK(reference_error(0.125F, exact_cosine, cosine) < 1e-14);
  const auto sine = [](long double x) { return std::sin(x * turn); };
  CHECK(reference_error(0.125F, exact_sine, sine) < 1e-14);
  const auto level = [](long double light) {
    if (light <= 0.0031308L) return 255 * 12.92L * light;
    return 255 * (1.055L * std::pow(light, 5 / 12.0L) - 0.055L);
  };
  CHECK(reference_error(1, exact_srgb_level, level) < 1e-13);
  const auto decoded = [](long double encoded) {
    if (encoded <= 0.04045L) return encoded / 12.92L;
    return std::pow((encoded + 0.055L) / 1.055L, 2.4L);
  };
  CHECK(reference_error(1, exact_srgb_decode, decoded) < 1e-13);
  for (const double n : {0.5, 5., 100., 1e4}) {
    const auto powers = [n](Block& block) { exact_power(block, n); };
    const auto exact = [n](long double w) {
      return w < 1 ? std::exp(static_cast<long double>(n) * std::log1p(-w)) : 0.0L;
    };
    // Below 1e-26 the reference is 0: a millionth of what is kept.
    CHECK(reference_error(std::min(1.F, 50 / static_cast<float>(n)), powers, exact) < 1e-12);
  }
}

/// Below it, a float's square is less than half an ulp of what it is added to: more of the same.
constexpr float low = 0x1p-32F;

/// `each` with every degree of the arc tangent that is used with float.
template <class Each>
std::vector<Candidate> for_each_degree(const Each& each) {
  std::vector<Candidate> all;
  const auto add = [&]<int Degree>() {
    for (const Candidate& candidate : each.template operator()<Degree>()) all.push_back(candidate);
  };
  add.template operator()<5>();
  add.template operator()<7>();
  add.template operator()<9>();
  add.template operator()<11>();
  add.template operator()<13>();
  add.template operator()<15>();
  add.template operator()<17>();
  return all;
}

TEST_CASE("arc tangents keep their bound for every float from 2^-32 to 1") {
  check_all(every_float(low, 1), exact_eighth_turn, for_each_degree([]<int Degree>() {
              using Fit = ArcTangentFit<Degree>;
              return std::vector<Candidate>{
                  {.name = "arc tangent of degree " + std::to_string(Degree),
                   .run = by_packs([](const Floats& t) { return eighth_turn<Degree>(t); }),
                   .bound = Fit::worst + 0.31 * epsilon,
                   .step_back = 0.32 * epsilon,
                   .highest = 0.125F + static_cast<float>(Fit::worst)}};
            }));
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
  check_all(every_float(0x1p-12F, 1), exact_eighth_turn, for_each_degree([]<int Degree>() {
              std::vector<Candidate> octants;
              for (const bool steep : {false, true}) {
                for (const bool ahead : {true, false}) {
                  for (const bool below : {false, true})
                    octants.push_back(octant<Degree>(steep, ahead, below));
                }
              }
              return octants;
            }));
}

TEST_CASE("the angle just below a whole turn stays below it for every float to 2^-12 as slope") {
  const Candidate last = octant<17>(false, true, true);
  check_all(every_float(std::numeric_limits<float>::denorm_min(), 0x1p-12F), exact_eighth_turn,
            {last});
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
  check_all(every_float(low, 1), exact_from_pole, for_each_degree([]<int Degree>() {
              return std::vector<Candidate>{latitude<Degree>(true), latitude<Degree>(false)};
            }));
}

/// v's error by the arc cosine's polynomial, and by a distance from the axis and a length that are
/// off by 1 epsilon each. What is left to v's bound are the last two roundings.
template <int Degree>
Candidate arc_cosine() {
  using Fit = ArcCosineFit<Degree>;
  return {.name = "arc cosine for degree " + std::to_string(Degree),
          .run =
              [](const Block& block, float* to) {
                in_packs(block.x.data(), to, polynomial<Fit, Floats>);
                for (std::size_t i = 0; i < Block::size; ++i) {
                  const double y = static_cast<double>(block.x[i]);
                  const double sine = std::sqrt((1 - y) * (1 + y));
                  const double off = sine * static_cast<double>(to[i]) - block.exact[i];
                  to[i] = static_cast<float>(std::abs(off) + 2.005 * epsilon * block.exact[i]);
                }
              },
          .bound = FastUnitMapping<Degree>::template worst<float>.v - 0.375 * epsilon,
          .step_back = 1,
          .factor = 0};
}

TEST_CASE("the arc cosine's polynomial leaves v what its bound counts, for every float as height") {
  const Prepare prepare = [](Block& block) {
    fill_exact(block, [](const Wide& y) {
      return atan2(sqrt((Wide(1) - y) * (Wide(1) + y)), y) *
             Wide(static_cast<double>(1 / pi_digits));
    });
  };
  check_all(every_float(low, 1), prepare, for_each_degree([]<int Degree>() {
              return std::vector<Candidate>{arc_cosine<Degree>()};
            }));
}

template <int Terms>
Candidate srgb_level_of(double step_back) {
  return {.name = "sRGB level, " + std::to_string(Terms) + " terms",
          .run = by_packs([](const Floats& light) { return srgb_level<Terms>(light); }),
          .bound = fits::SrgbCurve<Terms>::worst,
          .step_back = step_back,
          .lowest = -1.5F,
          .highest = 256.5F};
}
template <int Terms>
Candidate srgb_byte_of(double bound) {
  return {.name = "sRGB byte, " + std::to_string(Terms) + " terms",
          .run = by_packs([](const Floats& light) { return srgb_byte<Terms>(light); }),
          .bound = bound,
          .step_back = 1,
          .highest = 255};
}

// Below 2^-32 light is on the straight part, a product, and less than a millionth of a level.
TEST_CASE("sRGB levels keep their bound for every float from 2^-32 to 1") {
  check_all(every_float(low, 1), exact_srgb_level,
            {srgb_level_of<3>(2e-5), srgb_level_of<4>(4e-5), srgb_level_of<6>(2.5e-4)});
}

TEST_CASE("sRGB bytes keep their bound for every float from 2^-32 to 1; exact ones are exact") {
  const Candidate exact{.name = "exact sRGB byte",
                        .run = by_packs([](const Floats& light) { return srgb_byte_exact(light); }),
                        .highest = 255};
  check_all(every_float(low, 1), exact_srgb_byte,
            {srgb_byte_of<3>(2), srgb_byte_of<4>(1), srgb_byte_of<6>(1), exact});
}

TEST_CASE("no float is so near to a byte's threshold that the reference could mistake it") {
  for (int byte = 1; byte < 256; ++byte) {
    const long double threshold = srgb_decode((static_cast<long double>(byte) - 0.5L) / 255);
    const float near = static_cast<float>(threshold);
    CHECK(std::abs(static_cast<long double>(near) - threshold) > 1e-12L * threshold);
  }
}

TEST_CASE("sRGB's formulas keep their bound for every float from 0 to 1") {
  const auto encode = one_by_one([](float light) { return srgb_encode(light); });
  const auto decode = one_by_one([](float encoded) { return srgb_decode(encoded); });
  // The float nearest to 0.0031308 is above it, but takes the branch below: 7.4 ulp.
  const float joint = 0.0031308F;
  check_all(every_float(0, std::nextafter(joint, 0.F)), exact_srgb_level,
            {{.name = "srgb_encode, straight",
              .run = encode,
              .bound = 5,
              .factor = 1. / 255,
              .in_ulps = true}});
  check_all(every_float(std::nextafter(joint, 1.F), 1), exact_srgb_level,
            {{.name = "srgb_encode, curved",
              .run = encode,
              .bound = 5,
              .factor = 1. / 255,
              .in_ulps = true}});
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
void check_power(const Inputs& versines, double n) {
  check_all(versines, [n](Block& block) { exact_power(block, n); },
            {power_of<3>(n), power_of<4>(n), power_of<6>(n), power_of<8>(n)});
}

TEST_CASE("powers keep their bound for every float from 2^-32 to 1 as versine") {
  for (const double n : {5., 100.}) check_power(every_float(low, 1), n);
}

TEST_CASE("powers keep their bound for the versine of every float from 0 to 1 as cosine") {
  for (const double n : {1., 2., 3., 8., 10., 15.9, 20., 32., 50., 64., 200., 500.5, 1000., 1e4})
    check_power(versines_of_every_cosine(), n);
}

TEST_CASE("points on the circle keep their bound for every float from 2^-32 to 1/8") {
  const auto cosine = by_packs([](const Floats& x) { return on_circle_eighth(x).cosine; });
  const auto sine = by_packs([](const Floats& x) { return on_circle_eighth(x).sine; });
  check_all(every_float(low, 0.125F), exact_cosine,
            {{.name = "cosine",
              .run = cosine,
              .bound = epsilon,
              .step_back = 0.5 * epsilon,
              .falls = true}});
  check_all(every_float(low, 0.125F), exact_sine,
            {{.name = "sine", .run = sine, .bound = epsilon, .step_back = 0.5 * epsilon}});
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

TEST_CASE("the arc tangent of packs keeps its bound for every float from 2^-32 to 1") {
  check_all(every_float(low, 1), exact_eighth_turn,
            {{.name = "atan2 of packs",
              .run = by_packs([](const Floats& t) { return atan2(t, Floats(1)); }),
              .bound = 2.4,
              .factor = static_cast<double>(2 * pi_digits),
              .in_ulps = true}});
}

}  // namespace
}  // namespace texmap::test
