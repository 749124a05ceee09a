// Values in words.
#include "words.hpp"

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
std::string in_words(const Uv<double>& uv) { return in_words(std::array{uv.u, uv.v}); }
std::string in_words(const Vec3<double>& v) { return in_words(std::array{v.x, v.y, v.z}); }
std::string in_words(const Color<double>& c) { return in_words(std::array{c.r, c.g, c.b}); }

double apart(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}
double apart(const Uv<double>& a, const Uv<double>& b) {
  return apart(std::array{a.u, a.v}, std::array{b.u, b.v});
}
double apart(const Vec3<double>& a, const Vec3<double>& b) {
  return apart(std::array{a.x, a.y, a.z}, std::array{b.x, b.y, b.z});
}
double apart(const Color<double>& a, const Color<double>& b) {
  return apart(std::array{a.r, a.g, a.b}, std::array{b.r, b.g, b.b});
}

}  // namespace texmap::check
