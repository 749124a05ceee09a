// The tests of chapter 14 where pairs of doubles judge, as where long double is double: CMake
// compiles the chapter's sources once more for this suite, with TEXMAP_JUDGE_PAIR.
#include "chapters/test_14_numerical_extremes.cpp"

static_assert(judge_is_pair);
