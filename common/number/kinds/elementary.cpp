// The elementary functions of plain numbers that number.hpp declares, and refuse.hpp.
#include "number/kinds/elementary.hpp"

#include <cstdlib>
#include <stdexcept>

#include "number/refuse.hpp"

namespace texmap {
void refuse_argument([[maybe_unused]] const std::string& why) {
#if defined(__cpp_exceptions)
  throw std::invalid_argument(why);
#endif
  std::abort();
}

namespace {

/// function(x...), for floats in double.
template <class Function, std::floating_point T, class... More>
T rounded_once(const Function& function, T x, More... more) {
  if constexpr (std::is_same_v<T, float>) {
    return static_cast<float>(function(static_cast<double>(x), static_cast<double>(more)...));
  } else {
    return function(x, more...);
  }
}

}  // namespace

template <std::floating_point T>
T atan2(T y, std::type_identity_t<T> x) {
  return rounded_once([](auto a, auto b) { return elementary::atan2(a, b); }, y, x);
}
template <std::floating_point T>
T acos(T x) {
  return rounded_once([](auto c) { return elementary::atan2(sqrt((1 - c) * (1 + c)), c); }, x);
}
template <std::floating_point T>
T asin(T x) {
  return rounded_once([](auto s) { return elementary::atan2(s, sqrt((1 - s) * (1 + s))); }, x);
}
template <std::floating_point T>
T cos(T x) {
  return rounded_once([](auto a) { return elementary::CosineAndSine(a).cosine; }, x);
}
template <std::floating_point T>
T sin(T x) {
  return rounded_once([](auto a) { return elementary::CosineAndSine(a).sine; }, x);
}
template <std::floating_point T>
T tan(T x) {
  return rounded_once(
      [](auto a) {
        const elementary::CosineAndSine of(a);
        return of.sine / of.cosine;
      },
      x);
}
template <std::floating_point T>
T exp(T x) {
  return rounded_once([](auto a) { return elementary::exp(a); }, x);
}
template <std::floating_point T>
T log1p(T x) {
  return rounded_once([](auto a) { return elementary::log1p(a); }, x);
}
template <std::floating_point T>
T pow(T x, std::type_identity_t<T> exponent) {
  return rounded_once([](auto a, auto b) { return elementary::pow(a, b); }, x, exponent);
}

#define TEXMAP_FOR(T)        \
  template T atan2<T>(T, T); \
  template T acos<T>(T);     \
  template T asin<T>(T);     \
  template T cos<T>(T);      \
  template T sin<T>(T);      \
  template T tan<T>(T);      \
  template T exp<T>(T);      \
  template T log1p<T>(T);    \
  template T pow<T>(T, T);
TEXMAP_FOR(float)
TEXMAP_FOR(double)
TEXMAP_FOR(long double)

}  // namespace texmap
