// The tests of pack_u32.hpp where the compiler has no vector types: packs are arrays.
#define TEXMAP_NO_VECTOR_TYPES
#include "number/test_pack_u32.cpp"
