// Chapter 08: the edge functions and the weights of a pixel's triangle.
#pragma once
#include <cmath>

#include "08_triangle_uv/lesson.hpp"
#include "figure.hpp"
#include "live.hpp"

namespace texmap::live {

struct TriangleUv {
  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    const chapter_08::Lesson& lesson = state.lesson;
    const BoxedMesh& mesh = lesson.scene.mesh;
    const Ray<double> ray = ray_through(state.whole, double(column), double(row));
    const MeshHit<double> hit = lesson.choice.weighted(mesh, first_hit(mesh, ray));
    if (!hit.met) return {{"rows", Json::list({fact({"hit", "nothing: the sky"})})}};
    const int triangle = static_cast<int>(hit.triangle);
    const RaySpace<double> space(ray);
    std::array<Vec3d, 3> seen;
    Vec3d low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      seen[i] = seen_along(space, mesh.corner(triangle, static_cast<int>(i)));
      low = {std::min(low.x, seen[i].x), std::min(low.y, seen[i].y), 0};
      high = {std::max(high.x, seen[i].x), std::max(high.y, seen[i].y), 0};
    }
    const std::array areas = {side_of_edge(seen[1], seen[2]).area,
                              side_of_edge(seen[2], seen[0]).area,
                              side_of_edge(seen[0], seen[1]).area};
    const double whole = areas[0] + areas[1] + areas[2];
    const double size = std::max(high.x - low.x, high.y - low.y) * 1.3;
    Figure figure{"The triangle as the ray sees it; the ray passes through the dot"};
    const auto x = [&](const Vec3d& p) { return (p.x - (low.x + high.x) / 2) / size + 0.5; };
    const auto y = [&](const Vec3d& p) { return 0.5 - (p.y - (low.y + high.y) / 2) / size; };
    const char* const names[] = {"a", "b", "c"};
    const std::array weights = {hit.a, hit.b, hit.c};
    const auto& uvs = lesson.scene.mapping.corners[static_cast<std::size_t>(triangle)];
    std::vector<Json> rows = {fact({"triangle", triangle, " at distance ", hit.distance})};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d &from = seen[(i + 1) % 3], &to = seen[(i + 2) % 3];
      figure.line(x(from), y(from), x(to), y(to), "ink");
      figure.line(x({}), y({}), x(seen[i]), y(seen[i]), "accent");
      figure.word(x(seen[i]), y(seen[i]), names[i]);
      rows.push_back(fact({names[i], "weight = edge function / sum = ", areas[i], " / ", whole,
                           " = ", weights[i], "; (u, v) = (", uvs[i].u, ", ", uvs[i].v, ")"}));
    }
    figure.dot(x({}), y({}), "accent");
    const Uv<double> uv = lesson.paint.mapping(hit);
    const auto add_mix = [&](const char* name, double Uv<double>::*part) {
      rows.push_back(fact({name, hit.a, " · ", uvs[0].*part, " + ", hit.b, " · ", uvs[1].*part,
                           " + ", hit.c, " · ", uvs[2].*part, " = ", uv.*part}));
    };
    if (!std::isnan(uv.u)) add_mix("u", &Uv<double>::u), add_mix("v", &Uv<double>::v);
    const auto light =
        sample_light(lesson.stage.light, others(mesh, hit), hit, lesson.scene.normal);
    const Color<double> paint = lesson.paint(hit);
    rows.push_back(fact("paint", {255 * paint.r, 255 * paint.g, 255 * paint.b},
                        {" · light ", lambert(lesson.surface, light)}));
    return {{"rows", Json::list(rows)}, {"figure", figure.json()}};
  }
};

using Chapter08 = Live<chapter_08::Lesson, TriangleUv>;

}  // namespace texmap::live
