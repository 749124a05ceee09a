// The measured figures of the pages, a function for each chapter's. docs/figures.txt holds them.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engine/measure/text.hpp"

namespace texmap::test {

/// Names and values of figures, in the order in which they are measured. A name begins with its
/// chapter: "03.texels_a_pixel".
using Figures = std::vector<std::pair<std::string, std::string>>;

/// A whole number as pages show it: 480,000.
[[nodiscard]] inline std::string whole(long long n) {
  std::string digits = std::to_string(n);
  for (std::size_t place = digits.size(); place > 3 + (n < 0 ? 1U : 0U);) {
    place -= 3;
    digits.insert(place, 1, ',');
  }
  return digits;
}

/// A number with so many decimals; a number with so many digits, as in 8.2e-16.
[[nodiscard]] inline std::string decimals(double x, int count) { return text("%.*f", count, x); }
[[nodiscard]] inline std::string digits(double x, int count) { return text("%.*g", count, x); }

void figures_of_00(Figures& figures);
void figures_of_01(Figures& figures);
void figures_of_02(Figures& figures);
void figures_of_03(Figures& figures);
void figures_of_04(Figures& figures);
void figures_of_05(Figures& figures);
void figures_of_06(Figures& figures);
void figures_of_07(Figures& figures);
void figures_of_08(Figures& figures);
void figures_of_09(Figures& figures);
void figures_of_10(Figures& figures);
void figures_of_11(Figures& figures);
void figures_of_12(Figures& figures);
void figures_of_13(Figures& figures);
void figures_of_14(Figures& figures);

}  // namespace texmap::test
