// Judges a function by its values: at named places, against the right ones and against known
// mistakes.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/measure/text.hpp"
#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// The numbers that a list, a place, a vector or a color consists of.
template <std::size_t N>
[[nodiscard]] std::array<double, N> parts(const std::array<double, N>& list) {
  return list;
}
[[nodiscard]] inline std::array<double, 2> parts(const Uv<double>& uv) { return {uv.u, uv.v}; }
[[nodiscard]] inline std::array<double, 3> parts(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline std::array<double, 3> parts(const Rgb& c) { return {c.r, c.g, c.b}; }

/// A value as the verdict prints it, with so many digits: "0.25", "(0.25, 0.5)", "yes".
[[nodiscard]] inline std::string in_words(double value, int digits = 6) {
  if (std::isnan(value)) return "no number (NaN)";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  if (std::abs(value) < 1e-15) return "0";  // -0, or what rounding leaves of 0
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  return whole ? text("%.0f", value) : text("%.*g", digits, value);
}
[[nodiscard]] inline std::string in_words(int value, int /*digits*/) {
  return std::to_string(value);
}
[[nodiscard]] inline std::string in_words(bool value, int /*digits*/) {
  return value ? "yes" : "no";
}
[[nodiscard]] std::string in_words(const auto& value, int digits) {
  std::string words;
  for (const double part : parts(value))
    words += (words.empty() ? "(" : ", ") + in_words(part, digits);
  return words + ")";
}

/// The largest difference of a part of two values; infinity where one of them is not a number and
/// the other is.
[[nodiscard]] inline double apart(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? infinity<double>() : difference;
}
template <class T>
[[nodiscard]] double apart(const T& a, const T& b) {
  if constexpr (std::is_arithmetic_v<T>) {
    return apart(double(a), double(b));
  } else {
    double largest = 0;
    for (std::size_t i = 0; i < parts(a).size(); ++i)
      largest = std::max(largest, apart(parts(a)[i], parts(b)[i]));
    return largest;
  }
}

/// True for values that differ by rounding alone, as by a calculation in float.
template <class T>
[[nodiscard]] bool alike(const T& a, const T& b) {
  double size = 1;
  if constexpr (std::is_arithmetic_v<T>) {
    size = std::max(size, std::abs(double(a)));
  } else {
    for (const double part : parts(a)) size = std::max(size, std::abs(part));
  }
  return apart(a, b) <= 1e-6 * (size < infinity<double>() ? size : 1);
}

/// A mistake, what comes out of it at one place, and what comes out of its other spellings.
template <class Out>
struct Slip {
  const char* word;  ///< "u runs the other way: your map is mirrored"
  std::vector<Out> values;
};

/// The mistakes with a function, at one place; the same rows at each place. To add one, add a row
/// {word, value} or {word, {value, value}} to the exercise's table, or a whole table.
template <class Out>
struct Slips {
  std::vector<Slip<Out>> rows;

  Slips() = default;
  Slips(const char* word, const Out& value) : rows{{word, {value}}} {}
  Slips(const char* word, std::vector<Out> values) : rows{{word, std::move(values)}} {}
  Slips(std::initializer_list<Slips> tables) {
    for (const Slips& table : tables) *this += table;
  }
  Slips& operator+=(const Slips& more) {
    rows.insert(rows.end(), more.rows.begin(), more.rows.end());
    return *this;
  }
};

/// The values of tables with the same rows, combined value by value.
template <class Combine, class Out, class... Outs>
[[nodiscard]] auto combined(const Combine& combine, const Slips<Out>& table,
                            const Slips<Outs>&... others) {
  Slips<std::invoke_result_t<Combine, Out, Outs...>> all;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& [word, values] = all.rows.emplace_back();
    word = table.rows[row].word;
    for (std::size_t i = 0; i < table.rows[row].values.size(); ++i)
      values.push_back(combine(table.rows[row].values[i], others.rows[row].values[i]...));
  }
  return all;
}

/// The table with each value changed: for those who make a second mistake, too, or as a part of
/// another value.
template <class Out, class Change>
[[nodiscard]] auto changed(const Slips<Out>& table, const Change& change) {
  return combined(change, table);
}

/// A place where a function is tried: what should be there, in words, and the arguments.
template <class... Args>
struct Place {
  const char* law;  ///< "on +z, (0, 0, 1), u is 1/4"
  std::tuple<Args...> at;
};

/// What is known of a function: the right one, what often comes out at a place, and where to try
/// it, in the order of teaching.
template <class Out, class... Args>
struct Law {
  std::function<Out(Args...)> right;
  std::function<Slips<Out>(Args...)> slips;
  std::span<const Place<std::decay_t<Args>...>> places;
  std::function<Out(const Out&)> seen{};  ///< what of a value counts; empty: all of it
};

/// A verdict in words.
struct Verdict {
  bool right = true;
  std::string law;       ///< the first law that does not hold, empty if all do
  std::string expected;  ///< the right value there
  std::string got;
  std::string mistake;    ///< the word of the known mistake, empty if it is none of them
  std::size_t wrong = 0;  ///< at how many places
  std::size_t places = 0;
  std::string values;  ///< those of the function at all places, as bytes
};

/// The law's table, each mistake with its values at all places.
template <class Out, class... Args>
[[nodiscard]] Slips<Out> slips_at_all_places(const Law<Out, Args...>& law) {
  Slips<Out> all;
  for (const auto& place : law.places) {
    std::size_t row = 0;
    for (const Slip<Out>& slip : std::apply(law.slips, place.at).rows) {
      for (const Out value : slip.values) {
        if (row == all.rows.size()) all.rows.push_back({slip.word, {}});
        all.rows[row++].values.push_back(value);
      }
    }
  }
  return all;
}

/// Judges a function's values at all places.
///
/// A known mistake is named if it is wrong somewhere and gives the same at every place: of several,
/// the first.
template <class Out, class... Args>
[[nodiscard]] Verdict judge(const Law<Out, Args...>& law, const std::vector<Out>& values) {
  Verdict verdict;
  verdict.places = values.size();
  const auto same = [&law](const Out& a, const Out& b) {
    return law.seen ? alike(law.seen(a), law.seen(b)) : alike(a, b);
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Out value = values[i];
    verdict.values.append(reinterpret_cast<const char*>(&value), sizeof value);
    const Out right = std::apply(law.right, law.places[i].at);
    if (same(right, value)) continue;
    if (verdict.right) {
      verdict.right = false;
      verdict.law = law.places[i].law;
      for (const int digits : {6, 9, 17}) {  // more where they would look equal
        verdict.expected = in_words(right, digits);
        verdict.got = in_words(value, digits);
        if (verdict.expected != verdict.got) break;
      }
    }
    ++verdict.wrong;
  }
  if (verdict.right) return verdict;
  for (const Slip<Out>& slip : slips_at_all_places(law).rows) {
    if (!std::equal(values.begin(), values.end(), slip.values.begin(), same)) continue;
    verdict.mistake = slip.word;
    break;
  }
  return verdict;
}

}  // namespace texmap::check
