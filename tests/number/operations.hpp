// What the course does with numbers, as lists of operations: the laws of each kind walk them.
#pragma once
#include "number/number.hpp"

namespace texmap::test {

/// Calls each(name, operation) for what all kinds of numbers round as plain numbers do.
template <class Each>
void for_each_arithmetic(const Each& each) {
  each("a + b", [](auto a, auto b) { return a + b; });
  each("a - b", [](auto a, auto b) { return a - b; });
  each("a * b", [](auto a, auto b) { return a * b; });
  each("a / b", [](auto a, auto b) { return a / b; });
  each("-a", [](auto a, auto) { return -a; });
  each("abs", [](auto a, auto) { return abs(a); });
  each("floor", [](auto a, auto) { return floor(a); });
  each("square", [](auto a, auto) { return square(a); });
  each("sqrt", [](auto a, auto) { return sqrt(a); });
  each("max", [](auto a, auto b) { return max(a, b); });
  each("min", [](auto a, auto b) { return min(a, b); });
  each("clamp", [](auto a, auto b) { return clamp(a, decltype(a)(-1), abs(b)); });
}

/// For every comparison and what is made of their masks.
template <class Each>
void for_each_choice(const Each& each) {
  each("a < b", [](auto a, auto b) { return select(a < b, a, b); });
  each("a <= b", [](auto a, auto b) { return select(a <= b, a, -b); });
  each("a > b", [](auto a, auto b) { return select(a > b, a, b); });
  each("a >= b", [](auto a, auto b) { return select(a >= b, a, -b); });
  each("a == b", [](auto a, auto b) { return select(a == b, a, -b); });
  each("and", [](auto a, auto b) { return select(a < b && b < -a, a, b); });
  each("or", [](auto a, auto b) { return select(a < b || b < -a, a, b); });
  each("not", [](auto a, auto b) { return select(!(a < b) && a > decltype(a)(0), a, b); });
}

/// For the functions that each kind computes in its own way.
template <class Each>
void for_each_function(const Each& each) {
  each("exp", [](auto a, auto) { return exp(a); });
  each("log1p", [](auto a, auto) { return log1p(a); });
  each("atan2", [](auto a, auto b) { return atan2(a, b); });
}

}  // namespace texmap::test
