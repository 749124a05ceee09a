// Inputs as text that can be pasted into a test: every digit of them.
#pragma once
#include <array>
#include <limits>
#include <sstream>
#include <string>

#include "scene/ray.hpp"
#include "scene/triangle.hpp"

namespace texmap::extremes {

template <class T>
[[nodiscard]] std::string described(const T& x) {
  std::ostringstream text;
  text.precision(std::numeric_limits<T>::max_digits10);
  text << x;
  return text.str();
}
template <class T>
[[nodiscard]] std::string described(const Vec3<T>& p) {
  return "{" + described(p.x) + ", " + described(p.y) + ", " + described(p.z) + "}";
}
template <class T>
[[nodiscard]] std::string described(const Ray<T>& ray) {
  return "{" + described(ray.origin) + ", " + described(ray.direction) + "}";
}
template <class One, std::size_t count>
[[nodiscard]] std::string described(const std::array<One, count>& all) {
  std::string text;
  for (const One& one : all) text += (text.empty() ? "" : " ") + described(one);
  return text;
}
[[nodiscard]] inline std::string described(const Triangle& triangle) {
  return described(triangle.a) + " " + described(triangle.b) + " " + described(triangle.c);
}

}  // namespace texmap::extremes
