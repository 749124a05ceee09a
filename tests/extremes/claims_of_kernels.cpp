// Claims of common/engine/fast, and of what else was tried on every input or proven: the rows of
// the page that tests/exhaustive and tests/proofs hold.
#include <algorithm>

#include "claims.hpp"
#include "engine/fast/power_kernel.hpp"
#include "engine/fast/root_texture.hpp"
#include "engine/fast/srgb_kernel.hpp"
#include "engine/fast/turns.hpp"

namespace texmap::extremes {
namespace {

template <class T>
void add(Family& family, const std::string& function, const std::string& domain, const Bound& bound,
         const std::string& certainty) {
  family.add<T>(function, domain, bound, {}).certainty = certainty;
}

/// The largest of a constant of the kernels over the sizes of their polynomials.
template <class T, int... Degree>
UvError largest_rounding() {
  return {std::max({FastUnitMapping<Degree>::template rounding<T>.u...}),
          std::max({FastUnitMapping<Degree>::template rounding<T>.v...})};
}

template <int Terms>
void add_power(Family& family, const std::string& proven) {
  const std::string name = "PowerKernel, " + std::to_string(Terms) + " terms";
  const char* const levels = "levels of 255";
  add<float>(family, name, "14 exponents from 1 to 1e4, cosines of 0 to 1",
             {PowerKernel<Terms>::template worst_levels<float>, levels},
             "exhaustive, the versine of every cosine: 1.7e7 an exponent");
  add<double>(family, name, "every exponent, cosines of 0 to 1",
              {PowerKernel<Terms>::template worst_levels<double>, levels}, proven);
}

template <class T>
void add_texels(Family& family) {
  const Bound none{0, "in another texel"};
  add<T>(family, "texel_number, middles", "the middle of every texel of 1 to 16384", none,
         "exhaustive, 1.3e8 texels");
  add<T>(family, "texel_number, ends", "0, 1 and the number below 1, of 1 to 2^24 texels", none,
         "exhaustive, 1.7e7 sizes");
  add<T>(family, "BilinearTexture, wraps", "every k from -3 n to 3 n of n = 1 to 1024 texels", none,
         "exhaustive, 3.1e6 places");
  add<T>(family, "BilinearTexture, half texels",
         "the middle and the edge of every texel of 1 to 2048", {0, "off by more than 2 u n + 4 u"},
         "exhaustive, 4.2e6 places");
}

}  // namespace

Family claims_of_kernels() {
  Family family{
      "Every input, and proofs",
      "These bounds are not measured here: tests/exhaustive runs every input, tests/proofs "
      "proves what rounding adds. [numerics.md](numerics.md) has the sums."};
  const std::string proven = "proven (Gappa; the fit's error by fit_kernels)";

  const UvError in_float = largest_rounding<float, 5, 9, 17>();
  const UvError in_double = largest_rounding<double, 5, 9, 17, 23, 35>();
  const char* const turns = "epsilon and the fit's error, in turns";
  add<float>(family, "FastUnitMapping, u", "degrees 5, 9 and 17, any angle", {in_float.u, turns},
             "exhaustive, every float from 2^-12 to 1 as slope in 8 octants: 8.1e8 a degree");
  add<double>(family, "FastUnitMapping, u", "degrees 5 to 35, any angle", {in_double.u, turns},
              proven);
  add<float>(family, "FastUnitMapping, v", "degrees 5, 9 and 17, unit vectors", {in_float.v, turns},
             "exhaustive, every float from 2^-32 to 1 as height: 2.7e8 a degree");
  add<double>(family, "FastUnitMapping, v", "degrees 5 to 35, unit vectors", {in_double.v, turns},
              proven);
  add<float>(family, "eighth_turn, step back", "degrees 5, 9 and 17, slopes from 0 to 1",
             {0.32, "epsilon between neighbors"},
             "exhaustive, every float from 2^-32 to 1: 2.7e8 a degree");
  add<Pack<float>>(family, "atan2", "slopes from 2^-32 to 1", {2.4, "ulp"},
                   "exhaustive, 2.7e8 floats");
  add<float>(family, "on_circle_eighth", "2^-32 to an eighth of a turn", {2, "u of 1"},
             "exhaustive, 2.4e8 floats");

  const std::string light = "light of 0 to 1";
  const std::string every = "exhaustive, every float from 2^-32 to 1: 2.7e8";
  const std::string from_0 = "exhaustive, every float from 0 to 1: 1.07e9";
  const char* const levels = "levels of 255";
  add<float>(family, "srgb_level, 3 terms", light, {fits::SrgbCurve<3>::worst, levels}, every);
  add<float>(family, "srgb_level, 4 terms", light, {fits::SrgbCurve<4>::worst, levels}, every);
  add<float>(family, "srgb_byte_exact", light, {0, "wrong bytes"}, every);
  add<float>(family, "srgb_decode", "0 to 1", {8, "ulp"}, from_0);
  add<float>(family, "srgb_encode", "0 to 1, but the float next to 0.0031308", {5, "ulp"}, from_0);
  add<float>(family, "RootTexture", "light of 2^-32 to 1", {RootTexture::worst_levels, levels},
             "exhaustive, 2.7e8 floats");
  add_power<3>(family, proven);
  add_power<6>(family, proven);
  for_each<float, double>([&]<class T>() { add_texels<T>(family); });
  add<float>(family, "uniform_disk", "the outermost six rings of samples", {0, "outside the disk"},
             "exhaustive, 1e8 samples");
  return family;
}

}  // namespace texmap::extremes
