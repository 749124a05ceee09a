// The tests of pack.hpp where xsimd is not installed: packs are arrays.
#undef TEXMAP_HAVE_XSIMD
#include "number/test_pack.cpp"
