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

#include "engine/files/text.hpp"
#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// The numbers that a list, a place, a vector or a color consists of.
template <std::size_t N>
[[nodiscard]] std::array<double, N> parts(const std::array<double, N>& list) {
  return list;
}
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] std::array<double, 1> parts(Number number) { return {double(number)}; }
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
[[nodiscard]] inline std::string in_words(float value, int digits) {
  return in_words(double(value), digits);
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
  std::string word;  ///< "u runs the other way: your map is mirrored"
  std::vector<Out> values;
};

/// The mistakes with a function, at one place; the same rows at each place. To add one, add a row
/// {word, value} or {word, {value, value}} to the exercise's table, or a whole table. Rows with one
/// rule are a table {rule, {row, row}}: each gets the word "what is wrong: rule".
template <class Out>
struct Slips {
  std::vector<Slip<Out>> rows;

  Slips() = default;
  Slips(std::string word, const Out& value) : rows{{std::move(word), {value}}} {}
  Slips(std::string word, std::vector<Out> values) : rows{{std::move(word), std::move(values)}} {}
  Slips(std::initializer_list<Slips> tables) {
    for (const Slips& table : tables) *this += table;
  }
  Slips(const std::string& rule, std::initializer_list<Slips> tables) : Slips(tables) {
    for (Slip<Out>& row : rows) row.word += (row.word.empty() ? "" : ": ") + rule;
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
  std::function<Out(const Out&, Args...)> seen{};  ///< what of a value counts; empty: all of it
  std::function<int(Args...)> count{};         ///< how many there are, where the value numbers one
  std::function<std::string(Args...)> edge{};  ///< the word of values that are wrong there alone
};

/// A verdict in words.
struct Verdict {
  bool right = true;
  std::string law;       ///< the first law that does not hold, empty if all do
  std::string expected;  ///< the right value there
  std::string got;
  std::string mistake;    ///< the word of the known mistake, empty if it is none of them
  bool in_parts = false;  ///< whether its words are of single numbers of the values, such as u
  std::string fact;       ///< if it is none: what is to be seen in the values, or empty
  std::size_t wrong = 0;  ///< at how many places
  std::size_t places = 0;
  std::string values;  ///< those of the function at all places, as bytes
};

/// Adds a place's table to that of all places, in which each value of a mistake has its own row.
template <class Out>
void add_place(Slips<Out>& all, const Slips<Out>& table) {
  std::size_t row = 0;
  for (const Slip<Out>& slip : table.rows) {
    for (const Out value : slip.values) {
      if (row == all.rows.size()) all.rows.push_back({slip.word, {}});
      all.rows[row++].values.push_back(value);
    }
  }
}

/// The law's table, each mistake with its values at all places.
template <class Out, class... Args>
[[nodiscard]] Slips<Out> slips_at_all_places(const Law<Out, Args...>& law) {
  Slips<Out> all;
  for (const auto& place : law.places) add_place(all, std::apply(law.slips, place.at));
  return all;
}

/// Whether one of the numbers that values consist of is the same at every place.
template <class Out>
[[nodiscard]] bool agree(const std::vector<Out>& a, const std::vector<Out>& b, std::size_t part) {
  return std::equal(a.begin(), a.end(), b.begin(), [=](const Out& x, const Out& y) {
    return alike(parts(x)[part], parts(y)[part]);
  });
}

/// What a student calls it.
template <class Out>
[[nodiscard]] const char* name_of_part(std::size_t part) {
  if constexpr (std::is_same_v<Out, Uv<double>>) return std::array{"u", "v"}[part];
  if constexpr (std::is_same_v<Out, Vec3<double>>) return std::array{"x", "y", "z"}[part];
  if constexpr (std::is_same_v<Out, Rgb>) return std::array{"red", "green", "blue"}[part];
  if constexpr (requires { Out::names; }) return Out::names[part];
  return std::array{"[0]", "[1]", "[2]"}[part];
}

/// What happens to any value of several numbers: two of them are exchanged, one is a copy of
/// another, has the wrong sign or is missing.
template <class Out>
[[nodiscard]] Slips<Out> slips_of_parts(const Out& right) {
  const auto all = parts(right);
  const auto with = [&](std::size_t i, double of_i, std::size_t k, double of_k) {
    auto numbers = all;
    numbers[i] = of_i;
    numbers[k] = of_k;
    return std::apply([](auto... number) { return Out{number...}; }, numbers);
  };
  Slips<Out> slips;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = name_of_part<Out>(i);
    slips += {{"the sign of " + name + " is wrong", with(i, -all[i], i, -all[i])},
              {name + " is missing, 0 everywhere", with(i, 0, i, 0)}};
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k == i) continue;
      const std::string other = name_of_part<Out>(k);
      if (i < k) {
        slips += {text("%s and %s are exchanged", name.c_str(), other.c_str()),
                  with(i, all[k], k, all[i])};
      }
      slips +=
          {text("%s is a copy of %s", name.c_str(), other.c_str()), with(i, all[k], k, all[k])};
    }
  }
  return slips;
}

/// A mistake in one number of several, such as u, while the others are right or have mistakes of
/// their own: the words of those rows that are wrong in this number alone.
template <class Out>
[[nodiscard]] std::string mistakes_in_parts(const std::vector<Out>& right,
                                            const std::vector<Out>& values,
                                            const Slips<Out>& known) {
  std::string words;
  const std::size_t count = parts(right[0]).size();
  for (std::size_t part = 0; part < count; ++part) {
    for (const Slip<Out>& slip : known.rows) {
      bool explains = agree(values, slip.values, part) && !agree(right, slip.values, part);
      for (std::size_t other = 0; other < count; ++other)
        explains = explains && (other == part || agree(right, slip.values, other));
      if (!explains) continue;
      if (words.find(slip.word) == std::string::npos)
        words += (words.empty() ? "" : "; and ") + std::string(slip.word);
      break;
    }
  }
  return words;
}

/// "2 times the right value at every place", if it is, or empty.
template <class Out>
[[nodiscard]] std::string factor_of(const std::vector<Out>& right, const std::vector<Out>& values) {
  double factor = 0;
  bool is_known = false;
  for (std::size_t i = 0; i < right.size(); ++i) {
    for (std::size_t part = 0; part < parts(right[i]).size(); ++part) {
      const double of_right = parts(right[i])[part], yours = parts(values[i])[part];
      if (!is_known && !alike(of_right, 0.0)) {
        factor = yours / of_right;
        is_known = true;
      }
      if (!alike(factor * of_right, yours)) return "";
    }
  }
  if (factor == 0 || !std::isfinite(factor)) return "";
  return in_words(factor, 4) + " times the right value at every place";
}

/// What is to be seen in wrong values, whatever the mistake is.
template <class Out>
[[nodiscard]] std::string fact_of(const std::vector<Out>& right, const std::vector<Out>& values) {
  std::string good, bad;
  bool is_nan = false;
  for (std::size_t part = 0; part < parts(right[0]).size(); ++part) {
    (agree(right, values, part) ? good : bad) += std::string(" ") + name_of_part<Out>(part);
    for (const Out& value : values) is_nan = is_nan || std::isnan(parts(value)[part]);
  }
  if (is_nan) return "there is no number in it (NaN): the root of one below 0, 0 / 0, acos of 2";
  if (std::all_of(values.begin(), values.end(), [&](const Out& v) { return alike(v, values[0]); }))
    return "it is the same at every place, whatever your function gets";
  return good.empty() ? "" : "right at every place:" + good + "; wrong:" + bad;
}

/// Judges a function's values at all places.
///
/// A known mistake is named if it is wrong somewhere and gives the same at every place: of several,
/// the first.
template <class Out, class... Args>
[[nodiscard]] Verdict judge(const Law<Out, Args...>& law, const std::vector<Out>& values) {
  Verdict verdict;
  verdict.places = values.size();
  const auto seen = [&law](const Out& value, std::size_t place) {
    const auto at = [&](const auto&... in) { return law.seen(value, in...); };
    return law.seen ? std::apply(at, law.places[place].at) : value;
  };
  std::vector<Out> all_right, yours;
  std::string edge;
  Slips<Out> of_parts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Out value = values[i];
    verdict.values.append(reinterpret_cast<const char*>(&value), sizeof value);
    const Out right = std::apply(law.right, law.places[i].at);
    if constexpr (!std::is_arithmetic_v<Out>) add_place(of_parts, slips_of_parts(right));
    all_right.push_back(seen(right, i));
    yours.push_back(seen(value, i));
    if (alike<Out>(all_right.back(), yours.back())) continue;
    const std::string word = law.edge ? std::apply(law.edge, law.places[i].at) : "";
    edge = verdict.right || edge == word ? word : "";
    if (verdict.right) {
      verdict.right = false;
      verdict.law = law.places[i].law;
      for (const int digits : {6, 9, 17}) {  // more where they would look equal
        verdict.expected = in_words(right, digits);
        verdict.got = in_words(value, digits);
        if (verdict.expected != verdict.got) break;
      }
      if constexpr (std::is_same_v<Out, int>) {
        const int count = law.count ? std::apply(law.count, law.places[i].at) : 0;
        if (count > 0 && (value < 0 || value >= count))
          verdict.got += text(", outside: there are 0 to %d", count - 1);
      }
    }
    ++verdict.wrong;
  }
  if (verdict.right) return verdict;
  Slips<Out> known = slips_at_all_places(law);
  known += of_parts;
  for (Slip<Out>& slip : known.rows)
    for (std::size_t i = 0; i < values.size(); ++i) slip.values[i] = seen(slip.values[i], i);
  for (const Slip<Out>& slip : known.rows) {
    if (!std::equal(yours.begin(), yours.end(), slip.values.begin(), alike<Out>)) continue;
    verdict.mistake = slip.word;
    break;
  }
  if (verdict.mistake.empty()) verdict.mistake = edge;
  if constexpr (!std::is_same_v<Out, bool>) {
    verdict.fact = factor_of(all_right, yours);
    if (!verdict.mistake.empty()) return verdict;
    verdict.mistake = mistakes_in_parts(all_right, yours, known);
    verdict.in_parts = !verdict.mistake.empty();
    if (!verdict.in_parts && verdict.fact.empty()) verdict.fact = fact_of(all_right, yours);
  }
  return verdict;
}

}  // namespace texmap::check
