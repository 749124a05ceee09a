// Judges a function by its values: at named places, against the right ones and against known
// mistakes.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "slips.hpp"
#include "words.hpp"

namespace texmap::check {

/// A place where a function is tried: what should be there, in words, and the arguments.
template <class... Args>
struct Place {
  std::string law;  ///< "on +z, (0, 0, 1), u is 1/4"
  std::tuple<Args...> at;
};
template <class... Args>
using Places = std::vector<Place<Args...>>;

/// What is known of a function: the right one, what often goes wrong, and where to try it.
template <class Function>
struct Law;
template <class Out, class... Args>
struct Law<Out(Args...)> {
  std::function<Out(Args...)> right;
  std::function<Slips<Out>(Args...)> slips;  ///< what often comes out at a place
  Places<std::decay_t<Args>...> places;      ///< in the order of teaching
  double tolerance = 1e-9;                   ///< of each part of a value
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
[[nodiscard]] Slips<Out> slips_at_all_places(const Law<Out(Args...)>& law) {
  Slips<Out> all;
  for (const auto& place : law.places) {
    std::size_t row = 0;
    for (const Slip<Out>& slip : std::apply(law.slips, place.at)) {
      for (const Out value : slip.values) {
        if (row == all.size()) all.push_back({slip.word, std::vector<Out>{}});
        all[row++].values.push_back(value);
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
[[nodiscard]] Verdict judge(const Law<Out(Args...)>& law, const std::vector<Out>& values) {
  Verdict verdict;
  verdict.places = values.size();
  const auto same = [&](const Out& a, const Out& b) { return apart(a, b) <= law.tolerance; };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Out value = values[i];
    verdict.values.append(reinterpret_cast<const char*>(&value), sizeof value);
    const Out right = std::apply(law.right, law.places[i].at);
    if (same(right, value)) continue;
    if (verdict.right) {
      verdict.right = false;
      verdict.law = law.places[i].law;
      verdict.expected = in_words(right);
      verdict.got = in_words(value);
    }
    ++verdict.wrong;
  }
  if (verdict.right) return verdict;
  for (const Slip<Out>& slip : slips_at_all_places(law)) {
    if (!std::equal(values.begin(), values.end(), slip.values.begin(), same)) continue;
    verdict.mistake = slip.word;
    break;
  }
  return verdict;
}

}  // namespace texmap::check
