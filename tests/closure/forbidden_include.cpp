// Chapter 01 with one header too many: the closure check must find it.
#include "../../chapters/01_plain_spheres/lesson.hpp"
#include "uv.hpp"

int main() { return static_cast<int>(texmap::uv_rtiow(texmap::Point{0, 1, 0}).u); }
