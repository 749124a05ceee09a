// Inputs as text that can be pasted into a test: every digit of them.
#pragma once
#include <limits>
#include <sstream>
#include <string>

#include "ray.hpp"
#include "triangle.hpp"

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

[[nodiscard]] inline std::string described(const Triangle& triangle) {
  return described(triangle.a) + " " + described(triangle.b) + " " + described(triangle.c);
}

}  // namespace texmap::extremes
