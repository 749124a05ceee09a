// Chapter 11: a lamp that one can move, and the frame at a point.
#pragma once
#include <cmath>
#include <numbers>

#include "11_bump_and_normal_maps/lesson.hpp"
#include "figure.hpp"
#include "live.hpp"

namespace texmap::live {

struct BumpsAndLamp {
  double around = -51, up = 32;  ///< of the lesson's lamp, in degrees

  void declare(CommandLine& line) {
    line.decimal("--lamp-around", around, -180, 180,
                 "where the lamp is: degrees to the right, seen from above; 0 is behind the eye");
    line.decimal("--lamp-up", up, -90, 90, "degrees above the globe's equator");
  }
  /// Moves the lamp, if it was moved at all: its presets are the lesson's lamp, rounded.
  void apply(chapter_11::Lesson& lesson) const {
    const BumpsAndLamp preset;
    if (around == preset.around && up == preset.up) return;
    Point& lamp = lesson.stage.light.position;
    const double far = length(lamp), degree = std::numbers::pi / 180;
    lamp = Point{std::sin(around * degree) * std::cos(up * degree), std::sin(up * degree),
                 std::cos(around * degree) * std::cos(up * degree)} *
           far;
  }

  template <class State>
  [[nodiscard]] Members look(const State& state, int column, int row) const {
    const chapter_11::Lesson& lesson = state.lesson;
    const Ray<double> ray = ray_through(state.whole, double(column), double(row));
    const Nearest<double> nearest = find_nearest(lesson.objects, ray);
    if (nearest.index < 0) return {{"rows", Json::list({fact({"hit", "nothing: the sky"})})}};
    const auto& ball = lesson.objects.front().shape;
    const Hit<double> hit = hit_at(ball, ray, nearest.distance);
    const double curvature = inverse_radius<double>(ball);
    const auto& bumps = lesson.bumps;
    const Vec3d normal = bumps(hit, curvature);
    Frame<double> frame = frame_about(hit.normal);
    std::vector<Json> rows = {fact("normal n", hit.normal)};
    if (bumps.map) {
      const auto along = tangents(
          bumps.map->rule, hit.normal,
          point_by_uv(frame, uv_at(bumps.map->mapping, with_steps(hit, frame, curvature))));
      frame = {along.tangent, along.bitangent};
      rows.push_back(fact("t", frame.right, {": along u"}));
      rows.push_back(fact("b", frame.up, {": along v"}));
    } else {
      const auto slope = slope_of(bumps.height, hit, frame, curvature, bumps.slopes, bumps.step);
      rows.push_back(fact("t", frame.right, {", slope ", bumps.relief * slope.right}));
      rows.push_back(fact("b", frame.up, {", slope ", bumps.relief * slope.up}));
      rows.push_back(fact({"height", slope.height, " · relief ", bumps.relief}));
    }
    const auto light = sample_light(lesson.stage.light, lesson.objects, hit, normal);
    const double leans = std::acos(clamp(dot(normal, hit.normal), -1.0, 1.0));
    rows.push_back(fact("bump's n", normal, {", leans by ", leans * 180 / std::numbers::pi, "°"}));
    rows.push_back(fact("light l", light.to_light,
                        {", n · l = ", dot(hit.normal, light.to_light), ", bump's n · l = ",
                         dot(normal, light.to_light), ", light ", lambert(lesson.surface, light)}));
    Figure figure{
        "The frame at the point, seen by the eye: t red, b green, n blue, the bump's n in ink, l "
        "yellow",
        2.4, 2.4};
    const auto arrow = [&](const Vec3d& v, const char* color) {
      figure.line(1.2, 1.2, 1.2 + dot(v, state.whole.right), 1.2 - dot(v, state.whole.up), color);
    };
    arrow(frame.right, "#d33");
    arrow(frame.up, "#2a2");
    arrow(hit.normal, "#48f");
    arrow(light.to_light, "#db2");
    arrow(normal, "ink");
    return {{"rows", Json::list(rows)}, {"figure", figure.json()}};
  }
};

using Chapter11 = Live<chapter_11::Lesson, BumpsAndLamp>;

}  // namespace texmap::live
