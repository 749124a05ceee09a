// The diagrams of chapter 01: pixels and rays, a line and a sphere, Lambert's law.
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "diagrams.hpp"

namespace texmap::diagrams {
namespace {

/// Eye, pixel grid, and the ray through one pixel's center to a sphere.
Drawing eye_and_pixels() {
  Drawing d(
      "eye_and_pixels", 640, 300, "A ray through a pixel",
      "The eye on the left, a grid of pixels in front of it, and a sphere on the right. A ray "
      "starts at the eye, goes through the center of one pixel and meets the sphere.");
  const SpaceView view({1.0, 0.4, 0.7}, {500, 165}, 100);
  const Vec3d eye{0, 0.2, 5.2};
  const double plane = 3.0;  // z of the grid
  const double half_width = 0.8, half_height = 0.6, size = 0.2;
  const Vec3d pixel{0.1, 0.1, plane};

  d.circle(view({0, 0, 0}), 100, "ink");
  d.circle(view({0, 0, 0}), 100, "fill-soft");
  // The grid, and the pixel of the ray.
  d.area({view(pixel + Vec3d{-size / 2, -size / 2, 0}), view(pixel + Vec3d{size / 2, -size / 2, 0}),
          view(pixel + Vec3d{size / 2, size / 2, 0}), view(pixel + Vec3d{-size / 2, size / 2, 0})},
         "fill-blue");
  for (int i = -4; i <= 4; ++i)
    d.line(view({i * size, -half_height, plane}), view({i * size, half_height, plane}), "soft");
  for (int i = -3; i <= 3; ++i)
    d.line(view({-half_width, i * size, plane}), view({half_width, i * size, plane}), "soft");
  // The ray, up to where it meets the sphere of radius 1 around the origin.
  const Vec3d along = normalize(pixel - eye);
  const double b = -dot(eye, along);
  const double t = b - std::sqrt(b * b - (dot(eye, eye) - 1));
  const Vec3d hit = eye + along * t;
  d.arrow(view(eye), view(hit), "red");
  d.dot(view(eye));
  d.dot(view(pixel), "fill-blue");
  d.dot(view(hit), "fill-red");
  d.mark("eye", view(eye));
  d.mark("pixel", view(pixel));
  d.mark("hit", view(hit));
  d.text(view(eye) + Spot{0, -12}, "eye, o", Anchor::middle);
  d.text({30, 285}, "the picture, cut into pixels", Anchor::start, "small");
  d.line({196, 276}, view({-half_width + size, -half_height, plane}), "soft");
  d.text(view(pixel) + Spot{-10, -14}, "center of a pixel", Anchor::end, "blue small");
  d.text(view(hit) + Spot{12, -10}, "o + t d", Anchor::start, "red");
  d.text(view(eye) + (view(pixel) - view(eye)) * 0.45 + Spot{0, 24}, "ray, direction d",
         Anchor::middle, "red small");
  return d;
}

/// The camera's three axes, and the way to the center of a pixel.
Drawing camera_axes() {
  Drawing d("camera_axes", 640, 300, "The camera's three axes",
            "The eye with three arrows of length 1: forward, right and up. A grid of pixels stands "
            "at distance 1. From its middle the center of a pixel is x to the right and y up.");
  const SpaceView view({1.5, 0.75, 0.8}, {330, 160}, 150);
  const Vec3d eye{0, 0, 0.9}, forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};
  const Vec3d middle = eye + forward;
  const double size = 0.2, half_width = 0.8, half_height = 0.6;
  const Vec3d pixel = middle + right * (2.5 * size) + up * (1.5 * size);
  d.area({view(pixel + Vec3d{-size / 2, -size / 2, 0}), view(pixel + Vec3d{size / 2, -size / 2, 0}),
          view(pixel + Vec3d{size / 2, size / 2, 0}), view(pixel + Vec3d{-size / 2, size / 2, 0})},
         "fill-blue");
  for (int i = -4; i <= 4; ++i) {
    d.line(view(middle + Vec3d{i * size, -half_height, 0}),
           view(middle + Vec3d{i * size, half_height, 0}), "soft");
  }
  for (int i = -3; i <= 3; ++i) {
    d.line(view(middle + Vec3d{-half_width, i * size, 0}),
           view(middle + Vec3d{half_width, i * size, 0}), "soft");
  }
  d.arrow(view(eye), view(middle), "ink");
  d.arrow(view(eye), view(eye + right), "ink");
  d.arrow(view(eye), view(eye + up), "ink");
  d.dot(view(eye));
  const Vec3d corner = middle + right * (2.5 * size);
  d.line(view(middle), view(corner), "blue thick");
  d.line(view(corner), view(pixel), "green thick");
  d.dot(view(pixel), "fill-blue");
  d.mark("eye", view(eye));
  d.mark("middle", view(middle));
  d.mark("pixel", view(pixel));
  d.mark("right", view(eye + right) - view(eye));
  d.mark("up", view(eye + up) - view(eye));
  d.text(view(eye) + Spot{-12, 6}, "eye", Anchor::end);
  d.text(view(eye + right) + Spot{10, 6}, "right", Anchor::start);
  d.text(view(eye + up) + Spot{0, -8}, "up", Anchor::middle);
  d.text(view(eye + forward * 0.5) + Spot{-10, -4}, "forward", Anchor::end);
  d.text(view(middle + right * (1.3 * size)) + Spot{0, 18}, "x", Anchor::middle, "blue strong");
  d.text(view(corner + up * (0.75 * size)) + Spot{10, 6}, "y", Anchor::start, "green strong");
  return d;
}

/// A line and a sphere that have no, one and two points in common.
Drawing line_and_sphere() {
  Drawing d("line_and_sphere", 640, 230, "A line and a sphere: no, one or two roots",
            "Three circles of radius r. Left: a ray passes at a distance greater than r, no root. "
            "Middle: the distance is r, one root. Right: it is smaller, two roots; the nearer one "
            "is seen.");
  const double r = 62, half = 92;
  const std::array<std::pair<double, const char*>, 3> cases{
      {{1.25, "no root: the ray misses"}, {1.0, "one root: it touches"}, {0.5, "two roots"}}};
  double x = 110;
  for (const auto& [distance, words] : cases) {
    const Spot center{x, 120};
    const double y = center.y - distance * r;
    d.circle(center, r, "fill-soft");
    d.circle(center, r, "ink");
    d.arrow({center.x - half, y}, {center.x + half, y}, "red");
    d.line(center, {center.x, y}, "blue dashed");
    d.dot(center);
    const double squared = 1 - distance * distance;
    if (squared >= 0) {
      const double h = r * std::sqrt(squared);
      d.dot({center.x - h, y}, "fill-red");
      if (h > 0) {
        d.dot({center.x + h, y}, "fill-red");
        d.text({center.x - h - 6, y - 9}, "t₁", Anchor::end, "red");
        d.text({center.x + h + 6, y - 9}, "t₂", Anchor::start, "red");
        d.mark("near", {center.x - h, y});
        d.mark("far", {center.x + h, y});
        d.mark("center", center);
      } else {
        d.text({center.x, y - 9}, "t", Anchor::middle, "red");
      }
    }
    d.text({center.x + 6, (center.y + y) / 2 + 10}, "h", Anchor::start, "blue");
    d.line(center, {center.x + r * 0.8, center.y + r * 0.6}, "soft");
    d.text({center.x + r * 0.5, center.y + r * 0.3 - 2}, "r", Anchor::start, "small");
    d.text({center.x, 216}, words, Anchor::middle, "small");
    x += 210;
  }
  d.text({110, 172}, "h > r", Anchor::middle, "small");
  d.text({320, 172}, "h = r", Anchor::middle, "small");
  d.text({530, 172}, "h < r", Anchor::middle, "small");
  return d;
}

/// The same beam of light on a surface, straight and slanted.
Drawing lambert_law() {
  Drawing d("lambert", 640, 250, "Lambert's law",
            "Left: light falls straight down on a surface; a beam of width w lights a piece of "
            "width w. Right: it falls at an angle theta to the normal; the same beam lights a "
            "piece of width w divided by cos theta.");
  const double w = 80;
  const auto panel = [&](Spot at, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Spot to_lamp{std::sin(angle), -std::cos(angle)};
    const double wide = w / std::cos(angle);
    d.area({at + Spot{-wide / 2, 0}, at + Spot{wide / 2, 0}, at + Spot{wide / 2, 0} + to_lamp * 120,
            at + Spot{-wide / 2, 0} + to_lamp * (120 + wide * std::sin(angle))},
           "fill-red");
    d.line(at + Spot{-130, 0}, at + Spot{130, 0}, "ink");
    d.line(at + Spot{-wide / 2, 0}, at + Spot{wide / 2, 0}, "red thick");
    d.arrow(at, at + Spot{0, -110}, "blue");
    if (degrees > 0) {
      d.arrow(at, at + to_lamp * 110, "red");
      d.arc(at, 48, 90 - degrees, 90, "ink");
      const double half = angle / 2;
      d.text(at + Spot{std::sin(half), -std::cos(half)} * 64 + Spot{0, 5}, "θ");
      d.text(at + to_lamp * 110 + Spot{10, 4}, "l", Anchor::start, "red");
      // The beam's width, from its left edge straight across to its right one.
      const Spot foot = at + Spot{wide / 2, 0};
      const Spot across{-std::cos(angle), -std::sin(angle)};
      d.line(foot, foot + across * w, "red dashed");
      d.text(foot + across * (w * 0.27) + Spot{13, 6}, "w", Anchor::middle, "red");
    }
    d.text(at + Spot{-8, -104}, "n", Anchor::end, "blue");
    d.mark(degrees > 0 ? "slanted left" : "straight left", at + Spot{-wide / 2, 0});
    d.mark(degrees > 0 ? "slanted right" : "straight right", at + Spot{wide / 2, 0});
  };
  panel({150, 190}, 0);
  panel({450, 190}, 60);
  d.text({150, 216}, "w", Anchor::middle, "red");
  d.text({450, 216}, "w / cos θ", Anchor::middle, "red");
  d.text({150, 240}, "all of the light: cos 0° = 1", Anchor::middle, "small");
  d.text({450, 240}, "the same light on twice the width: cos 60° = 1/2", Anchor::middle, "small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_01() {
  return {eye_and_pixels(), camera_axes(), line_and_sphere(), lambert_law()};
}

}  // namespace texmap::diagrams
