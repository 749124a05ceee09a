// The numbers that judge: 50 and 100 decimal digits. TEXMAP_HAVE_DIGITS says that they are there: where Boost is installed, and
// the program is not watched step by step; there they take minutes to compile, and it is not their steps that are on trial.
#pragma once

#if __has_include(<boost/multiprecision/cpp_bin_float.hpp>) && !defined(TEXMAP_INSTRUMENTED)
#define TEXMAP_HAVE_DIGITS
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace texmap {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Digits100 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

}  // namespace texmap
#endif
