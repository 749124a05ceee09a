// Tables of mistakes: what comes out, at one place, where a function is written as many write it.
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace texmap::check {

/// The word of a mistake, and the value or the values of those who make it.
template <class Out>
struct Slip {
  const char* word;  ///< "u runs the other way: your map is mirrored"
  std::vector<Out> values;

  Slip(const char* its_word, const Out& value) : word(its_word), values{value} {}
  Slip(const char* its_word, std::vector<Out> all) : word(its_word), values(std::move(all)) {}
};

/// The mistakes with a function, at one place; the same rows at each place. To add one, add a row
/// {word, value} or {word, {value, value}} to the exercise's table.
template <class Out>
using Slips = std::vector<Slip<Out>>;

template <class Out>
Slips<Out>& operator+=(Slips<Out>& table, const std::type_identity_t<Slips<Out>>& more) {
  table.insert(table.end(), more.begin(), more.end());
  return table;
}

/// The values of tables with the same rows, combined value by value.
template <class Combine, class Out, class... Outs>
[[nodiscard]] auto combined(const Combine& combine, const Slips<Out>& table,
                            const Slips<Outs>&... others) {
  using To = std::invoke_result_t<Combine, Out, Outs...>;
  Slips<To> all;
  for (std::size_t row = 0; row < table.size(); ++row) {
    std::vector<To> values;
    for (std::size_t i = 0; i < table[row].values.size(); ++i)
      values.push_back(combine(table[row].values[i], others[row].values[i]...));
    all.push_back({table[row].word, std::move(values)});
  }
  return all;
}

/// The table with each value changed: for those who make a second mistake, too, or as a part of
/// another value.
template <class Out, class Change>
[[nodiscard]] auto changed(const Slips<Out>& table, const Change& change) {
  return combined(change, table);
}

}  // namespace texmap::check
