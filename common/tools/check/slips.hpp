// Tables of mistakes: what comes out, at one place, where a function is written as many write it.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <tuple>
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

/// The table with each value changed: for those who make a second mistake, too, or as a part of
/// another value.
template <class Out, class Change>
[[nodiscard]] auto changed(const Slips<Out>& table, const Change& change) {
  using To = std::invoke_result_t<Change, Out>;
  Slips<To> all;
  for (const Slip<Out>& slip : table) {
    std::vector<To> values;
    for (const Out value : slip.values) values.push_back(change(value));
    all.push_back({slip.word, std::move(values)});
  }
  return all;
}

/// A mistake that many make: its word, and the function as those write it.
template <class Function>
struct Mistake {
  std::string word;
  std::function<Function> function;
};

/// The functions whose values a table has at any place.
template <class Out, class... Args>
[[nodiscard]] std::vector<Mistake<Out(Args...)>> functions_of(
    const std::function<Slips<Out>(Args...)>& table, const std::tuple<std::decay_t<Args>...>& at) {
  std::vector<Mistake<Out(Args...)>> functions;
  std::size_t row = 0;
  for (const Slip<Out>& slip : std::apply(table, at)) {
    for (std::size_t i = 0; i < slip.values.size(); ++i) {
      functions.push_back({slip.word, [=](const std::decay_t<Args>&... arguments) -> Out {
                             return table(arguments...)[row].values[i];
                           }});
    }
    ++row;
  }
  return functions;
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

}  // namespace texmap::check
