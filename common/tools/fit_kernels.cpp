// Finds the polynomials of common/engine/fast/coefficients.hpp: those with the smallest worst case,
// by the exchange algorithm of Remez in long double (docs/numerics.md, "Fitting polynomials"). It
// needs a long double of 64 bits or more, because it uses its library functions.
//
// What rounding adds to a polynomial is proven, not measured (tests/proofs).
//
// Usage: fit_kernels FAMILY TERMS   prints a polynomial as the file has it, all but its `rounding`
//        fit_kernels                fails unless those in the file are as good as what it finds
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/fast/coefficients.hpp"

namespace {

using Wide = long double;
using Coefficients = std::vector<Wide>;  // of a polynomial, the lowest power first
constexpr Wide pi = std::numbers::pi_v<Wide>;
constexpr Wide ln2 = std::numbers::ln2_v<Wide>;
static_assert(std::numeric_limits<Wide>::digits >= 64);

/// A function on [low, high], and the weight of an error at each point.
struct Family {
  Wide low, high;
  std::function<Wide(Wide)> value, weight;
};

/// atan(t) / t in turns as a function of t^2; errors are those of the angle.
const Family arc_tangent{0, 1,
                         [](Wide z) {
                           const Wide t = std::sqrt(z);
                           return (t == 0 ? 1 : std::atan(t) / t) / (2 * pi);
                         },
                         [](Wide z) { return std::sqrt(z); }};

/// acos(y) / sqrt(1 - y^2) in half turns; errors are those of the angle.
const Family arc_cosine{0, 1,
                        [](Wide y) {
                          const Wide s = std::sqrt((1 - y) * (1 + y));
                          return s == 0 ? 1 / pi : std::atan2(s, y) / s / pi;
                        },
                        [](Wide y) { return std::sqrt((1 - y) * (1 + y)); }};

/// log2(1 - w) / w; errors are relative to the logarithm.
const Family logarithm{0, Wide(0.5),
                       [](Wide w) { return w == 0 ? -1 / ln2 : std::log1p(-w) / w / ln2; },
                       [](Wide w) { return w == 0 ? ln2 : -w * ln2 / std::log1p(-w); }};

/// (2^y - 1) / y for the 16th root of a power; an error e of it is 16 2^(15 y) e of the power.
const Family exponential{-1, 0, [](Wide y) { return y == 0 ? ln2 : std::expm1(y * ln2) / y; },
                         [](Wide y) { return -y * 16 * std::exp2(15 * y); }};

/// 255 times the sRGB curve above its straight part, by the root of the light; errors in levels.
const Family srgb_curve{
    std::sqrt(Wide(0.0031308L)), 1,
    [](Wide r) { return 255 * (Wide(1.055L) * std::pow(r, Wide(5) / 6) - Wide(0.055L)); },
    [](Wide) { return Wide(1); }};

/// Maps x in [-1, 1] to [low, high].
Wide place(const Family& family, Wide x) {
  return (family.low + family.high + (family.high - family.low) * x) / 2;
}

/// An extremum of the Chebyshev polynomial T_n, from -1 (i = 0) to 1 (i = n): such points are as
/// dense toward the ends as the peaks of a best polynomial's error.
Wide chebyshev_point(Wide i, Wide n) { return -std::cos(pi * i / n); }

/// Gaussian elimination with the largest pivot.
std::vector<Wide> solve(std::vector<std::vector<Wide>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < n; ++row) {
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    }
    std::swap(rows[column], rows[pivot]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column) continue;
      const Wide factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= n; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::vector<Wide> x(n);
  for (std::size_t row = 0; row < n; ++row) x[row] = rows[row][n] / rows[row][row];
  return x;
}

Wide value_of(const Coefficients& powers, Wide x) {
  Wide sum = 0;
  for (std::size_t k = powers.size(); k-- > 0;) sum = sum * x + powers[k];
  return sum;
}

/// The same polynomial of the point in [low, high] as `c` is of x in [-1, 1]: Horner's rule with
/// x = scale point + shift.
Coefficients of_point(const Family& family, const Coefficients& c) {
  const Wide scale = 2 / (family.high - family.low);
  const Wide shift = -(family.high + family.low) / (family.high - family.low);
  Coefficients sum(c.size());
  for (std::size_t k = c.size(); k-- > 0;) {
    for (std::size_t i = c.size(); i-- > 0;)
      sum[i] = shift * sum[i] + (i > 0 ? scale * sum[i - 1] : c[k]);
  }
  return sum;
}

/// The largest weighted error of a polynomial, at 40000 points.
Wide worst_of(const Family& family, const Coefficients& powers) {
  constexpr int grid = 40000;
  Wide worst = 0;
  for (int i = 0; i <= grid; ++i) {
    const Wide at = place(family, chebyshev_point(i, grid));
    worst =
        std::max(worst, std::abs(family.weight(at) * (value_of(powers, at) - family.value(at))));
  }
  return worst;
}

/// The best polynomial with `count` coefficients.
Coefficients best(const Family& family, std::size_t count) {
  std::vector<Wide> points(count + 1);
  for (std::size_t i = 0; i <= count; ++i)
    points[i] = chebyshev_point(Wide(i) + Wide(0.5), Wide(count + 1));
  Coefficients best_so_far;  // where rounding dominates, a round can also increase the error
  Wide smallest = std::numeric_limits<Wide>::infinity();
  for (int round = 0; round < 30; ++round) {
    // The polynomial whose weighted errors at these points are equal, with alternating signs.
    std::vector<std::vector<Wide>> rows;
    for (std::size_t i = 0; i <= count; ++i) {
      const Wide at = place(family, points[i]);
      std::vector<Wide> row{1};
      while (row.size() < count) row.push_back(points[i] * row.back());
      row.insert(row.end(), {(i % 2 == 0 ? 1 : -1) / family.weight(at), family.value(at)});
      rows.push_back(row);
    }
    Coefficients c = solve(rows);
    c.pop_back();

    // Between two changes of sign the error has one peak: the next point.
    constexpr int grid = 20000;
    std::vector<Wide> peaks, heights;
    for (int i = 0; i <= grid; ++i) {
      const Wide x = chebyshev_point(i, grid);
      const Wide at = place(family, x);
      const Wide error = family.weight(at) * (value_of(c, x) - family.value(at));
      if (error == 0) continue;
      if (heights.empty() || (error > 0) != (heights.back() > 0)) {
        peaks.push_back(x);
        heights.push_back(error);
      } else if (std::abs(error) > std::abs(heights.back())) {
        peaks.back() = x;
        heights.back() = error;
      }
    }
    Wide highest = 0;
    for (const Wide height : heights) highest = std::max(highest, std::abs(height));
    if (highest < smallest) {
      smallest = highest;
      best_so_far = c;
    }
    // Rounding can add a change of sign where the weight is 0: drop the lower of both ends.
    while (peaks.size() > count + 1) {
      const bool front = std::abs(heights.front()) < std::abs(heights.back());
      peaks.erase(front ? peaks.begin() : peaks.end() - 1);
      heights.erase(front ? heights.begin() : heights.end() - 1);
    }
    if (peaks.size() < count + 1 || peaks == points) break;  // fewer: only rounding is left
    points = peaks;
  }
  return of_point(family, best_so_far);
}

/// Prints the best polynomial. Its bound has two digits, rounded up, so that it remains a bound.
void print(const std::string& name, const Family& family, std::size_t count) {
  const Coefficients powers = best(family, count);
  const Wide worst = worst_of(family, powers);
  const Wide unit = std::pow(Wide(10), std::floor(std::log10(worst)) - 1);
  std::cout << std::scientific << std::setprecision(1) << "template <> struct " << name << "<"
            << count << "> {\n  static constexpr double worst = " << std::ceil(worst / unit) * unit
            << ", rounding = 0;\n  static constexpr std::array<long double, " << count
            << "> powers = {" << std::setprecision(std::numeric_limits<Wide>::max_digits10 - 1);
  for (std::size_t i = 0; i < count; ++i)
    std::cout << (i == 0 ? "" : ",") << (i % 3 == 0 ? "\n      " : " ") << powers[i] << "L";
  std::cout << "};\n};\n";
}

/// Processors round long double's functions differently, so coefficients are not compared: an error
/// is at most the stated one, which is at most a tenth larger than the one found here.
template <template <int> class Fit, int... Terms>
bool are_best(const char* name, const Family& family) {
  const auto is_best = [&]<class One>(const One&) {
    const Coefficients powers(One::powers.begin(), One::powers.end());
    const bool keeps = worst_of(family, powers) <= Wide(One::worst);
    const bool tight = One::worst <= 1.1L * worst_of(family, best(family, powers.size()));
    if (keeps && tight) return true;
    std::cerr << name << "<" << powers.size() << ">: "
              << (keeps ? "there is a better polynomial\n" : "the error is larger than stated\n");
    return false;
  };
  return (is_best(Fit<Terms>()) & ...);
}

}  // namespace

int main(int count, char** arguments) {
  const std::map<std::string, const Family*> families = {{"ArcTangent", &arc_tangent},
                                                         {"ArcCosine", &arc_cosine},
                                                         {"Logarithm", &logarithm},
                                                         {"Exponential", &exponential},
                                                         {"SrgbCurve", &srgb_curve}};
  using namespace texmap::fits;
  if (count == 1) {
    return are_best<ArcTangent, 3, 5, 9, 12, 18>("ArcTangent", arc_tangent) &&
                   are_best<ArcCosine, 4, 6, 11, 15, 21>("ArcCosine", arc_cosine) &&
                   are_best<Logarithm, 3, 6>("Logarithm", logarithm) &&
                   are_best<Exponential, 2, 3>("Exponential", exponential) &&
                   are_best<SrgbCurve, 3, 4>("SrgbCurve", srgb_curve)
               ? 0
               : 1;
  }
  const auto family = families.find(arguments[1]);
  const int terms = count == 3 ? std::atoi(arguments[2]) : 0;
  if (family == families.end() || terms < 2) {
    std::cerr << "Usage: fit_kernels [FAMILY TERMS], as in coefficients.hpp\n";
    return 1;
  }
  print(family->first, *family->second, static_cast<std::size_t>(terms));
}
