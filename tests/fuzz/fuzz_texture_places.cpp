// Any bits as directions and texture coordinates: every place is on the texture, every color is
// the image's, and a pack computes in each lane what a single number does.
//
// An input is a Head and then packs of numbers: x, y, z of a direction, u and v. What is missing
// at its end is 0.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <type_traits>

#include "fuzz/target.hpp"
#include "number/kinds/pack2.hpp"
#include "support/lane_of.hpp"
#include "texture/bilinear.hpp"
#include "texture/checkerboard.hpp"
#include "texture/conventions.hpp"
#include "texture/rotated.hpp"
#include "texture/solid_checkerboard.hpp"

namespace texmap::test {
namespace {

/// The first bytes of an input.
struct Head {
  std::uint8_t number;         // which number is tried, modulo 4
  std::uint8_t choices;        // bits: v axis, rounding, and two for the light
  std::uint8_t width, height;  // of a small image, 1 to 4 modulo 4
  std::uint32_t texels;        // of a large one, 1 to 2^24 modulo 2^24
  std::uint32_t squares;       // of a board, 1 to 2^22 modulo 2^22
  std::uint32_t colors;        // of the small image
  double degrees, cell;
};
static_assert(sizeof(Head) == 32);

class Bits {
 public:
  explicit Bits(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class T>
  [[nodiscard]] T take() {
    T value{};
    const std::size_t size = std::min(sizeof(T), rest_.size());
    if (size > 0) std::memcpy(&value, rest_.data(), size);
    rest_ = rest_.subspan(size);
    return value;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

/// The same number, or no number in both. The sign of a zero may differ (floor(-0) by SSE2).
template <class T>
bool same(T a, T b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}
template <class T>
bool same(const Color<T>& a, const Color<T>& b) {
  return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b);
}
template <class T>
bool same(const Uv<T>& a, const Uv<T>& b) {
  return same(a.u, b.u) && same(a.v, b.v);
}

template <class T>
void check_on_texture(const Uv<T>& uv) {
  claim(uv.u >= 0 && uv.u < 1, "u is in [0, 1)");
  claim(uv.v >= 0 && uv.v <= 1, "v is in [0, 1]");
}

// Directions.

template <class Real>
void check_directions(const Head& head, const Vec3<Real>& p) {
  const RotationY turn = rotation_y(head.degrees);
  const Vec3<Real> turned = turn(p);
  for (const Convention convention : {Convention::rtiow, Convention::daily, Convention::lecture}) {
    const Uv<Real> uv = uv_of(convention, p);
    const Uv<Real> uv_turned = Rotated<ConventionMapping>{turn, {convention}}(p);
    for (std::size_t i = 0; i < lanes<Real>; ++i) {
      check_on_texture(lane_of(uv, i));
      check_on_texture(lane_of(uv_turned, i));
      check_on_texture(uv_of(convention, lane_of(p, i)));
      check_on_texture(uv_of(convention, lane_of(turned, i)));
    }
  }
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const Vec3<Scalar<Real>> one = lane_of(p, i);
    claim(same(uv_rtiow(one), uv_rtiow(one + Vec3<Scalar<Real>>{})), "-0 has the place of 0");
    const auto other = lane_of(turned, i);
    claim(same(turn(one).x, other.x) && same(turn(one).z, other.z), "a lane is turned as a number");
    claim(same(one.y, other.y), "a turn about y keeps y");
  }
}

// Texels.

template <class T>
void check_texel(T u, int n, TexelRounding rounding) {
  const int texel = texel_number(u, n, rounding);
  claim(texel >= 0 && texel < n, "a texel is from 0 to n - 1");
  if (!(u > T(0))) claim(texel == 0, "0, what is below, and no number are in the first texel");
  if (u >= T(1)) claim(texel == n - 1, "1 and what is above are in the last texel");
}

template <class Real>
void check_texels(const Head& head, const Uv<Real>& uv) {
  const int n = static_cast<int>(head.texels % (1U << 24)) + 1;
  const int rows = static_cast<int>(head.squares % (1U << 24)) + 1;
  for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture}) {
    for (const VAxis axis : {VAxis::up, VAxis::down}) {
      const TexelPlace<Real> place = texel_place(uv, n, rows, axis, rounding);
      for (std::size_t i = 0; i < lanes<Real>; ++i) {
        const auto one = lane_of(uv, i);
        check_texel(one.u, n, rounding);
        check_texel(one.v, rows, rounding);
        const auto alone = texel_place(one, n, rows, axis, rounding);
        claim(alone.row >= 0 && alone.row < rows, "a row is in the image");
        claim(static_cast<double>(lane(place.column, i)) == alone.column &&
                  static_cast<double>(lane(place.row, i)) == alone.row,
              "a lane has the texel of a number");
      }
    }
  }
}

// Colors.

bool is_color(const auto& color, const Rgb& of) {
  return same(color, number_cast<std::remove_cvref_t<decltype(color.r)>>(of));
}

template <class Real>
void check_boards(const Head& head, const Vec3<Real>& p, const Uv<Real>& uv) {
  constexpr Rgb black{0, 0, 0};
  constexpr Rgb white{1, 1, 1};
  const Checkerboard board{black, white, head.squares % (1U << 22) + 1.0};
  const bool has_cell = head.cell > 0 && Scalar<Real>(head.cell) > 0;
  const SolidCheckerboard solid{black, white, has_cell ? head.cell : 1};
  const Color<Real> color = board(uv);
  const Color<Real> cube = solid(p);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const auto one = lane_of(color, i);
    claim(is_color(one, black) || is_color(one, white), "a board has two colors");
    claim(same(one, board(lane_of(uv, i))), "a lane has the square of a number");
    const auto other = lane_of(cube, i);
    claim(is_color(other, black) || is_color(other, white), "cubes have two colors");
    claim(same(other, solid(lane_of(p, i))), "a lane has the cube of a number");
  }
}

Image small_image(const Head& head) {
  Image image(head.width % 4 + 1, head.height % 4 + 1);
  std::minstd_rand random(head.colors + 1);
  for (Rgb8& pixel : image.pixels) {
    const auto bits = static_cast<std::uint32_t>(random());
    pixel = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
             static_cast<std::uint8_t>(bits >> 16)};
  }
  return image;
}

template <class T>
std::array<T, 3> channels(const Color<T>& color) {
  return {color.r, color.g, color.b};
}

template <class T>
void check_filtered(const BilinearTexture& texture, const Uv<T>& uv, const Color<T>& color,
                    const std::vector<Color<T>>& texels) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto less = [k](const Color<T>& a, const Color<T>& b) {
      return channels(a)[k] < channels(b)[k];
    };
    const auto [lowest, highest] = std::minmax_element(texels.begin(), texels.end(), less);
    claim(channels(color)[k] >= channels(*lowest)[k] && channels(color)[k] <= channels(*highest)[k],
          "a mixed color is between those of the image");
  }
  if (!std::isfinite(uv.u)) claim(same(color, texture(Uv<T>{T(0), uv.v})), "u counts as 0");
  if (std::isnan(uv.v)) claim(same(color, texture(Uv<T>{uv.u, T(0)})), "v counts as 0");
}

template <class Real>
void check_images(const Head& head, const Uv<Real>& uv) {
  using T = Scalar<Real>;
  const Image image = small_image(head);
  const VAxis axis = (head.choices & 1) != 0 ? VAxis::up : VAxis::down;
  const auto rounding = (head.choices & 2) != 0 ? TexelRounding::floor : TexelRounding::lecture;
  const auto light = static_cast<TexelLight>((head.choices >> 2 & 3) % 3);
  const LightTexture nearest{{image, axis, rounding}, light};
  const BilinearTexture bilinear{image, axis, light};

  std::vector<Color<T>> texels;
  const auto& table = light_of_bytes<T>(light);
  for (const Rgb8& texel : image.pixels)
    texels.push_back({table[texel.r], table[texel.g], table[texel.b]});

  const Color<Real> found = nearest(uv);
  const Color<Real> mixed = bilinear(uv);
  for (std::size_t i = 0; i < lanes<Real>; ++i) {
    const Uv<T> one = lane_of(uv, i);
    const Color<T> color = lane_of(found, i);
    claim(std::any_of(texels.begin(), texels.end(),
                      [&](const Color<T>& texel) { return same(texel, color); }),
          "the nearest color is one of the image's");
    claim(same(color, nearest(one)), "a lane has the color of a number");
    check_filtered(bilinear, one, lane_of(mixed, i), texels);
    claim(same(lane_of(mixed, i), bilinear(one)), "a lane has the mixed color of a number");
  }
}

template <class Real>
void check_all(const Head& head, Bits& bits) {
  const auto take = [&bits] {
    return from_lanes<Real>([&bits](std::size_t) { return bits.take<Scalar<Real>>(); });
  };
  const Real x = take();
  const Real y = take();
  const Real z = take();
  const Real u = take();
  const Real v = take();
  const Vec3<Real> p{x, y, z};
  check_directions(head, p);
  for (const Uv<Real>& uv : {Uv<Real>{u, v}, uv_rtiow(p)}) {
    check_texels(head, uv);
    check_boards(head, p, uv);
    check_images(head, uv);
  }
}

// A number at a limit, or one at an edge of texels; a few steps away from it, with either sign.
template <class T>
T hard_number(std::minstd_rand& random) {
  using Limits = std::numeric_limits<T>;
  const auto below = [&random](unsigned end) { return static_cast<unsigned>(random() >> 8) % end; };
  const T parts = static_cast<T>(1U << below(25));
  const T table[] = {T(0),
                     T(1),
                     T(90) * static_cast<T>(below(9)),
                     Limits::denorm_min(),
                     Limits::min(),
                     Limits::max(),
                     Limits::epsilon(),
                     Limits::infinity(),
                     Limits::quiet_NaN(),
                     static_cast<T>(below(17)) / static_cast<T>(below(16) + 1),
                     std::floor(static_cast<T>(below(1U << 20)) / T(1 << 20) * parts) / parts};
  T number = table[below(std::size(table))];
  const T towards = below(2) == 0 ? T(-1) : Limits::infinity();
  for (unsigned steps = below(4); steps > 0; --steps) number = std::nextafter(number, towards);
  return below(2) == 0 ? number : -number;
}

template <class T>
void put_hard_number(std::uint8_t* data, std::size_t size, std::minstd_rand& random) {
  const std::size_t first = offsetof(Head, degrees);
  const std::size_t places = (size - first) / sizeof(T);
  const T number = hard_number<T>(random);
  std::memcpy(data + first + (random() >> 8) % places * sizeof(T), &number, sizeof(T));
}

constexpr std::size_t whole_input = sizeof(Head) + 5 * 2 * 16;

}  // namespace
}  // namespace texmap::test

// Changes made to single bits hardly ever give 1, an infinity or the edge of a texel.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace texmap::test;
  if (seed % 4 == 0 || max_size < whole_input) return LLVMFuzzerMutate(data, size, max_size);
  if (size < whole_input) std::memset(data + size, 0, whole_input - size);
  size = std::max(size, whole_input);
  std::minstd_rand random(seed);
  for (unsigned changes = seed / 4 % 4 + 1; changes > 0; --changes) {
    if (data[0] % 2 == 0) {
      put_hard_number<float>(data, size, random);
    } else {
      put_hard_number<double>(data, size, random);
    }
  }
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace texmap;
  test::Bits bits({data, size});
  const auto head = bits.take<test::Head>();
  switch (head.number % 4) {
    case 0:
      test::check_all<Pack<float>>(head, bits);
      break;
    case 1:
      test::check_all<Pack<double>>(head, bits);
      break;
    case 2:
      test::check_all<Pack2<Pack<float>>>(head, bits);
      break;
    default:
      test::check_all<Pack2<Pack<double>>>(head, bits);
  }
  return 0;
}
