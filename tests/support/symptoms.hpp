// Checks that name the mistake: what, where, what it is, what it should be, and the word.
#pragma once
#include <doctest.h>

#include <cmath>
#include <initializer_list>
#include <string>

#include "engine/files/text.hpp"
#include "support/call_place.hpp"

namespace texmap::test {

/// What a known mistake makes of a number.
struct Suspect {
  double value;
  const char* word;  ///< such as "u runs the other way (mirrored)"
};

inline constexpr double beyond_doubt = 1e-9;

/// Checks a number, and says of a wrong one which mistake makes it.
///
/// @param what      such as "u at +x"
/// @param usually   the word for a value that no suspect makes
/// @param within    how far off a right value may be
inline void expect_number(const std::string& what, double is, double should,
                          std::initializer_list<Suspect> suspects, const char* usually = "",
                          double within = beyond_doubt, CallPlace place = CallPlace::current()) {
  const auto same = [within](double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= within;
  };
  if (same(is, should)) {
    CHECK(same(is, should));
    return;
  }
  std::string word = usually;
  for (const Suspect& suspect : suspects) {
    if (same(is, suspect.value)) {
      word = suspect.word;
      break;
    }
  }
  std::string report = what;
  report += " is " + shown(is, 10) + " here and should be " + shown(should, 10);
  if (!word.empty()) report += ": " + word;
  ADD_FAIL_CHECK_AT(place.file, place.line, report);
}

/// Checks that something is so, and names the mistake if it is not.
inline void expect_that(bool so, const std::string& law, const char* word,
                        CallPlace place = CallPlace::current()) {
  if (so) {
    CHECK(so);
    return;
  }
  ADD_FAIL_CHECK_AT(place.file, place.line, law << ": " << word);
}

}  // namespace texmap::test
