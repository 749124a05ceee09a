// Whether two pictures are the same; if not, where they differ, what was seen, and why.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
#include "support/call_place.hpp"
#include "texture/image.hpp"

namespace texmap::test {

/// What still counts as the same picture.
struct Allowed {
  long pixels = 0;  ///< that may differ
  int levels = 0;   ///< that a channel may differ by before its pixel counts
};

/// What a mistake draws in place of the right picture; called only if a picture is wrong.
using WrongPictures = std::function<std::vector<WrongPicture>()>;

/// What is to say of a picture that is not what it should be: how many pixels differ, in which box,
/// the first with both values, and the name of a known mistake. Empty if the pictures are the same.
[[nodiscard]] std::string difference_report(const Image& is, const Image& should,
                                            const Allowed& allowed = {},
                                            const WrongPictures& wrong = {});

/// Checks that a picture is what it should be; a failure shows the difference_report. Both pictures
/// and a map of their differences are then written into the build folder; the failure says where.
void expect_same_picture(const Image& is, const Image& should, const Allowed& allowed = {},
                         const WrongPictures& wrong = {}, CallPlace place = CallPlace::current());

}  // namespace texmap::test
