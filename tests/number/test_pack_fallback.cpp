// The tests of pack.hpp and pack2.hpp where xsimd is not installed: packs are arrays.
#undef TEXMAP_HAVE_XSIMD
#include "number/test_pack.cpp"
