// Shared by the suites of the kernels: references with more digits, and inputs that seek the worst.
#pragma once
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "math/vec3.hpp"
#include "number/kinds/pack.hpp"
#include "support/dice.hpp"
#include "support/many_digits.hpp"

#define TEXMAP_KERNEL_NUMBERS float, double, long double, Pack<float>, Pack<double>

namespace texmap::test {

#ifdef TEXMAP_HAVE_DIGITS
using Reference = Digits50;
#else
using Reference = long double;
#endif

/// Unit vectors of T, both rounded from more digits and made by `normalize`: on axes and diagonals,
/// all over the globe, and at all distances from poles and seams.
template <class T>
std::vector<Vec3<T>> unit_vectors(int count) {
  std::vector<Vec3<T>> all;
  const auto add = [&all](long double x, long double y, long double z) {
    const long double length = std::sqrt(x * x + y * y + z * z);
    all.push_back(
        {static_cast<T>(x / length), static_cast<T>(y / length), static_cast<T>(z / length)});
    all.push_back(normalize(Vec3<T>{static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)}));
  };
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if (x != 0 || z != 0) add(x, y, z);
      }
    }
  }
  Dice dice;
  for (int i = 0; i < count; ++i) {
    const long double a = dice.between(0, 6.283185307179586);
    const long double y = dice.between(-1, 1);
    const long double s = std::sqrt((1 - y) * (1 + y));
    add(s * std::cos(a), y, s * std::sin(a));
    add(dice.any_size(-12, 0), dice.any_size(-12, 0), dice.any_size(-12, 0));
    // Where the polynomials end: the diagonals, a hair's breadth to either side.
    const double off = 1 + dice.any_size(-9, -1);
    add(std::cos(a), off, std::sin(a));
    add(1, y, off);
    add(y < 0 ? -1 : 1, off, -1);
  }
  return all;
}

}  // namespace texmap::test
