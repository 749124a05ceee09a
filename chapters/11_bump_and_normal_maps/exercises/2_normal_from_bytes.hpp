// Exercise 11.2: a normal from three bytes
//
// A texel of a normal map has three bytes, 0 to 255. Each channel c, byte / 255, means the number
// 2c - 1: red along the tangent T, green along the bitangent B (this file is green up), blue along
// the normal. Return the three numbers as (x, y, z). The lesson makes the sum a unit vector later.
//
// Check it:  ./course check 11.2
#include "exercise.hpp"

Vec3 normal_of_texel(int red, int green, int blue) {
  // Your lines here. The numbers run from -1 to 1.
  return {red * 1.0, green * 1.0, blue * 1.0};
}
