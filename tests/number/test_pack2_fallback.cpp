// The tests of pack2.hpp where xsimd is not installed: packs are arrays.
#undef TEXMAP_HAVE_XSIMD
#include "number/test_pack2.cpp"
#include "support/shown_values.hpp"
