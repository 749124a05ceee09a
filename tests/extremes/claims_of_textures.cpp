// Claims of common/texture: texel.hpp, checkerboard.hpp, solid_checkerboard.hpp, image_texture.hpp; and of
// common/image/srgb.hpp.
#include "checkerboard.hpp"
#include "claims.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "digits.hpp"
#include "image_texture.hpp"
#include "solid_checkerboard.hpp"
#include "srgb.hpp"
#include "texel.hpp"

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
template <class Real, class Index>
auto count_outside(Index index) {
  using T = Scalar<Real>;
  return worst_over(20, [=](Dice& dice, Worst& worst) {
    const int n = any_count(dice);
    const auto each = drawn<Real>([&] { return dice.anything<T>(); });
    const Real got = index(gathered_numbers<Real>(each), n);
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const T x = lane(got, k);
      worst.count(!(x >= 0 && x <= static_cast<T>(n - 1) && std::floor(x) == x),
                  [&] { return described(each[k]) + " of " + std::to_string(n); });
    }
  });
}

/// How far outside of the chosen texel the exact coordinate lies, in unit roundoffs of the whole image.
template <class Real, class Index, class Draw>
auto worst_texel(Index index, Draw draw) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const int n = any_count(dice);
    const auto each = drawn<Real>([&] { return draw(dice, n); });
    const Real got = index(gathered_numbers<Real>(each), n);
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 u = each[k];
      const Digits50 place = (u - floor(u)) * n;
      const Digits50 low = lane(got, k);
      Digits50 off = place < low ? Digits50(low - place) : place > low + 1 ? Digits50(place - low - 1) : Digits50(0);
      if (n - off < off) off = n - off;  // the other way round
      worst.see(static_cast<double>(off / (n * roundoff<T>())),
                [&] { return described(each[k]) + " of " + std::to_string(n); });
    }
  });
}

/// A coordinate in [0, 1): of any exponent, or at the edge of a texel, or a few numbers beside one.
template <class T>
T any_coordinate(Dice& dice, int n) {
  if (dice.once_in(3)) return dice.number<T>(-40, 0);
  T u = static_cast<T>(dice.below(n)) / static_cast<T>(n);
  for (int steps = dice.below(4); steps > 0; --steps) u = std::nextafter(u, static_cast<T>(dice.once_in(2) ? 0 : 1));
  return u >= 0 && u < 1 ? u : T(0);
}

/// Whole numbers that are taken for even when they are odd, or the other way.
template <class Real>
auto count_wrong_parity() {
  using T = Scalar<Real>;
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] {
      const T size = std::floor(dice.number<T>(0, 62));
      return dice.sign() < 0 ? -size : size;
    });
    const Real got = select(is_even(gathered_numbers<Real>(each)), Real(1), Real(0));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const bool even = static_cast<long long>(each[k]) % 2 == 0;
      worst.count((lane(got, k) == 1) != even, [&] { return described(each[k]); });
    }
  });
}

/// Floor of an exact number below 2^63.
long long cell_of(const Digits50& x) { return static_cast<long long>(floor(x)); }

/// True within `rounding` of an end of a cell, where rounding may choose either.
bool is_at_edge(const Digits50& x, const Digits50& rounding) { return abs(x - floor(x + Digits50(0.5))) <= rounding; }

/// Colors of the wrong square, but beside its edge.
template <class Real>
auto count_wrong_squares() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    // Below the numbers' own grid, or the squares would be finer than u and v.
    const auto squares = static_cast<double>(std::floor(dice.number<float>(0, std::numeric_limits<T>::digits - 2)));
    const auto u = drawn<Real>([&] { return static_cast<T>(dice.uniform(0, 1)); });
    const auto v = drawn<Real>([&] { return static_cast<T>(dice.uniform(0, 1)); });
    const Checkerboard board{white, black, squares};
    const Uv<Real> uv{gathered_numbers<Real>(u), gathered_numbers<Real>(v)};
    const Real got = board(uv).r;
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Digits50 column = Digits50(u[k]) * squares;
      const Digits50 row = Digits50(v[k]) * squares;
      const Digits50 rounding = squares * roundoff<T>();
      if (is_at_edge(column, rounding) || is_at_edge(row, rounding)) continue;
      const bool even = (cell_of(column) + cell_of(row)) % 2 == 0;
      worst.count((lane(got, k) == 1) != even,
                  [&] { return described(u[k]) + " " + described(v[k]) + " of " + described(squares); });
    }
  });
}

/// Colors of the wrong cube, but beside its faces.
template <class Real>
auto count_wrong_cubes() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto cell = static_cast<double>(dice.number<float>(-20, 20));
    const auto each = drawn<Real>([&] {
      const auto coordinate = [&] { return static_cast<T>(dice.sign() * dice.power_of_ten(-12, 12)); };
      return Vec3<T>{coordinate(), coordinate(), coordinate()};
    });
    const SolidCheckerboard board{white, black, cell};
    const Real got = board(gathered<Real>(each)).r;
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      long long sum = 0;
      bool unsure = false;
      for (const T x : {each[k].x, each[k].y, each[k].z}) {
        const Digits50 place = Digits50(x) / cell;
        const Digits50 rounding = abs(place) * roundoff<T>();
        unsure = unsure || is_at_edge(place, rounding);
        sum += cell_of(place);
      }
      if (unsure) continue;
      worst.count((lane(got, k) == 1) != (sum % 2 == 0), [&] { return described(each[k]) + " by " + described(cell); });
    }
  });
}

/// Cubes by the sign of sin x sin y sin z, as some programs have them.
auto count_wrong_sines() {
  return worst_over(20, [](Dice& dice, Worst& worst) {
    const auto x = static_cast<float>(dice.sign() * dice.power_of_ten(5, 6.9L));
    const float wave = std::sin(3.14159265F * x);
    const Digits50 place = x;
    if (is_at_edge(place, abs(place) * roundoff<float>())) return;
    worst.count((wave > 0) != (cell_of(place) % 2 == 0), [&] { return described(x); });
  });
}

/// Texels that come out as another byte than they are, or another texel's, for anything the type can hold as (u, v).
template <class Real>
auto count_wrong_bytes() {
  using T = Scalar<Real>;
  Image image(16, 16);
  for (std::size_t i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    image.pixels[i] = {byte, byte, byte};
  }
  return worst_over(4, [texture = ImageTexture{image}](Dice& dice, Worst& worst) {
    const auto coordinate = [&dice] { return dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.anything<T>(); };
    const auto u = drawn<Real>(coordinate);
    const auto v = drawn<Real>(coordinate);
    const Real got = texture(Uv<Real>{gathered_numbers<Real>(u), gathered_numbers<Real>(v)}).g;
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      // Sixteenths are exact, so the texel is known without rounding.
      const auto cell = [](T x) { return !(x > 0) ? 0 : x >= 1 ? 15 : static_cast<int>(x * 16); };
      const int byte = (15 - cell(v[k])) * 16 + cell(u[k]);
      worst.count(!(lane(got, k) == static_cast<T>(byte) / 255), [&] { return described(u[k]) + " " + described(v[k]); });
    }
  });
}

template <class T>
auto worst_decode() {
  return worst_over([](Dice& dice, Worst& worst) {
    const T encoded = dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0);
    // The standard's constants in decimal digits, not this number's.
    const Digits50 x = encoded;
    const Digits50 exact = x <= Digits50("0.04045")
                               ? Digits50(x / Digits50("12.92"))
                               : Digits50(pow((x + Digits50("0.055")) / Digits50("1.055"), Digits50("2.4")));
    if (is_at_edge(1 + x - Digits50("0.04045"), Digits50("1e-6"))) return;  // the two curves meet within 1e-7 only
    worst.see(ulps_off(srgb_decode(encoded), exact), [&] { return described(encoded); });
  });
}
template <class T>
auto worst_encode() {
  return worst_over([](Dice& dice, Worst& worst) {
    const T linear = dice.once_in(2) ? static_cast<T>(dice.uniform(0, 1)) : dice.number<T>(-60, 0);
    const Digits50 x = linear;
    const Digits50 exact = x <= Digits50("0.0031308")
                               ? Digits50(x * Digits50("12.92"))
                               : Digits50(Digits50("1.055") * pow(x, 1 / Digits50("2.4")) - Digits50("0.055"));
    if (is_at_edge(1 + x - Digits50("0.0031308"), Digits50("1e-7"))) return;
    worst.see(ulps_off(srgb_encode(linear), exact), [&] { return described(linear); });
  });
}

/// Bytes that do not come back from light.
template <class T, class Decode>
auto count_changed_bytes(Decode decode) {
  return count_bytes(
      [decode](int byte) { return std::lround(T(255) * srgb_encode(decode(static_cast<T>(byte) / 255))) != byte; });
}

constexpr auto floor_index = [](const auto& u, int n) { return texel_index(u, n); };
constexpr auto lecture_index = [](const auto& u, int n) { return texel_index(u, n, TexelRounding::lecture); };
constexpr auto wrap = [](const auto& u, int n) { return wrapped_index(u, n); };

template <class Real>
auto coordinates() {
  return inputs_of_cost<Real>(
      [](Dice& dice) { return from_lanes<Real>([&](std::size_t) { return static_cast<Scalar<Real>>(dice.uniform(0, 1)); }); });
}

template <class Real, class Function>
Cost cost_of(Function function) {
  return {"floor(u n), double", working_through(coordinates<Real>(), [function](const Real& u) { return function(u); }),
          working_through(coordinates<double>(), [](double u) { return floor(u * 8192); })};
}

template <class Real>
void add_number(std::vector<Claim>& claims) {
  using T = Scalar<Real>;
  const std::string anything = "anything the type can hold, infinities and NaN too; n = 1 to 2^24";
  const std::string outside = "no whole number from 0 to n - 1";
  claims.push_back({.function = "texel_index, range",
                    .number = name_of<Real>,
                    .domain = anything,
                    .unit = outside,
                    .worst = count_outside<Real>(floor_index),
                    .cost = cost_of<Real>([](const Real& u) { return texel_index(u, 8192); })});
  claims.push_back({.function = "texel_index, lecture, range",
                    .number = name_of<Real>,
                    .domain = anything,
                    .unit = outside,
                    .worst = count_outside<Real>(lecture_index)});
  claims.push_back({.function = "wrapped_index, range",
                    .number = name_of<Real>,
                    .domain = anything,
                    .unit = outside,
                    .worst = count_outside<Real>(wrap),
                    .cost = cost_of<Real>([](const Real& u) { return wrapped_index(u, 8192); })});
  claims.push_back({.function = "texel_index, distance of u from its texel",
                    .number = name_of<Real>,
                    .domain = "u in [0, 1), also at the edges of texels and a few numbers beside; n = 1 to 2^24",
                    .bound = 1,
                    .unit = "u n",
                    .worst = worst_texel<Real>(floor_index, [](Dice& dice, int n) { return any_coordinate<T>(dice, n); })});
  claims.push_back({.function = "wrapped_index, distance of u from its texel",
                    .number = name_of<Real>,
                    .domain = "u to 1e12 on either side of 0; n = 1 to 2^24",
                    .bound = 1.5,
                    .unit = "u n",
                    .worst = worst_texel<Real>(wrap, [](Dice& dice, int n) {
                      if (dice.once_in(3)) return any_coordinate<T>(dice, n);
                      return static_cast<T>(dice.sign() * dice.power_of_ten(-12, 12));
                    })});
  claims.push_back({.function = "is_even",
                    .number = name_of<Real>,
                    .domain = "any whole number (to 2^62 against integers)",
                    .unit = "wrong",
                    .worst = count_wrong_parity<Real>()});
  claims.push_back({.function = "Checkerboard",
                    .number = name_of<Real>,
                    .domain =
                        "u and v in [0, 1), 1 square to a quarter of the number's digits' worth; farther than 1 u of 1 from a "
                        "square's edge",
                    .unit = "wrong colors",
                    .worst = count_wrong_squares<Real>()});
  claims.push_back({.function = "SolidCheckerboard",
                    .number = name_of<Real>,
                    .domain = "coordinates 1e-12 to 1e12, cells 1e-6 to 1e6; farther than 1 u of itself from a cube's face",
                    .unit = "wrong colors",
                    .worst = count_wrong_cubes<Real>()});
  claims.push_back({.function = "ImageTexture",
                    .number = name_of<Real>,
                    .domain = "anything the type can hold as u and v",
                    .unit = "not a byte of the texel / 255",
                    .worst = count_wrong_bytes<Real>()});
}

template <class T>
void add_curve(std::vector<Claim>& claims, double decode, double encode) {
  claims.push_back({.function = "srgb_decode",
                    .number = name_of<T>,
                    .domain = "1e-18 to 1, but for 1e-6 around 0.04045",
                    .bound = decode,
                    .unit = "ulp",
                    .worst = worst_decode<T>()});
  claims.push_back({.function = "srgb_encode",
                    .number = name_of<T>,
                    .domain = "1e-18 to 1, but for 1e-7 around 0.0031308",
                    .bound = encode,
                    .unit = "ulp",
                    .worst = worst_encode<T>()});
  claims.push_back({.function = "srgb_encode of srgb_decode",
                    .number = name_of<T>,
                    .domain = "every byte",
                    .unit = "bytes changed",
                    .worst = count_changed_bytes<T>([](T x) { return srgb_decode(x); })});
}

}  // namespace

Family claims_of_textures() {
  Family family{"Textures",
                "Exact: whole numbers without rounding, and for the sRGB curve the standard's decimal constants in 50 digits. "
                "The last rows are a power of 2.2 in place of the curve, and the sign of a sine in place of cubes.",
                {}};
  std::vector<Claim>& claims = family.claims;
  add_number<float>(claims);
  add_number<double>(claims);
  add_number<long double>(claims);
#ifdef TEXMAP_HAVE_PACKS
  add_number<Pack<float>>(claims);
  add_number<Pack<double>>(claims);
#endif
  add_curve<float>(claims, 8, 5);
  add_curve<double>(claims, 8, 5);
  add_curve<long double>(claims, 8, 5);
  claims.push_back({.function = "srgb_encode of a power of 2.2",
                    .number = name_of<double>,
                    .domain = "every byte",
                    .unit = "bytes changed",
                    .worst = count_changed_bytes<double>([](double x) { return std::pow(x, 2.2); }),
                    .expect = Expect::beyond});
  claims.push_back({.function = "cells by the sign of sin(pi x)",
                    .number = name_of<float>,
                    .domain = "1e5 to 8e6, farther than 1 u of itself from a cell's end",
                    .unit = "wrong colors",
                    .worst = count_wrong_sines(),
                    .expect = Expect::beyond});
  return family;
}

}  // namespace texmap::extremes
