// JSON, written value by value. Source: RFC 8259.
#pragma once
#include <concepts>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace texmap {

/// A value as JSON text. Numbers that are not finite are null, which is all that JSON has for them.
struct Json {
  std::string text;

  // NOLINTBEGIN(google-explicit-constructor): members of an object are written as plain values
  Json(std::nullptr_t) : text("null") {}
  template <std::integral Whole>
  Json(Whole value) : text(std::to_string(value)) {
    if constexpr (std::same_as<Whole, bool>) text = value ? "true" : "false";
  }
  Json(double value);
  Json(const std::string& value);
  Json(const char* value) : Json(std::string(value)) {}
  // NOLINTEND(google-explicit-constructor)

  /// Members, or items, in their order.
  /// @param lines  one on each line; or all on one
  [[nodiscard]] static Json object(const std::vector<std::pair<const char*, Json>>& members,
                                   bool lines = false);
  [[nodiscard]] static Json list(const std::vector<Json>& items, bool lines = false);
  /// The list of what `item` makes of each element, one on each line.
  template <class Range, class Item>
  [[nodiscard]] static Json list_of(const Range& elements, const Item& item) {
    std::vector<Json> items;
    items.reserve(std::size(elements));
    for (const auto& element : elements) items.push_back(item(element));
    return list(items, true);
  }
};

}  // namespace texmap
