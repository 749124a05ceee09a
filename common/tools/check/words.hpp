// Values in words and how far apart they are, for what an exercise's function takes and gives.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// A value as the verdict prints it: "0.25", "(0.25, 0.5)", "yes".
[[nodiscard]] std::string in_words(double value);
[[nodiscard]] std::string in_words(int value);
[[nodiscard]] std::string in_words(bool value);

/// The largest difference of a part of two values; infinity where one of them is not a number and
/// the other is.
[[nodiscard]] double apart(double a, double b);

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

/// Places, vectors and colors as the lists of their parts.
[[nodiscard]] inline std::array<double, 2> parts(const Uv<double>& uv) { return {uv.u, uv.v}; }
[[nodiscard]] inline std::array<double, 3> parts(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline std::array<double, 3> parts(const Rgb& c) { return {c.r, c.g, c.b}; }
[[nodiscard]] std::string in_words(const auto& value) { return in_words(parts(value)); }
template <class T>
[[nodiscard]] double apart(const T& a, const T& b) {
  if constexpr (std::is_arithmetic_v<T>) {
    return apart(double(a), double(b));
  } else {
    return apart(parts(a), parts(b));
  }
}

}  // namespace texmap::check
