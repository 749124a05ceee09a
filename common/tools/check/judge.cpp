// Values in words, and how far apart two of them are.
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace texmap::check {

std::string in_words(double value) {
  if (std::isnan(value)) return "no number (NaN)";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  if (std::abs(value) < 1e-15) return "0";  // -0, or what rounding leaves of 0
  std::array<char, 32> text{};
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  std::snprintf(text.data(), text.size(), whole ? "%.0f" : "%.6g", value + 0.0);  // never "-0"
  return text.data();
}
std::string in_words(int value) { return std::to_string(value); }
std::string in_words(bool value) { return value ? "yes" : "no"; }

double apart(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace texmap::check
