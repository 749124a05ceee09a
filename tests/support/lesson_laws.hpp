// Laws for every chapter's lesson: all numbers draw one picture; a step changes what it declares.
#pragma once
#include <doctest.h>

#include "number/kinds/pack.hpp"
#include "support/pictures.hpp"
#include "support/same_picture.hpp"

namespace texmap::test {

/// Put behind a test's name, `* NeedsFloat<Lesson>{}` skips the test of a lesson that cannot be run
/// with float.
template <class Lesson, class Real = float>
struct NeedsFloat {
  void fill(auto& test) const {
    doctest::skip(!draws_in<Lesson, Real>).fill(test);
    doctest::description(all_numbers ? "the lesson's `about` declares fewer numbers"
                                     : "a build for learning has one number")
        .fill(test);
  }
};

template <class Lesson>
using NeedsPacks = NeedsFloat<Lesson, Pack<double>>;

/// Checks that the lesson's numbers draw the same picture, in a size that no pack divides.
///
/// @param most_in_float  pixels that may differ in float; some must, or float was not used
template <class Lesson>
void check_all_numbers(const Lesson& lesson, long most_in_float) {
  const auto in = [&]<class Real>(Real) { return picture<Real>(lesson, 803, 601); };
  const Image reference = in(1.0);
  const Image in_float = in(1.0F);
  expect_same_picture(in(1.0L), reference);
  expect_same_picture(in(Pack<double>(1)), reference);
  if (draws_in<Lesson, Pack<float>>) CHECK(in(Pack<float>(1)) == in_float);
  expect_same_picture(in_float, reference, {.pixels = most_in_float});
  CHECK(count_different(in_float, reference) > 0);
}

/// Checks that only the objects that the step declares have changed, and that it finds a stray one.
///
/// @param stray  an object that may not change: it is painted `blue`
/// @return  how many pixels have changed
template <class Before, class After>
long check_step(const Before& before, const After& after, std::size_t stray) {
  const std::vector<int> seen = objects_seen(before);
  const Image first = picture(before);
  Image second = picture(after);
  const auto elsewhere = [&](const Image& image) {
    return changed_elsewhere(first, image, seen, After::about.changed_objects);
  };
  CHECK(elsewhere(second) == 0);
  const long changed = count_different(first, second);
  After wrong = after;
  wrong.objects[stray].paint = Solid{blue};
  CHECK(elsewhere(picture(wrong)) > 1000);
  second.at(10, 10).b ^= 1;
  CHECK(elsewhere(second) == 1);
  return changed;
}

}  // namespace texmap::test
