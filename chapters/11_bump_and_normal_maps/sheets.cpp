// The chapter's sheets: bump or dent, the pole, the daily exercise's bricks.
#include "sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/draw/render.hpp"
#include "engine/files/sheet.hpp"
#include "published/brick_normals.hpp"
#include "published/uv.hpp"
#include "scene/sphere.hpp"
#include "studs.hpp"
#include "texture/bump.hpp"
#include "texture/conventions.hpp"
#include "texture/mapped.hpp"

namespace texmap::chapter_11 {
namespace {

constexpr Rgb8 paper{250, 248, 244};
constexpr Rgb8 ink{25, 25, 30};
constexpr Rgb8 bump_ink{20, 110, 50};
constexpr Rgb8 dent_ink{190, 40, 30};

struct Program {
  TangentRule rule;
  const char* title;
};
constexpr std::array<Program, 3> programs = {{
    {TangentRule::from_uv, "A  tangent = dP/du, bitangent = dP/dv (this chapter's program)"},
    {TangentRule::crossed, "B  tangent = dP/du, bitangent = normal x tangent"},
    {TangentRule::fixed,
     "C  tangent = +y x normal, bitangent = normal x tangent (the daily "
     "exercise)"},
}};

// The daily exercise's scene of 23 February 2026: two red balls, one lamp, Phong's light.

constexpr double ball_x = 1.5;
constexpr Vec3d eye{0, 0, 5};
constexpr Vec3d lamp{5, 5, 5};
constexpr Rgb ball_color{0.8, 0.3, 0.3};

/// The exercise's light with a shading normal: ambient 0.1, diffuse 0.7, highlight 0.5 cos^32.
Rgb phong_light(const Vec3d& point, const Vec3d& normal, const Vec3d& to_eye) {
  const Vec3d to_light = normalize(lamp - point);
  const double cosine = dot(normal, to_light);
  const Vec3d mirrored = normalize(normal * (2 * cosine) - to_light);
  const double highlight = 0.5 * pow(std::max(0.0, dot(mirrored, to_eye)), 32);
  return ball_color * (0.1 + 0.7 * std::max(0.0, cosine)) + gray(highlight);
}

/// The color along a ray: `bend(unit normal)` is the shading normal of the right ball.
template <class Bend>
Rgb color_of_balls(const Ray<double>& ray, const Bend& bend) {
  auto nearest = infinity<double>();
  Sphere<> ball;
  for (const double x : {-ball_x, ball_x}) {
    const Sphere<> one{.center = {x, 0, 0}};
    const double distance = distance_to(one, ray);
    if (distance < nearest) {
      nearest = distance;
      ball = one;
    }
  }
  if (!(nearest < infinity<double>())) {
    const double t = 0.5 * (ray.direction.y + 1);
    return mix(Rgb{1, 1, 1}, Rgb{0.5, 0.7, 1}, t);
  }
  const Hit<double> hit = hit_at(ball, ray, nearest);
  const Vec3d normal = ball.center.x > 0 ? bend(hit.normal) : hit.normal;
  return phong_light(hit.point, normal, -ray.direction);
}

Vec3d published_normal(const Vec3d& normal) {
  const Vec3d relative = published::brick_normal(published::uv_daily(normal));
  const TangentFrame<double> along = published::brick_tangents(normal);
  return normalize(along.tangent * relative.x + along.bitangent * relative.y + normal * relative.z);
}

/// Bricks as heights: 1 on a brick, 0 in the middle of the mortar, without edges between.
struct BrickHeight {
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Uv<Real>& uv) const {
    const Real row = uv.v * Real(6);
    const Real whole = floor(row);
    const Real odd = whole - Real(2) * floor(whole * Real(0.5));
    const Real column = uv.u * Real(12) + odd * Real(0.5);
    const auto ramp = [](const Real& x) {  // of the distance to the nearer edge of a brick
      const Real from_edge = min(x, Real(1) - x);
      const Real t = clamp(from_edge / Real(2 * published::brick_mortar), Real(0), Real(1));
      return t * t * (Real(3) - Real(2) * t);
    };
    return gray(ramp(column - floor(column)) * ramp(row - whole));
  }
};

Vec3d meant_normal(const Vec3d& normal) {
  const Bumps<Mapped<ConventionMapping, BrickHeight>> bricks{.height = {{Convention::daily}, {}},
                                                             .relief = 0.04};
  return bricks(Hit<double>{normal, normal, normal}, 1.0);
}

template <class Bend>
Image close_up(int size, const Bend& bend) {
  const Camera camera{.eye = eye, .target = {ball_x, 0, 0}, .fov_y_degrees = 25};
  const View<> view = view_of(camera, size, size);
  return image_of(size, size, [&](int column, int row) {
    const Rgb c = color_of_balls(ray_through<double>(view, column, row), bend);
    return Rgb8{byte_of(c.r), byte_of(c.g), byte_of(c.b)};
  });
}

}  // namespace

Image published_bricks(int width, int height) {
  const auto byte = [](double channel) {
    return static_cast<std::uint8_t>(clamp(channel, 0.0, 1.0) * 255.99);
  };
  const double wide = 2.0 * width / height;
  return image_of(width, height, [&](int column, int row) {
    // Pixels reach from edge to edge of the window, which is 2 high at distance 1.
    const Vec3d to_pixel{(static_cast<double>(column) / (width - 1) - 0.5) * wide,
                         (0.5 - static_cast<double>(row) / (height - 1)) * 2, -1};
    const Rgb c = color_of_balls({eye, normalize(to_pixel)}, published_normal);
    return Rgb8{byte(c.r), byte(c.g), byte(c.b)};
  });
}

Image side_by_side(const Image& left, const char* left_caption, const Image& right,
                   const char* right_caption) {
  const int scale = std::max(1, left.width / 400);
  const int line = 14 * scale;
  SheetImage sheet(left.width + right.width, left.height + line, paper);
  int from = 0;
  for (const auto& [picture, caption] :
       {std::pair(&left, left_caption), std::pair(&right, right_caption)}) {
    SheetColumn column{sheet, from, 0, scale, line, 3 * scale, 4 * scale, ink};
    column.write(caption);
    column.lay(*picture);
    from += picture->width;
  }
  return sheet;
}

Image sheet_of_bricks(int width) {
  const int half = std::max(1, width / 2);
  return side_by_side(close_up(half, published_normal), "as published: mortar that points inward",
                      close_up(half, meant_normal), "as meant: a height for every brick");
}

Image sheet_of_readings(int width) {
  const int scale = std::max(1, width / 800);
  const int gap = std::max(2, width / 160);
  const int plate = std::max(1, (width - gap) / 8 - gap);
  const int line = 11 * scale;
  const int header = 3 * line + gap;
  const int block = line + plate + 2 * line + gap;
  SheetImage sheet(width, header + 3 * block, paper);
  const Image green_up = stud_normals(plate, Green::up);
  const Image green_down = stud_normals(plate, Green::down);

  const auto column_at = [&](int i, int top, int above) {
    return SheetColumn{sheet, gap + i * (plate + gap), top, scale, line, above, 0, ink};
  };
  int i = 0;
  for (const Reading& reading : eight_readings(TangentRule::from_uv)) {
    SheetColumn column = column_at(i++, gap, 0);
    column.write(reading.green == Green::up ? "green up" : "green down");
    column.write(reading.v_down ? "v down" : "v up");
    column.write(reading.u_mirrored ? "u mirrored" : "u to the right");
  }
  int top = header;
  for (const Program& program : programs) {
    column_at(0, top, scale).write(program.title);
    i = 0;
    for (const Reading& reading : eight_readings(program.rule)) {
      SheetColumn column = column_at(i++, top + line, scale);
      column.lay(draw_plate(reading, reading.green == Green::up ? green_up : green_down, plate));
      const Verdict verdict = verdict_of(reading);
      column.write(verdict.word(), verdict.bump ? bump_ink : dent_ink);
      if (!verdict.surface) column.write("no surface", dent_ink);
    }
    top += block;
  }
  return sheet;
}

}  // namespace texmap::chapter_11
