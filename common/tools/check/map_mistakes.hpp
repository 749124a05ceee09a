// What often goes wrong on the way from a point of the unit sphere to its (u, v) on a map.
#pragma once
#include "judge.hpp"
#include "math/vec3.hpp"
#include "texture/uv.hpp"

namespace texmap::check {

/// Adds these mistakes to the law of a function that gives (u, v).
///
/// @param signs  of x, y, z: times these a point has in chapter 02's convention the (u, v) that
///               the law wants
void add_map_mistakes(Law<Uv<double>(Vec3<double>)>& law, const Vec3<double>& signs);

}  // namespace texmap::check
