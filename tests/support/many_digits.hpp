// Reference numbers of 50 decimal digits. TEXMAP_HAVE_DIGITS says that they exist: where Boost is
// installed, except in instrumented builds, which would take minutes to compile them.
#pragma once

#if __has_include(<boost/multiprecision/cpp_bin_float.hpp>) && !defined(TEXMAP_INSTRUMENTED)
#define TEXMAP_HAVE_DIGITS
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace texmap::test {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;

}  // namespace texmap::test
#endif
