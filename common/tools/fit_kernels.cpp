// Makes common/engine/fast/coefficients.hpp: polynomials with the smallest worst case for the
// kernels, by the exchange algorithm of Remez in long double (docs/numerics.md, "Fitting
// polynomials"). The worst case in the file is measured on the printed coefficients. Needs a long
// double of 64 bits or more, because it uses its library functions.
//
// What rounding adds to a polynomial is proven, not measured (tests/proofs).
//
// Usage: fit_kernels FILE           writes the file
//        fit_kernels --check FILE   fails unless the file is as good as what it would write
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numbers>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Wide = long double;
constexpr Wide pi = std::numbers::pi_v<Wide>;
constexpr Wide ln2 = std::numbers::ln2_v<Wide>;

/// A function to approximate on [low, high], and the weight of an error at each point.
struct Problem {
  Wide low, high;
  std::function<Wide(Wide)> value;
  std::function<Wide(Wide)> weight;
};

/// A polynomial's coefficients by powers, and a bound of its weighted error, as the file shows it.
struct Fit {
  std::vector<Wide> powers;
  std::string worst;
};

/// Maps x in [-1, 1] to [low, high].
Wide place(const Problem& problem, Wide x) {
  return (problem.low + problem.high + (problem.high - problem.low) * x) / 2;
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
    for (std::size_t row = column + 1; row < n; ++row) {
      const Wide factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= n; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::vector<Wide> x(n);
  for (std::size_t row = n; row-- > 0;) {
    Wide rest = rows[row][n];
    for (std::size_t k = row + 1; k < n; ++k) rest -= rows[row][k] * x[k];
    x[row] = rest / rows[row][row];
  }
  return x;
}

/// The sum of c[k] T_k(x), by Clenshaw's algorithm.
Wide chebyshev_sum(const std::vector<Wide>& c, Wide x) {
  Wide next = 0;
  Wide after = 0;
  for (std::size_t k = c.size(); k-- > 1;) {
    const Wide now = 2 * x * next - after + c[k];
    after = next;
    next = now;
  }
  return x * next - after + c[0];
}

/// The coefficients of the same polynomial by powers of the point in [low, high].
std::vector<Wide> by_powers(const Problem& problem, const std::vector<Wide>& c) {
  const Wide scale = 2 / (problem.high - problem.low);
  const Wide shift = -(problem.high + problem.low) / (problem.high - problem.low);
  std::vector<Wide> sum(c.size(), 0);
  std::vector<Wide> before(c.size(), 0);
  std::vector<Wide> now(c.size(), 0);
  now[0] = 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    for (std::size_t i = 0; i < c.size(); ++i) sum[i] += c[k] * now[i];
    // T_1 = x T_0, and T_(k+1) = 2 x T_k - T_(k-1) from there on.
    const Wide factor = k == 0 ? 1 : 2;
    std::vector<Wide> next(c.size(), 0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      next[i] = factor * (shift * now[i] + (i > 0 ? scale * now[i - 1] : 0)) - before[i];
    }
    before = now;
    now = next;
  }
  return sum;
}

/// The largest weighted error of a polynomial given by powers, at 40000 points.
Wide worst_of(const Problem& problem, const std::vector<Wide>& powers) {
  constexpr int grid = 40000;
  Wide worst = 0;
  for (int i = 0; i <= grid; ++i) {
    const Wide at = place(problem, chebyshev_point(i, grid));
    Wide sum = 0;
    for (std::size_t k = powers.size(); k-- > 0;) sum = sum * at + powers[k];
    worst = std::max(worst, std::abs(problem.weight(at) * (sum - problem.value(at))));
  }
  return worst;
}

/// `x` in scientific notation.
std::string shown(Wide x, int digits) {
  std::ostringstream out;
  out << std::scientific << std::setprecision(digits - 1) << x;
  return out.str();
}

/// Two digits, rounded up, so that a bound remains a bound.
std::string shown_bound(Wide x) {
  const Wide unit = std::pow(Wide(10), std::floor(std::log10(x)) - 1);
  return shown(std::ceil(x / unit) * unit, 2);
}

/// The best polynomial with `count` coefficients.
Fit best(const Problem& problem, std::size_t count) {
  constexpr int grid = 20000;
  std::vector<Wide> points(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    points[i] = chebyshev_point(static_cast<Wide>(i) + Wide(0.5), static_cast<Wide>(count + 1));
  }
  std::vector<Wide> c(count);
  std::vector<Wide> best_c(count);  // where rounding dominates, a round can also increase the error
  Wide smallest = std::numeric_limits<Wide>::infinity();
  const auto error = [&](Wide x) {
    const Wide at = place(problem, x);
    return problem.weight(at) * (chebyshev_sum(c, x) - problem.value(at));
  };
  for (int round = 0; round < 30; ++round) {
    std::vector<std::vector<Wide>> rows;
    for (std::size_t i = 0; i <= count; ++i) {
      const Wide at = place(problem, points[i]);
      std::vector<Wide> row{1, points[i]};
      while (row.size() < count) row.push_back(2 * points[i] * row.back() - row[row.size() - 2]);
      row.resize(count);
      row.push_back((i % 2 == 0 ? 1 : -1) / problem.weight(at));
      row.push_back(problem.value(at));
      rows.push_back(row);
    }
    const std::vector<Wide> solution = solve(rows);
    c.assign(solution.begin(), solution.end() - 1);

    // Between two changes of sign the error has one peak: the next point.
    std::vector<Wide> peaks;
    std::vector<Wide> heights;
    for (int i = 0; i <= grid; ++i) {
      const Wide x = chebyshev_point(i, grid);
      const Wide e = error(x);
      if (e == 0) continue;
      if (heights.empty() || (e > 0) != (heights.back() > 0)) {
        peaks.push_back(x);
        heights.push_back(e);
      } else if (std::abs(e) > std::abs(heights.back())) {
        peaks.back() = x;
        heights.back() = e;
      }
    }
    const Wide highest = std::abs(*std::max_element(
        heights.begin(), heights.end(), [](Wide a, Wide b) { return std::abs(a) < std::abs(b); }));
    if (highest < smallest) {
      smallest = highest;
      best_c = c;
    }
    // Rounding can add a change of sign where the weight is 0: drop the lower of both ends.
    while (peaks.size() > count + 1) {
      const bool front = std::abs(heights.front()) < std::abs(heights.back());
      peaks.erase(front ? peaks.begin() : peaks.end() - 1);
      heights.erase(front ? heights.begin() : heights.end() - 1);
    }
    if (peaks.size() < count + 1) break;  // only rounding errors are left
    if (peaks == points) break;
    points = peaks;
  }

  const std::vector<Wide> powers = by_powers(problem, best_c);
  return {powers, shown_bound(worst_of(problem, powers))};
}

/// atan(t) / t in turns as a function of t^2; errors are those of the angle.
const Problem arc_tangent{0, 1,
                          [](Wide z) {
                            return z == 0 ? 1 / (2 * pi)
                                          : std::atan(std::sqrt(z)) / std::sqrt(z) / (2 * pi);
                          },
                          [](Wide z) { return std::sqrt(z); }};

/// acos(y) / sqrt(1 - y^2) in half turns; errors are those of the angle.
const Problem arc_cosine{0, 1,
                         [](Wide y) {
                           const Wide s = std::sqrt((1 - y) * (1 + y));
                           return s == 0 ? 1 / pi : std::atan2(s, y) / s / pi;
                         },
                         [](Wide y) { return std::sqrt((1 - y) * (1 + y)); }};

/// log2(1 - w) / w; errors are relative to the logarithm.
const Problem logarithm{0, Wide(0.5),
                        [](Wide w) { return w == 0 ? -1 / ln2 : std::log1p(-w) / w / ln2; },
                        [](Wide w) { return w == 0 ? ln2 : -w * ln2 / std::log1p(-w); }};

/// (2^y - 1) / y for the 16th root of a power; an error e of it is 16 2^(15 y) e of the power.
const Problem exponential{-1, 0, [](Wide y) { return y == 0 ? ln2 : std::expm1(y * ln2) / y; },
                          [](Wide y) { return -y * 16 * std::exp2(15 * y); }};

/// 255 times the sRGB curve above its straight part, by the root of the light; errors in levels.
const Problem srgb_curve{
    std::sqrt(Wide(0.0031308L)), 1,
    [](Wide r) { return 255 * (Wide(1.055L) * std::pow(r, Wide(5) / 6) - Wide(0.055L)); },
    [](Wide) { return Wide(1); }};

/// A number of coefficients, and the stated bound on what rounding does, in epsilons.
struct Size {
  std::size_t count = 0;
  std::string rounding;
};

/// One problem, fitted with several numbers of coefficients.
struct Family {
  std::string name, comment;
  Problem problem;
  std::vector<Size> sizes;
};

/// Sizes from a text: a number of coefficients and its bound, as often as there are.
std::vector<Size> sizes(const std::string& text) {
  std::vector<Size> all;
  std::istringstream in(text);
  for (Size size; in >> size.count >> size.rounding;) all.push_back(size);
  return all;
}

const std::vector<Family> families = {
    {"ArcTangent",
     "/// atan(t) / (2 pi t) by powers of t^2, for t from 0 to 1. `worst` is in turns of the "
     "angle.\n",
     arc_tangent,
     sizes("3 0.28 4 0.34 5 0.39 6 0.41 7 0.44 8 0.51 9 0.51 12 0.66 15 0.75 18 0.88")},
    {"ArcCosine",
     "/// acos(y) / (pi sqrt(1 - y^2)) by powers of y, for y from 0 to 1. `worst` is in half "
     "turns\n/// of the angle.\n",
     arc_cosine, sizes("4 2 5 2 6 2 7 2 9 2 10 2 11 2 15 2 18 2.2 21 2.4")},
    {"Logarithm", "/// log2(1 - w) / w by powers of w, for w from 0 to 1/2. `worst` is relative.\n",
     logarithm, sizes("3 1.5 4 1.4 6 1.8 8 1.8")},
    {"Exponential",
     "/// (2^y - 1) / y by powers of y, for y from -1 to 0. `worst` is that of "
     "(2^y)^16,\n/// where the result is at most 1.\n",
     exponential, sizes("2 8.5 3 8.8 4 8.8")},
    {"SrgbCurve",
     "/// 255 (1.055 r^(5/6) - 0.055) by powers of r, for r from the root of 0.0031308 to 1.\n"
     "/// `worst` is in levels of a byte.\n",
     srgb_curve, sizes("3 400 4 740")},
};

/// All fits, in the file's order.
std::vector<Fit> best_fits() {
  std::vector<Fit> fits;
  for (const Family& family : families) {
    for (const Size& size : family.sizes) fits.push_back(best(family.problem, size.count));
  }
  return fits;
}

/// The text of the file.
std::string text_of(const std::vector<Fit>& fits) {
  std::ostringstream out;
  out << "// Polynomials for the kernels. tools/fit_kernels.cpp writes this file: change that "
         "one.\n"
         "#pragma once\n#include <array>\n\n"
         "// clang-format off\n"
         "namespace texmap::fits {\n\n"
         "// `powers` holds the coefficients, the lowest power first. `worst` is the largest error "
         "with exact\n// arithmetic. `rounding` bounds what rounding adds to it, in epsilons, as "
         "tests/proofs proves for\n// float, double and 80-bit long double.\n";
  auto fit = fits.begin();
  for (const Family& family : families) {
    out << "\n" << family.comment << "template <int Terms>\nstruct " << family.name << ";\n";
    for (const auto& [count, rounding] : family.sizes) {
      out << "template <> struct " << family.name << "<" << count
          << "> {\n  static constexpr double worst = " << fit->worst << ", rounding = " << rounding
          << ";\n  static constexpr std::array<long double, " << count << "> powers = {\n";
      for (std::size_t i = 0; i < count; ++i) {
        out << (i % 3 == 0 ? "      " : " ")
            << shown(fit->powers[i], std::numeric_limits<Wide>::max_digits10) << "L"
            << (i + 1 == count ? "};\n};\n"
                : i % 3 == 2   ? ",\n"
                               : ",");
      }
      ++fit;
    }
  }
  out << "\n}  // namespace texmap::fits\n// clang-format on\n";
  return out.str();
}

/// The fits of a text as text_of makes it: the numbers with an exponent, in their order. What is
/// missing is 0.
std::vector<Fit> fits_in(const std::string& text) {
  static const std::regex number(R"(-?\d\.\d+e[-+]\d+)");
  std::sregex_iterator at(text.begin(), text.end(), number);
  const auto next = [&] { return at == std::sregex_iterator() ? "0" : (at++)->str(); };
  std::vector<Fit> fits;
  for (const Family& family : families) {
    for (const Size& size : family.sizes) {
      fits.push_back({{}, next()});
      while (fits.back().powers.size() < size.count)
        fits.back().powers.push_back(std::stold(next()));
    }
  }
  return fits;
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return text.str();
}

/// Throws unless the file is what this program writes, except for coefficients that are as good.
///
/// Processors round long double's functions differently. So each polynomial is checked by itself:
/// its error is at most the stated one, which is at most a tenth larger than the one found here.
void check(const std::string& path) {
  const std::string text = contents(path);
  const std::vector<Fit> given = fits_in(text), found = best_fits();
  if (text_of(given) != text) throw std::runtime_error(path + " is not what this program writes");
  std::size_t i = 0;
  for (const Family& family : families) {
    for (const Size& size : family.sizes) {
      const std::string which =
          path + ", " + family.name + "<" + std::to_string(size.count) + ">: ";
      const Wide worst = std::stold(given[i].worst);
      if (!(worst_of(family.problem, given[i].powers) <= worst))
        throw std::runtime_error(which + "the error is larger than stated");
      if (!(worst <= Wide(1.1L) * std::stold(found[i++].worst)))
        throw std::runtime_error(which + "there is a better polynomial");
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    static_assert(std::numeric_limits<Wide>::digits >= 64,
                  "the fit needs a long double of 64 bits or more");
    const std::vector<std::string> words(arguments + 1, arguments + count);
    if (words.size() == 2 && words[0] == "--check") {
      check(words[1]);
    } else if (words.size() == 1) {
      std::ofstream file(words[0], std::ios::binary);
      file << text_of(best_fits());
      file.close();
      if (!file) throw std::runtime_error(words[0] + ": cannot be written");
    } else {
      throw std::invalid_argument("Usage: fit_kernels FILE | fit_kernels --check FILE");
    }
  } catch (const std::exception& error) {
    std::cerr << "fit_kernels: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
