// Claims of common/number/compensated.hpp and common/math/vec3.hpp: the arithmetic underneath.
#include "claims.hpp"
#include "compensated.hpp"
#include "describe.hpp"
#include "dice.hpp"
#include "digits.hpp"
#include "vec3.hpp"

namespace texmap::extremes {
namespace {

/// Exponents whose products and their rounding errors stay in range.
template <class T>
constexpr int half_range = std::numeric_limits<T>::max_exponent / 2 - std::numeric_limits<T>::digits - 2;

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
  for (int steps = dice.below(4); steps > 0; --steps) {
    d = std::nextafter(d, static_cast<T>(dice.sign()) * std::numeric_limits<T>::max());
  }
  return {a, b, c, d};
}

template <class Real, class Each>
Real lanes_of(const Each& each, std::size_t which) {
  return from_lanes<Real>([&](std::size_t i) { return each[i][which]; });
}

template <class Real, class Function>
auto worst_determinant(Function function) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] { return alike_products<T>(dice); });
    const Real got =
        function(lanes_of<Real>(each, 0), lanes_of<Real>(each, 1), lanes_of<Real>(each, 2), lanes_of<Real>(each, 3));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const auto& [a, b, c, d] = each[k];
      const Digits50 exact = Digits50(a) * Digits50(b) - Digits50(c) * Digits50(d);
      const auto where = [&each, k] {
        return described(each[k][0]) + " " + described(each[k][1]) + " " + described(each[k][2]) + " " + described(each[k][3]);
      };
      if (exact == 0) {
        worst.see(lane(got, k) == 0 ? 0 : 1e30, where);
      } else {
        worst.see(units_off(lane(got, k), exact, abs(exact) * roundoff<T>()), where);
      }
    }
  });
}

/// Sums and products whose two parts are not the exact result.
template <class Real>
auto count_inexact() {
  using T = Scalar<Real>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] { return std::array<T, 2>{signed_number<T>(dice), signed_number<T>(dice)}; });
    const TwoParts<Real> sum = two_sum(lanes_of<Real>(each, 0), lanes_of<Real>(each, 1));
    const TwoParts<Real> product = two_product(lanes_of<Real>(each, 0), lanes_of<Real>(each, 1));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      // 50 digits hold a product, but not a sum of far exponents: the parts are taken off one by one.
      const Digits50 a = each[k][0];
      const Digits50 b = each[k][1];
      const Digits50 high = lane(product.high, k);
      const Digits50 low = lane(product.low, k);
      const bool larger_a = abs(a) > abs(b);
      const Digits50 left = (larger_a ? a : b) - Digits50(lane(sum.high, k));
      const bool right = high + low == a * b && left + (larger_a ? b : a) == Digits50(lane(sum.low, k));
      worst.count(!right, [&] { return described(each[k][0]) + " " + described(each[k][1]); });
    }
  });
}

/// Scales that are no power of two or miss [1, 2).
template <class Real>
auto count_wrong_scales() {
  using T = Scalar<Real>;
  using Limits = std::numeric_limits<T>;
  return worst_over([](Dice& dice, Worst& worst) {
    const auto each = drawn<Real>([&] {
      return std::array<T, 1>{dice.once_in(8) ? static_cast<T>(1) - Limits::epsilon() * static_cast<T>(dice.within(-1, 1))
                                              : dice.number<T>(Limits::min_exponent - 1, Limits::max_exponent)};
    });
    const Real scale = power_of_two_scale(lanes_of<Real>(each, 0));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const T size = each[k][0] * lane(scale, k);
      int exponent = 0;
      const bool right = size >= 1 && size < 2 && std::frexp(lane(scale, k), &exponent) == static_cast<T>(0.5);
      worst.count(!right, [&] { return described(each[k][0]); });
    }
  });
}

/// Two vectors, nearly at a right angle or nearly parallel, often.
template <class T>
struct Pair {
  Vec3<T> a, b;
};
template <class T>
Pair<T> draw_pair(Dice& dice) {
  const Vec3<long double> a = dice.direction();
  Vec3<long double> b = dice.direction();
  if (dice.once_in(3)) b = a + b * dice.power_of_ten(-18, 0);
  if (dice.once_in(3)) b = dice.across(a) + b * dice.power_of_ten(-18, 0);
  const int most = half_range<T> - 4;
  return {scaled(rounded<T>(a), dice.within(-most, most)), scaled(rounded<T>(b), dice.within(-20, 20))};
}

template <class Real, class Function>
auto worst_pair(Function off) {
  using T = Scalar<Real>;
  return worst_over([=](Dice& dice, Worst& worst) {
    std::array<Vec3<T>, lanes<Real>> a;
    std::array<Vec3<T>, lanes<Real>> b;
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      const Pair<T> pair = draw_pair<T>(dice);
      a[k] = pair.a;
      b[k] = pair.b;
    }
    const auto got = off(gathered<Real>(a), gathered<Real>(b));
    for (std::size_t k = 0; k < lanes<Real>; ++k) {
      worst.see(got(a[k], b[k], k), [&] { return described(a[k]) + " " + described(b[k]); });
    }
  });
}

template <class T>
double relative(T got, const Digits50& exact) {
  if (exact == 0) return got == 0 ? 0 : 1e30;
  return units_off(got, exact, abs(exact) * roundoff<T>());
}

/// |a| |b|: what an error of a dot product is measured by.
template <class T>
Digits50 sizes(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<Digits50> x = exactly<Digits50>(a);
  const Vec3<Digits50> y = exactly<Digits50>(b);
  return sqrt(dot(x, x) * dot(y, y));
}

template <class Real>
void add_vectors(std::vector<Claim>& claims) {
  using T = Scalar<Real>;
  const std::string domain = "vectors of any direction, nearly parallel and nearly at right angles too; squares in range";
  claims.push_back({.function = "dot",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = 3,
                    .unit = "u of the lengths' product",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>& b) {
                      return [got = dot(a, b)](const Vec3<T>& x, const Vec3<T>& y, std::size_t k) {
                        return units_off(lane(got, k), dot(exactly<Digits50>(x), exactly<Digits50>(y)),
                                         sizes(x, y) * roundoff<T>());
                      };
                    })});
  claims.push_back({.function = "cross",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = 2,
                    .unit = "u of the lengths' product",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>& b) {
                      return [got = cross(a, b)](const Vec3<T>& x, const Vec3<T>& y, std::size_t k) {
                        const Vec3<Digits50> off =
                            exactly<Digits50>(lane_of(got, k)) - cross(exactly<Digits50>(x), exactly<Digits50>(y));
                        return static_cast<double>(sqrt(dot(off, off)) / (sizes(x, y) * roundoff<T>()));
                      };
                    })});
  claims.push_back({.function = "length",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = 2,
                    .unit = "u",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>&) {
                      return [got = length(a)](const Vec3<T>& x, const Vec3<T>&, std::size_t k) {
                        const Vec3<Digits50> p = exactly<Digits50>(x);
                        return relative(lane(got, k), sqrt(dot(p, p)));
                      };
                    })});
  claims.push_back({.function = "normalize",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = 4,
                    .unit = "u",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>&) {
                      return [got = normalize(a)](const Vec3<T>& x, const Vec3<T>&, std::size_t k) {
                        const Vec3<Digits50> p = exactly<Digits50>(x);
                        const Vec3<Digits50> off = exactly<Digits50>(lane_of(got, k)) - p * Digits50(1 / sqrt(dot(p, p)));
                        return static_cast<double>(sqrt(dot(off, off)) / roundoff<T>());
                      };
                    })});
  claims.push_back({.function = "precise_dot",
                    .number = name_of<Real>,
                    .domain = domain + "; a cosine above 16 u",
                    .bound = 2,
                    .unit = "u",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>& b) {
                      return [got = precise_dot(a, b)](const Vec3<T>& x, const Vec3<T>& y, std::size_t k) {
                        const Digits50 exact = dot(exactly<Digits50>(x), exactly<Digits50>(y));
                        if (abs(exact) < sizes(x, y) * roundoff<T>() * 16) return 0.0;
                        return relative(lane(got, k), exact);
                      };
                    })});
  claims.push_back({.function = "precise_cross, each coordinate",
                    .number = name_of<Real>,
                    .domain = domain,
                    .bound = 2,
                    .unit = "u",
                    .worst = worst_pair<Real>([](const Vec3<Real>& a, const Vec3<Real>& b) {
                      return [got = precise_cross(a, b)](const Vec3<T>& x, const Vec3<T>& y, std::size_t k) {
                        const Vec3<Digits50> exact = cross(exactly<Digits50>(x), exactly<Digits50>(y));
                        return std::max({relative(lane(got.x, k), exact.x), relative(lane(got.y, k), exact.y),
                                         relative(lane(got.z, k), exact.z)});
                      };
                    })});
}

/// Four numbers each, of size about 1, for the cost.
template <class Real>
auto fours() {
  return inputs_of_cost<Real>([](Dice& dice) {
    std::array<Real, 4> four;
    for (Real& x : four) x = from_lanes<Real>([&](std::size_t) { return static_cast<Scalar<Real>>(dice.uniform(-1, 1)); });
    return four;
  });
}

constexpr auto plain_determinant = [](const auto& a, const auto& b, const auto& c, const auto& d) { return a * b - c * d; };
constexpr auto our_determinant = [](const auto& a, const auto& b, const auto& c, const auto& d) {
  return difference_of_products(a, b, c, d);
};

template <class Real>
void add_number(std::vector<Claim>& claims) {
  claims.push_back({.function = "two_sum, two_product",
                    .number = name_of<Real>,
                    .domain = "any exponents whose product and its rounding error are in range",
                    .unit = "not exact",
                    .worst = count_inexact<Real>()});
  claims.push_back(
      {.function = "difference_of_products",
       .number = name_of<Real>,
       .domain = "as two_product; products alike in all digits or in some",
       .bound = 2,
       .unit = "u",
       .worst = worst_determinant<Real>(our_determinant),
       .cost = {"a b - c d, double",
                working_through(fours<Real>(),
                                [](const std::array<Real, 4>& x) { return difference_of_products(x[0], x[1], x[2], x[3]); }),
                working_through(fours<double>(), [](const std::array<double, 4>& x) { return x[0] * x[1] - x[2] * x[3]; })}});
  claims.push_back({.function = "power_of_two_scale",
                    .number = name_of<Real>,
                    .domain = "any normal number above 0",
                    .unit = "no power of two, or size not in [1, 2)",
                    .worst = count_wrong_scales<Real>()});
  add_vectors<Real>(claims);
}

}  // namespace

Family claims_of_arithmetic() {
  Family family{"Arithmetic", "Exact: the same sums and products in 50 digits, which hold them without rounding.", {}};
  std::vector<Claim>& claims = family.claims;
  add_number<float>(claims);
  add_number<double>(claims);
  add_number<long double>(claims);
#ifdef TEXMAP_HAVE_PACKS
  add_number<Pack<float>>(claims);
  add_number<Pack<double>>(claims);
#endif
  claims.push_back({.function = "a b - c d",
                    .number = name_of<double>,
                    .domain = "products alike in all digits or in some",
                    .bound = 2,
                    .unit = "u",
                    .worst = worst_determinant<double>(plain_determinant),
                    .expect = Expect::beyond});
  return family;
}

}  // namespace texmap::extremes
