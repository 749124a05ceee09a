// Values in words and how far apart they are, for what an exercise's function takes and gives.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// A value as the verdict prints it: "0.25", "(0.25, 0.5)", "yes".
[[nodiscard]] std::string in_words(double value);
[[nodiscard]] std::string in_words(int value);
[[nodiscard]] std::string in_words(bool value);
[[nodiscard]] std::string in_words(const Uv<double>& uv);
[[nodiscard]] std::string in_words(const Vec3<double>& v);
[[nodiscard]] std::string in_words(const Color<double>& c);

/// The largest difference of a part of two values; infinity where one of them is not a number and
/// the other is.
[[nodiscard]] double apart(double a, double b);
[[nodiscard]] inline double apart(int a, int b) { return apart(double(a), double(b)); }
[[nodiscard]] inline double apart(bool a, bool b) { return a == b ? 0 : 1; }
[[nodiscard]] double apart(const Uv<double>& a, const Uv<double>& b);
[[nodiscard]] double apart(const Vec3<double>& a, const Vec3<double>& b);
[[nodiscard]] double apart(const Color<double>& a, const Color<double>& b);

/// Lists, such as the weights of three corners.
template <class T, std::size_t N>
[[nodiscard]] std::string in_words(const std::array<T, N>& list) {
  std::string words;
  for (const T& part : list) words.append(words.empty() ? "(" : ", ").append(in_words(part));
  return words.append(")");
}
template <class T, std::size_t N>
[[nodiscard]] double apart(const std::array<T, N>& a, const std::array<T, N>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < N; ++i)
    largest = largest < apart(a[i], b[i]) ? apart(a[i], b[i]) : largest;
  return largest;
}

}  // namespace texmap::check
