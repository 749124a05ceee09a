// Judges a function by its values: at named places, against the right ones and against known
// mistakes.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
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

/// What is known of a function: the right one, where to try it, and what often goes wrong.
template <class Function>
struct Law;
template <class Out, class... Args>
struct Law<Out(Args...)> {
  std::function<Out(Args...)> right;
  std::vector<Place<std::decay_t<Args>...>> places;  ///< in the order of teaching
  std::function<Slips<Out>(Args...)> slips;          ///< what often comes out at a place
  double tolerance = 1e-9;                           ///< of each part of a value
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

/// Tries a function at all places.
///
/// A known mistake is named if its function is wrong somewhere and gives the same as `yours` at
/// every place: of several, the first.
template <class Out, class... Args>
[[nodiscard]] Verdict judge(const Law<Out(Args...)>& law,
                            const std::function<Out(Args...)>& yours) {
  Verdict verdict;
  verdict.places = law.places.size();
  std::vector<Out> values;
  for (const auto& place : law.places) {
    values.push_back(std::apply(yours, place.at));
    const Out value = values.back();
    verdict.values.append(reinterpret_cast<const char*>(&value), sizeof value);
    const Out right = std::apply(law.right, place.at);
    if (apart(right, value) <= law.tolerance) continue;
    if (verdict.right) {
      verdict.right = false;
      verdict.law = place.law;
      verdict.expected = in_words(right);
      verdict.got = in_words(value);
    }
    ++verdict.wrong;
  }
  if (verdict.right) return verdict;
  std::vector<const char*> words;  // of the mistakes that give the same so far, or null
  for (std::size_t i = 0; i < law.places.size(); ++i) {
    std::size_t row = 0;
    for (const Slip<Out>& slip : std::apply(law.slips, law.places[i].at)) {
      for (const Out value : slip.values) {
        if (i == 0) words.push_back(slip.word);
        if (!(apart(value, values[i]) <= law.tolerance)) words[row] = nullptr;
        ++row;
      }
    }
  }
  const auto named = std::find_if(words.begin(), words.end(), [](auto* word) { return word; });
  if (named != words.end()) verdict.mistake = *named;
  return verdict;
}

}  // namespace texmap::check
