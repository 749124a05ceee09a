// The tests of box_tree.hpp where the compiler has no vector types: four floats are an array.
#define TEXMAP_NO_VECTOR_TYPES
#include "engine/fast/test_box_tree.cpp"
