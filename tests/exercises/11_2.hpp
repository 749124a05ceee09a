// Exercise 11.2: a normal from three bytes
//
// A texel of a normal map has three bytes, 0 to 255. Each channel c, byte / 255, means the number
// 2c - 1: red along the tangent T, green along the bitangent B (this file is green up), blue along
// the normal. Return the three numbers as (x, y, z). The lesson makes the sum a unit vector later.
#include "exercise.hpp"

Vec3 normal_of_texel(int red, int green, int blue) {
  // solution
  return {2 * (red / 255.0) - 1, 2 * (green / 255.0) - 1, 2 * (blue / 255.0) - 1};
  // start: // Your lines here. The numbers run from -1 to 1.
  // start: return {red * 1.0, green * 1.0, blue * 1.0};
}
// hint: red / 255 divides whole numbers: 200 / 255 is 0. red / 255.0 is a double.
// hint: Byte 0 must become -1 and byte 255 must become 1, in each of the three channels.
