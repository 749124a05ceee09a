// What the files of exercises include: vectors, (u, v) and colors, all in double.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/color.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

using Vec3 = texmap::Vec3<double>;    // .x .y .z, with + - * dot cross length normalized
using Uv = texmap::Uv<double>;        // .u .v
using Color = texmap::Color<double>;  // .r .g .b, 0 to 1

inline constexpr double pi = std::numbers::pi;
