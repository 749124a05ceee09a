// Chapter 01's symptoms: rays, normals, light and shadows, each with the word for what is wrong.
#include <vector>

#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"
#include "support/symptoms.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

using Objects = std::vector<Painted<Solid>>;

const Ray<double> straight{{0, 0, 5}, {0, 0, -1}};

Objects globe(double radius = 1) {
  return {{.shape = {.center = {0, 0, 0}, .radius = radius}, .paint = Solid{white}}};
}

/// The hit where `straight` meets the first object.
Hit<double> front_of(const Objects& objects) {
  const auto& shape = objects.front().shape;
  return hit_at(shape, straight, distance_to(shape, straight));
}

}  // namespace

TEST_CASE("a ray goes through the middle of its pixel") {
  const View<> view = view_of({.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov_y_degrees = 90}, 4, 2);
  const auto slope = [&](double column, double row) {
    const Vec3d direction = direction_through(view, column, row);
    return direction * (-1 / direction.z);
  };
  expect_number("the height of row 0 in a view of 90 degrees, 2 rows", slope(0, 0).y, 0.5,
                {{-0.5, "rows run the other way: the picture is upside down"},
                 {1, "the ray goes through the pixel's corner, half a pixel off"}},
                "the angle of view is not in degrees from edge to edge");
  expect_number("x of column 0", slope(0, 0).x, -1.5,
                {{1.5, "columns run the other way: the picture is mirrored"},
                 {-2, "the ray goes through the pixel's corner, half a pixel off"}});
}

TEST_CASE("a ray meets the near side of a sphere") {
  expect_number("the distance from (0, 0, 5) along -z to a sphere of radius 1",
                distance_to(globe().front().shape, straight), 4,
                {{6, "this is the far side: take the smaller root"}});
}

TEST_CASE("the normal points outward and has length 1") {
  expect_number("z of the normal in front of a sphere of radius 2", front_of(globe(2)).normal.z, 1,
                {{-1, "the normal points inward"},
                 {-2, "the normal points inward"},
                 {2, "the normal was not divided by the radius"}});
}

TEST_CASE("light is the cosine between the normal and the unit vector to the lamp") {
  const Objects objects = globe();
  const Hit<double> hit = front_of(objects);
  const auto cosine = [&](const Point& lamp) { return sample_light({lamp}, objects, hit).cosine; };
  expect_number("the cosine under a lamp straight above, 8 away", cosine({0, 0, 9}), 1,
                {{8, "the vector to the lamp was not divided by its length (not normalized)"},
                 {64, "the vector to the lamp was not divided by its length (not normalized)"},
                 {0, "the normal points inward, or the point is in its own shadow"}});
  expect_number(
      "the cosine on the side away from the lamp", cosine({0, 0, -9}), 0,
      {{-1, "a cosine below 0 takes light away: limit it to 0"}, {1, "the normal points inward"}});
}

TEST_CASE("no lit point of a sphere lies in its own shadow") {
  const Objects objects = globe();
  const PointLight lamp{{5, 5, 5}};
  const View<> view = view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}, .fov_y_degrees = 20}, 64, 64);
  int lit = 0, dark = 0;
  for (int pixel = 0; pixel < 64 * 64; ++pixel) {
    const auto ray = ray_through<double>(view, pixel % 64, pixel / 64);
    const double distance = distance_to(objects.front().shape, ray);
    if (!(distance < infinity<double>())) continue;
    const Hit<double> hit = hit_at(objects.front().shape, ray, distance);
    if (dot(hit.normal, normalize(lamp.position - hit.point)) < 0.01) continue;
    ++lit;
    dark += sample_light(lamp, objects, hit).cosine > 0 ? 0 : 1;
  }
  expect_number("of " + std::to_string(lit) + " lit points the number in shadow", dark, 0,
                {{static_cast<double>(lit), "the whole sphere lies in its own shadow"}},
                "a shadow ray meets the surface that it starts on (shadow without an offset)");
}

TEST_CASE("another object casts a shadow if it is between the point and the lamp") {
  Objects objects = globe();
  objects.push_back({.shape = {.center = {0, 0, 4}, .radius = 0.5}, .paint = Solid{white}});
  const Hit<double> hit = front_of(objects);
  expect_number("the cosine behind another sphere", sample_light({{0, 0, 9}}, objects, hit).cosine,
                0, {{1, "there are no shadows: no ray asks whether the lamp is hidden"}});
  expect_number("the cosine with a sphere behind the lamp",
                sample_light({{0, 0, 3}}, objects, hit).cosine, 1,
                {{0, "what lies behind the lamp casts a shadow: compare the distances"}});
}

TEST_CASE("brightness is ambient + diffuse times the cosine, and the sky is blue above") {
  const Lambertian surface{.ambient = 0.2, .diffuse = 0.8};
  expect_number(
      "the brightness at a cosine of 1/2", lambert<double>(surface, {{}, 0.5}), 0.6,
      {{0.5, "ambient and diffuse are exchanged"}, {0.4, "the ambient light is missing"}});
  const Stage stage;
  expect_number("red straight up in the sky", stage.sky(Ray<double>{{}, {0, 1, 0}}).r, 0.5,
                {{1, "the sky is upside down"}});
}
