// Claims of common/number/compensated.hpp and common/math/vec3.hpp: the arithmetic underneath.
#include "claims.hpp"
#include "math/vec3.hpp"
#include "number/compensated.hpp"

namespace texmap::extremes {
namespace {

/// Exponents for which products and their rounding errors stay in range.
template <class T>
constexpr int half_range =
    std::numeric_limits<T>::max_exponent / 2 - std::numeric_limits<T>::digits - 2;

template <class T>
T signed_number(Dice& dice) {
  return static_cast<T>(dice.sign()) * dice.number<T>(-half_range<T>, half_range<T>);
}

/// a, b, c, d with a b and c d equal in all their digits, or in some.
template <class T>
std::array<T, 4> alike_products(Dice& dice) {
  const T a = signed_number<T>(dice);
  const T b = static_cast<T>(dice.sign()) * dice.number<T>(-20, 20);
  T c = a;
  T d = b;
  if (dice.once_in(2)) {
    c = static_cast<T>(a * static_cast<T>(1 + dice.sign() * dice.power_of_ten(-20, 0)));
    d = static_cast<T>(a * b / c);
  }
  for (int steps = dice.below(4); steps > 0; --steps)
    d = std::nextafter(d, static_cast<T>(dice.sign()) * std::numeric_limits<T>::max());
  return {a, b, c, d};
}

constexpr auto plain_determinant = [](const auto& x) { return x[0] * x[1] - x[2] * x[3]; };
constexpr auto our_determinant = [](const auto& x) {
  return difference_of_products(x[0], x[1], x[2], x[3]);
};

template <class Real, class Function>
auto worst_determinant(Function function) {
  using T = Scalar<Real>;
  return worst_lanes<Real>(1, alike_products<T>, function, [](T got, const std::array<T, 4>& x) {
    return relative_off(got, plain_determinant(std::array<Digits50, 4>{x[0], x[1], x[2], x[3]}));
  });
}

/// Sums and products with two parts that are not the exact result.
template <class Real>
auto count_inexact() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        return std::array<T, 2>{signed_number<T>(dice), signed_number<T>(dice)};
      },
      [](const std::array<Real, 2>& x) {
        const TwoParts<Real> sum = two_sum(x[0], x[1]);
        const TwoParts<Real> product = two_product(x[0], x[1]);
        return std::array<Real, 4>{sum.high, sum.low, product.high, product.low};
      },
      [](const std::array<T, 4>& got, const std::array<T, 2>& x) {
        const auto& [sum_high, sum_low, high, low] = got;
        // 50 digits hold a product, but not a sum of far exponents: subtract its parts singly.
        const Digits50 a = x[0];
        const Digits50 b = x[1];
        const bool larger_a = abs(a) > abs(b);
        const Digits50 left = (larger_a ? a : b) - Digits50(sum_high);
        return !(Digits50(high) + Digits50(low) == a * b &&
                 left + (larger_a ? b : a) == Digits50(sum_low));
      });
}

/// Scales that are no power of two or miss [1, 2).
template <class Real>
auto count_wrong_scales() {
  using T = Scalar<Real>;
  using Limits = std::numeric_limits<T>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        return dice.once_in(8)
                   ? static_cast<T>(1) - Limits::epsilon() * static_cast<T>(dice.within(-1, 1))
                   : dice.number<T>(Limits::min_exponent - 1, Limits::max_exponent);
      },
      [](const Real& x) { return power_of_two_scale(x); },
      [](T scale, T x) {
        int exponent = 0;
        return !(x * scale >= 1 && x * scale < 2 &&
                 std::frexp(scale, &exponent) == static_cast<T>(0.5));
      });
}

template <class Real>
using Pair = std::array<Vec3<Real>, 2>;
using ExactPair = Pair<Digits50>;

/// Two vectors, nearly at a right angle or nearly parallel, often.
template <class T>
Pair<T> draw_pair(Dice& dice) {
  const Vec3<long double> a = dice.direction();
  Vec3<long double> b = dice.direction();
  if (dice.once_in(3)) b = a + b * dice.power_of_ten(-18, 0);
  if (dice.once_in(3)) b = dice.across(a) + b * dice.power_of_ten(-18, 0);
  const int most = half_range<T> - 4;
  return {scaled(number_cast<T>(a), dice.within(-most, most)),
          scaled(number_cast<T>(b), dice.within(-20, 20))};
}

/// |a| |b|: what an error of a dot product is measured by.
Digits50 sizes(const ExactPair& p) { return sqrt(dot(p[0], p[0]) * dot(p[1], p[1])); }

template <class Real>
void add_vectors(Family& family) {
  using T = Scalar<Real>;
  using V = Vec3<T>;
  const std::string domain =
      "vectors of any direction, nearly parallel and nearly at right angles too; squares in range";
  const std::string clear = domain + "; a cosine above 16 u";
  const char* const by_sizes = "u of the lengths' product";
  // Of a function of two vectors; `off` gets its result and the exact vectors.
  const auto add = [&](const char* function, const std::string& where, const Bound& bound,
                       auto call, auto off) {
    family.add<Real>(function, where, bound,
                     worst_lanes<Real>(
                         1, draw_pair<T>, [=](const Pair<Real>& p) { return call(p[0], p[1]); },
                         [=](const auto& got, const Pair<T>& p) {
                           return off(got, ExactPair{exactly(p[0]), exactly(p[1])});
                         }));
  };
  const auto dot_off = [](T got, const ExactPair& p) {
    return units_off(got, dot(p[0], p[1]), sizes(p) * roundoff<T>());
  };
  const auto cross_off = [](const V& got, const ExactPair& p) {
    return static_cast<double>(length(exactly(got) - cross(p[0], p[1])) /
                               (sizes(p) * roundoff<T>()));
  };
  const auto clear_dot_off = [](T got, const ExactPair& p) {
    const Digits50 exact = dot(p[0], p[1]);
    return abs(exact) < sizes(p) * roundoff<T>() * 16 ? 0.0 : relative_off(got, exact);
  };
  const auto coordinates_off = [](const V& got, const ExactPair& p) {
    const Vec3<Digits50> exact = cross(p[0], p[1]);
    return std::max(
        {relative_off(got.x, exact.x), relative_off(got.y, exact.y), relative_off(got.z, exact.z)});
  };
  add(
      "dot", domain, {3, by_sizes}, [](auto& a, auto& b) { return dot(a, b); }, dot_off);
  add(
      "cross", domain, {2, by_sizes}, [](auto& a, auto& b) { return cross(a, b); }, cross_off);
  add(
      "length", domain, {2.5, "u"}, [](auto& a, auto&) { return length(a); },
      [](T got, const ExactPair& p) { return relative_off(got, length(p[0])); });
  add(
      "normalize", domain, {4.5, "u"}, [](auto& a, auto&) { return normalize(a); },
      [](const V& got, const ExactPair& p) { return length_off(got, normalize(p[0])); });
  add(
      "precise_dot", clear, {2, "u"}, [](auto& a, auto& b) { return precise_dot(a, b); },
      clear_dot_off);
  add(
      "precise_cross, each coordinate", domain, {2, "u"},
      [](auto& a, auto& b) { return precise_cross(a, b); }, coordinates_off);
}

}  // namespace

Family claims_of_arithmetic() {
  Family family{
      "Arithmetic",
      "Exact: the same sums and products in 50 digits, which hold them without rounding."};
  for_each_number([&]<class Real>() {
    family.add<Real>("two_sum, two_product",
                     "any exponents for which the product and its rounding error are in range",
                     {0, "not exact"}, count_inexact<Real>());
    family.add<Real>("difference_of_products",
                     "as two_product; products equal in all digits or in some", {2, "u"},
                     worst_determinant<Real>(our_determinant));
    family.add<Real>("power_of_two_scale", "any normal number above 0",
                     {0, "no power of two, or size not in [1, 2)"}, count_wrong_scales<Real>());
    add_vectors<Real>(family);
  });
  family.add_broken<double>("a b - c d", "products equal in all digits or in some", {2, "u"},
                            worst_determinant<double>(plain_determinant));
  return family;
}

}  // namespace texmap::extremes
