// Judges a function by its values: at named places, against the right ones and against known
// mistakes.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// The numbers that a number, a place, a vector or a color consists of.
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] std::array<double, 1> parts(Number number) { return {double(number)}; }
[[nodiscard]] inline std::array<double, 2> parts(const Uv<double>& uv) { return {uv.u, uv.v}; }
[[nodiscard]] inline std::array<double, 3> parts(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline std::array<double, 3> parts(const Rgb& c) { return {c.r, c.g, c.b}; }

/// What a function returned, as a list of numbers. judge() reads these lists, whatever the type is,
/// and is compiled once.
struct Value {
  std::array<double, 3> numbers{};
  std::size_t count = 1;

  [[nodiscard]] std::span<const double> parts() const { return {numbers.data(), count}; }
};
template <class Out>
[[nodiscard]] Value value_of(const Out& out) {
  Value value{.count = 0};
  for (const double number : parts(out)) value.numbers[value.count++] = number;
  return value;
}
/// The value as what the function returned.
template <class Out>
[[nodiscard]] Out typed(const Value& value) {
  if constexpr (std::is_arithmetic_v<Out>) {
    return static_cast<Out>(value.numbers[0]);
  } else {
    return [&]<std::size_t... i>(std::index_sequence<i...>) { return Out{value.numbers[i]...}; }
    (std::make_index_sequence<std::tuple_size_v<decltype(parts(Out{}))>>());
  }
}

/// What the values of a function are, and what a student calls their numbers.
struct Kind {
  enum Form { number, whole, yes_or_no, list } form = number;
  std::array<const char*, 3> names{"[0]", "[1]", "[2]"};
};
template <class Out>
[[nodiscard]] Kind kind_of() {
  if constexpr (std::is_same_v<Out, bool>) return {.form = Kind::yes_or_no};
  if constexpr (std::is_integral_v<Out>) return {.form = Kind::whole};
  if constexpr (std::is_arithmetic_v<Out>) return {.form = Kind::number};
  if constexpr (std::is_same_v<Out, Uv<double>>) return {Kind::list, {"u", "v"}};
  if constexpr (std::is_same_v<Out, Vec3<double>>) return {Kind::list, {"x", "y", "z"}};
  if constexpr (std::is_same_v<Out, Rgb>) return {Kind::list, {"red", "green", "blue"}};
  if constexpr (requires { Out::names; }) return {Kind::list, {Out::names[0], Out::names[1]}};
}

/// A number as the verdict prints it, with so many digits.
[[nodiscard]] std::string in_words(double value, int digits = 6);

/// The difference of two numbers; infinity where one of them is not a number and the other is.
[[nodiscard]] double apart(double a, double b);

/// True for values that differ by rounding alone, as by a calculation in float.
[[nodiscard]] bool alike(const Value& a, const Value& b);
[[nodiscard]] bool alike(double a, double b);

/// A mistake, what comes out of it at one place, and what comes out of its other spellings.
struct Slip {
  std::string word;  ///< "u runs the other way: your map is mirrored"
  std::vector<Value> values;
};

/// Mistakes, whatever the type of their values: compiled once for the many tables of the judges.
struct SlipTable {
  std::vector<Slip> rows;

  SlipTable();
  SlipTable(std::string_view word, std::initializer_list<Value> values);
  SlipTable(const SlipTable&);
  SlipTable& operator=(const SlipTable&);
  ~SlipTable();
  void add(const SlipTable& more);
  void add_rule(std::string_view rule);
};

/// The mistakes with a function, at one place; the same rows at each place. To add one, add a row
/// {word, value} or {word, {value, value}} to the exercise's table, or a whole table. Rows with one
/// rule are a table {rule, {row, row}}: each gets the word "what is wrong: rule".
template <class Out>
struct Slips : SlipTable {
  Slips() = default;
  Slips(std::string_view word, const Out& value) : SlipTable(word, {value_of(value)}) {}
  Slips(std::string_view word, const std::vector<Out>& values) : SlipTable(word, {}) {
    for (const Out value : values) rows[0].values.push_back(value_of(value));
  }
  Slips(std::initializer_list<Slips> tables) {
    for (const Slips& table : tables) add(table);
  }
  Slips(std::string_view rule, std::initializer_list<Slips> tables) : Slips(tables) {
    add_rule(rule);
  }
  Slips& operator+=(const Slips& more) {
    add(more);
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
    for (std::size_t i = 0; i < table.rows[row].values.size(); ++i) {
      values.push_back(value_of(combine(typed<Out>(table.rows[row].values[i]),
                                        typed<Outs>(others.rows[row].values[i])...)));
    }
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

/// The law at its places, without the types of the arguments: what judge() reads.
struct Trial {
  struct At {
    const char* law;
    Value right;
    int count;         ///< how many there are, where the value numbers one; or 0
    std::string edge;  ///< the word of values that are wrong at such places alone
  };
  Kind kind;
  std::vector<At> places;
  std::vector<Slip> slips;                                  ///< with their values at all places
  std::function<Value(const Value&, std::size_t at)> seen;  ///< what counts; empty: all of it
};

/// Adds a place's table to that of all places, in which each value of a mistake has its own row.
void add_place(std::vector<Slip>& all, const SlipTable& table);

template <class Out, class... Args>
[[nodiscard]] Trial trial_of(const Law<Out, Args...>& law) {
  Trial trial{kind_of<Out>(), {}, {}, {}};
  for (const auto& [name, at] : law.places) {
    trial.places.push_back({name, value_of<Out>(std::apply(law.right, at)),
                            law.count ? std::apply(law.count, at) : 0,
                            law.edge ? std::apply(law.edge, at) : ""});
    add_place(trial.slips, std::apply(law.slips, at));
  }
  if (law.seen) {
    trial.seen = [&law](const Value& value, std::size_t place) {
      const auto at = [&](const auto&... in) { return law.seen(typed<Out>(value), in...); };
      return value_of<Out>(std::apply(at, law.places[place].at));
    };
  }
  return trial;
}

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

/// Judges a function's values at all places.
///
/// A known mistake is named if it is wrong somewhere and gives the same at every place: of several,
/// the first.
[[nodiscard]] Verdict judge(const Trial& trial, const std::vector<Value>& values);

/// Values as bytes: Verdict::values.
[[nodiscard]] std::string bytes_of(const std::vector<Value>& values);
/// The values of a verdict again. Errors: std::runtime_error if there are too few for the trial.
[[nodiscard]] std::vector<Value> values_from(const std::string& bytes, const Trial& trial);

}  // namespace texmap::check
