// How doctest shows the course's types in a failure, where it would write {?}.
#pragma once
#include <doctest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "support/lane_of.hpp"
#include "texture/image.hpp"

namespace texmap::test {

/// Numbers as doctest shows them, in parentheses.
template <class... Numbers>
[[nodiscard]] doctest::String in_parentheses(const Numbers&... numbers) {
  doctest::String shown = "(";
  const char* separator = "";
  ((shown += separator, shown += doctest::toString(numbers), separator = ", "), ...);
  shown += ")";
  return shown;
}

}  // namespace texmap::test

namespace doctest {

template <texmap::test::HasParts Thing>
struct StringMaker<Thing> {
  static String convert(const Thing& thing) {
    return std::apply([](const auto&... part) { return texmap::test::in_parentheses(part...); },
                      texmap::test::parts_of(thing));
  }
};
template <>
struct StringMaker<texmap::Rgb8> {
  static String convert(const texmap::Rgb8& c) {
    return texmap::test::in_parentheses(int{c.r}, int{c.g}, int{c.b});
  }
};
template <>
struct StringMaker<texmap::Image> {
  static String convert(const texmap::Image& image) {
    return "a picture of " + toString(image.width) + " x " + toString(image.height) + " pixels";
  }
};
template <class First, class Second>
struct StringMaker<std::pair<First, Second>> {
  static String convert(const std::pair<First, Second>& pair) {
    return texmap::test::in_parentheses(pair.first, pair.second);
  }
};
/// The first ten, and how many more there are.
template <class Value>
struct StringMaker<std::vector<Value>> {
  static String convert(const std::vector<Value>& values) {
    String shown = "[";
    for (std::size_t i = 0; i < values.size() && i < 10; ++i) {
      if (i > 0) shown += ", ";
      shown += toString(static_cast<const Value&>(values[i]));
    }
    if (values.size() > 10)
      shown += ", and " + toString(static_cast<unsigned long>(values.size() - 10)) + " more";
    return shown + "]";
  }
};

}  // namespace doctest
