// Claims of common/texture: texel.hpp, checkerboard.hpp, solid_checkerboard.hpp, noise.hpp,
// image_texture.hpp; and of common/math/srgb.hpp.
#include "claims.hpp"
#include "math/srgb.hpp"
#include "support/whole_numbers.hpp"
#include "texture/checkerboard.hpp"
#include "texture/light_texture.hpp"
#include "texture/noise.hpp"
#include "texture/solid_checkerboard.hpp"
#include "texture/texel.hpp"

namespace texmap::extremes {
namespace {

constexpr Rgb white{1, 1, 1};
constexpr Rgb black{0, 0, 0};

/// The numbers of texels that are tried: the smallest, the largest, and any.
int any_count(Dice& dice) {
  constexpr int counts[] = {1, 2, 3, 4096, 8192, 1 << 24};
  return dice.once_in(2) ? counts[dice.below(6)] : dice.within(1, 1 << dice.below(24));
}

/// Indices that are no whole number from 0 to n - 1.
template <class Real>
Measurement count_outside(TexelRounding rounding) {
  using T = Scalar<Real>;
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const int n = any_count(dice);
    see_lanes<Real>(
        worst, [&] { return dice.anything<T>(); },
        [&](const Real& u) { return test::texel_index(u, n, rounding); },
        [&](T x, T) { return !(x >= 0 && x <= static_cast<T>(n - 1) && std::floor(x) == x); },
        [&] { return "of " + std::to_string(n); });
  });
}

/// A coordinate in [0, 1): of any exponent, or at the edge of a texel, or a few numbers from one.
template <class T>
T any_coordinate(Dice& dice, int n) {
  if (dice.once_in(3)) return dice.number<T>(-40, 0);
  T u = static_cast<T>(dice.below(n)) / static_cast<T>(n);
  for (int steps = dice.below(4); steps > 0; --steps)
    u = std::nextafter(u, static_cast<T>(dice.once_in(2) ? 0 : 1));
  return u >= 0 && u < 1 ? u : T(0);
}

/// How far outside the chosen texel the exact coordinate lies, in unit roundoffs of the image.
template <class Real>
Measurement worst_texel() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const int n = any_count(dice);
    see_lanes<Real>(
        worst, [&] { return any_coordinate<T>(dice, n); },
        [&](const Real& u) { return test::texel_index(u, n); },
        [&](T index, T u) {
          const Digits50 beyond = Digits50(u) * n - index;
          const Digits50 off = std::max({Digits50(0), Digits50(-beyond), Digits50(beyond - 1)});
          const Digits50 other_way_round = n - off;
          return static_cast<double>(std::min(off, other_way_round) / (n * roundoff<T>()));
        },
        [&] { return "of " + std::to_string(n); });
  });
}

/// Whole numbers that are taken for even when they are odd, or the other way.
template <class Real>
Measurement count_wrong_parity() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      20,
      [](Dice& dice) {
        const T size = std::floor(dice.number<T>(0, 62));
        return dice.sign() < 0 ? -size : size;
      },
      [](const Real& x) { return select(is_even(x), Real(1), Real(0)); },
      [](T even, T x) { return (even == 1) != (static_cast<long long>(x) % 2 == 0); });
}

/// Whether a board's light at exact places, each with its rounding, is that of the wrong cell.
/// Within rounding of an end of a cell either may be chosen.
template <std::size_t count>
bool is_wrong_cell(bool light, const std::array<Digits50, count>& places,
                   const std::array<Digits50, count>& roundings) {
  long long sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (abs(places[i] - floor(places[i] + Digits50(0.5))) <= roundings[i]) return false;
    sum += static_cast<long long>(floor(places[i]));
  }
  return light != (sum % 2 == 0);
}

/// Colors of the wrong square, but near its edge.
template <class Real>
Measurement count_wrong_squares() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    // Below the numbers' own grid, or the squares would be finer than u and v.
    const auto squares =
        static_cast<double>(std::floor(dice.number<float>(0, std::numeric_limits<T>::digits - 2)));
    const Checkerboard board{white, black, squares};
    const auto coordinate = [&] { return static_cast<T>(dice.uniform(0, 1)); };
    see_lanes<Real>(
        worst,
        [&] {
          return Uv<T>{coordinate(), coordinate()};
        },
        [&](const Uv<Real>& uv) { return board(uv).r; },
        [&](T light, const Uv<T>& uv) {
          const Digits50 rounding = squares * roundoff<T>();
          return is_wrong_cell<2>(light == 1, {uv.u * Digits50(squares), uv.v * Digits50(squares)},
                                  {rounding, rounding});
        },
        [&] { return "of " + described(squares); });
  });
}

/// Colors of the wrong cube, but near its faces.
template <class Real>
Measurement count_wrong_cubes() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const auto cell = static_cast<double>(dice.number<float>(-20, 20));
    const SolidCheckerboard board{white, black, cell};
    const auto coordinate = [&] {
      return static_cast<T>(dice.sign() * dice.power_of_ten(-12, 12));
    };
    see_lanes<Real>(
        worst,
        [&] {
          return Vec3<T>{coordinate(), coordinate(), coordinate()};
        },
        [&](const Vec3<Real>& p) { return board(p).r; },
        [&](T light, const Vec3<T>& p) {
          const Vec3<Digits50> at = exactly(p) * (1 / Digits50(cell));
          const Digits50& u = roundoff<T>();
          return is_wrong_cell<3>(light == 1, {at.x, at.y, at.z},
                                  {abs(at.x) * u, abs(at.y) * u, abs(at.z) * u});
        },
        [&] { return "by " + described(cell); });
  });
}

/// Cubes by the sign of sin x sin y sin z, as some programs have them.
Measurement count_wrong_sines() {
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const auto x = static_cast<float>(dice.sign() * dice.power_of_ten(5, 6.9L));
    const bool light = std::sin(3.14159265F * x) > 0;
    worst.see(is_wrong_cell<1>(light, {Digits50(x)}, {abs(Digits50(x)) * roundoff<float>()}),
              [&] { return described(x); });
  });
}

/// Noise against the same formula in 50 digits: only rounding differs.
template <class Real>
Measurement worst_noise() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        const auto coordinate = [&dice] {
          return static_cast<T>(dice.sign()) * (dice.once_in(4)
                                                    ? dice.number<T>(-40, 0)
                                                    : static_cast<T>(dice.power_of_ten(-3, 5)));
        };
        return Vec3<T>{coordinate(), coordinate(), coordinate()};
      },
      [](const Vec3<Real>& p) { return gradient_noise(p); },
      [](T noise, const Vec3<T>& p) {
        return static_cast<double>(abs(noise - gradient_noise(exactly(p))) / roundoff<T>());
      });
}

/// Texels that come out as a wrong byte or as another texel's, for any (u, v) that the type holds.
template <class Real>
Measurement count_wrong_bytes() {
  using T = Scalar<Real>;
  Image image(16, 16);
  for (std::size_t i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    image.pixels[i] = {byte, byte, byte};
  }
  return worst_over(4, [texture = ImageTexture{image}](Dice& dice, Worst& worst) {
    const auto coordinate = [&dice] {
      return dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.anything<T>();
    };
    see_lanes<Real>(
        worst,
        [&] {
          return Uv<T>{coordinate(), coordinate()};
        },
        [&](const Uv<Real>& uv) { return texture(uv).g; },
        [](T light, const Uv<T>& uv) {
          // Sixteenths are exact, so the texel is known without rounding.
          const auto cell = [](T x) {
            return !(x > 0) ? 0 : x >= 1 ? 15 : static_cast<int>(x * 16);
          };
          return !(light == static_cast<T>((15 - cell(uv.v)) * 16 + cell(uv.u)) / 255);
        });
  });
}

/// A part of the sRGB curve, in the standard's decimal digits instead of this number's.
template <class T, class Function>
Measurement worst_curve(Function function, Digits50 (*exact)(const Digits50&), const char* joint,
                        const char* around_joint) {
  return worst_over(
      1, [=, from = Digits50(joint), width = Digits50(around_joint)](Dice& dice, Worst& worst) {
        const T x = dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0);
        if (abs(Digits50(x) - from) <= width) return;  // the two curves meet only nearly
        worst.see(ulps_off(function(x), exact(Digits50(x))), [&] { return described(x); });
      });
}

constexpr auto decode = [](auto x) { return srgb_decode(x); };
constexpr auto encode = [](auto x) { return srgb_encode(x); };

Digits50 exact_decode(const Digits50& x) {
  return x <= Digits50("0.04045")
             ? Digits50(x / Digits50("12.92"))
             : Digits50(pow((x + Digits50("0.055")) / Digits50("1.055"), Digits50("2.4")));
}
Digits50 exact_encode(const Digits50& x) {
  return x <= Digits50("0.0031308")
             ? Digits50(x * Digits50("12.92"))
             : Digits50(Digits50("1.055") * pow(x, 1 / Digits50("2.4")) - Digits50("0.055"));
}

/// The table's light of every byte, which the compiler rounds once from more digits.
template <class T>
Measurement worst_table() {
  return worst_byte([](int byte) {
    const T light = light_of_bytes<T>(TexelLight::linear)[static_cast<std::size_t>(byte)];
    return ulps_off(light, exact_decode(Digits50(byte) / 255));
  });
}

/// Bytes that do not come back from light.
template <class T, class Decode>
Measurement count_changed_bytes(Decode to_light) {
  return worst_byte([to_light](int byte) {
    return std::lround(T(255) * srgb_encode(to_light(static_cast<T>(byte) / 255))) != byte;
  });
}

}  // namespace

Family claims_of_textures() {
  Family family{"Textures",
                "Exact: whole numbers without rounding, and for the sRGB curve the standard's "
                "decimal constants in 50 digits. The last rows are a power of 2.2 in place of the "
                "curve, and the sign of a sine in place of cubes."};
  const std::string anything = "anything the type can hold, infinities and NaN too; n = 1 to 2^24";
  const Bound whole{0, "no whole number from 0 to n - 1"};
  const Bound none{0, "wrong colors"};
  for_each_number([&]<class Real>() {
    family.add<Real>("texel_number, range", anything, whole,
                     count_outside<Real>(TexelRounding::floor));
    family.add<Real>("texel_number, lecture, range", anything, whole,
                     count_outside<Real>(TexelRounding::lecture));
    family.add<Real>("texel_number, distance of u from its texel",
                     "u in [0, 1), also at the edges of texels and a few numbers away; n = 1 to "
                     "2^24",
                     {1, "u n"}, worst_texel<Real>());
    family.add<Real>("is_even", "any whole number (to 2^62 against integers)", {0, "wrong"},
                     count_wrong_parity<Real>());
    family.add<Real>("Checkerboard",
                     "u and v in [0, 1), 1 square to a quarter of the number's digits' worth; "
                     "farther than 1 u of 1 from a square's edge",
                     none, count_wrong_squares<Real>());
    family.add<Real>("SolidCheckerboard",
                     "coordinates 1e-12 to 1e12, cells 1e-6 to 1e6; farther than 1 u of itself "
                     "from a cube's face",
                     none, count_wrong_cubes<Real>());
    family.add<Real>("gradient_noise", "coordinates of 1e-12 to 1e5, of either sign", {3, "u"},
                     worst_noise<Real>());
    family.add<Real>("ImageTexture", "anything the type can hold as u and v",
                     {0, "not a byte of the texel / 255"}, count_wrong_bytes<Real>());
  });
  const Bound no_byte{0, "bytes changed"};
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("srgb_decode", "1e-18 to 1, but for 1e-6 around 0.04045", {8, "ulp"},
                  worst_curve<T>(decode, exact_decode, "0.04045", "1e-6"));
    family.add<T>("srgb_encode", "1e-18 to 1, but for 1e-7 around 0.0031308", {5, "ulp"},
                  worst_curve<T>(encode, exact_encode, "0.0031308", "1e-7"));
    family.add<T>("srgb_encode of srgb_decode", "every byte", no_byte,
                  count_changed_bytes<T>(decode));
  });
  for_each<float, double, long double>([&]<class T>() {
    family.add<T>("light_of_bytes", "every byte", {by_number<T>(0.5, 0.5, 8.), "ulp"},
                  worst_table<T>());
  });
  family.add_broken<double>("srgb_encode of a power of 2.2", "every byte", no_byte,
                            count_changed_bytes<double>([](double x) { return std::pow(x, 2.2); }));
  family.add_broken<float>("cells by the sign of sin(pi x)",
                           "1e5 to 8e6, farther than 1 u of itself from a cell's end", none,
                           count_wrong_sines());
  return family;
}

}  // namespace texmap::extremes
