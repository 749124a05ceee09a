// Exercise 11.3: the bitangent of a mirrored copy
//
// A 3D file stores for each corner the unit normal n, the unit tangent T, in which u grows, and a
// sign. The sign is 1 if u, v and n form a right-handed frame, and -1 on a mirrored copy of the
// picture. Return the bitangent B, in which v grows. B, n and T are at right angles to each other.
// The left half of the chapter's globe has the picture as it is, the right half a mirrored copy.
#include "exercise.hpp"

Vec3 bitangent_of(Vec3 n, Vec3 t, double sign) {
  // solution
  return cross(n, t) * sign;
  // start: // Your line here. cross(a, b) is at a right angle to a and to b.
  // start: return (n + t) * sign;
}
// hint: In a right-handed frame T x B = n, n x T = B and B x T = -n.
// hint: On a mirrored copy n x T points where v falls. The sign turns it around.
