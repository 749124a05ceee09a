// The number with which tests judge float and double.
#pragma once

namespace texmap::test {

using Exact = long double;

/// A number with room for the digits of the reference.
template <class Number>
[[nodiscard]] Exact widened(Number x) {
  return static_cast<Exact>(x);
}

}  // namespace texmap::test
