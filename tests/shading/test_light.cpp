// Tests of common/shading/light.hpp: Lambert's law and shadows.
#include <doctest.h>

#include <vector>

#include "light.hpp"
#include "pack.hpp"

namespace texmap {
namespace {

struct Thing {
  Sphere sphere;
};

/// A point of the ground, which faces up.
template <class Real>
const Hit<Real> ground{.normal = {0, 1, 0}, .point = {0, 0, 0}, .outside = {0, 0, 0}, .inside = {0, 0, 0}};

const std::vector<Thing> nothing;

/// A list of objects that counts how often somebody looks at it.
struct Watched {
  const std::vector<Thing>& things;
  int& looks;
  [[nodiscard]] auto begin() const {
    ++looks;
    return things.begin();
  }
  [[nodiscard]] auto end() const { return things.end(); }
};

TEST_CASE_TEMPLATE("brightness follows the cosine at exact points", Real, float, double, long double) {
  struct Row {
    Point lamp;
    long double cosine;
  };
  const Row table[] = {
      {{0, 5, 0}, 1},         {{3, 4, 0}, 0.8L}, {{0, 3, -4}, 0.6L}, {{0, 1e-3, 0}, 1}, {{2, 1, 2}, 1 / 3.0L},
      {{-2, 3, 6}, 3 / 7.0L}, {{5, 0, 0}, 0},    {{0, -5, 0}, 0},    {{3, -4, 0}, 0},   {{3e6, 4e6, 0}, 0.8L},
  };
  for (const Row& row : table) {
    CAPTURE(row.lamp.x);
    CAPTURE(row.lamp.y);
    const Illumination<Real> lamp = illumination(PointLight{row.lamp}, nothing, ground<Real>);
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    CHECK(abs(lamp.cosine - static_cast<Real>(row.cosine)) <= epsilon);
    CHECK(abs(length(lamp.to_light) - Real(1)) <= Real(3) * epsilon);
    CHECK(dot(lamp.to_light, number_cast<Real>(row.lamp)) > Real(0));
    const Real brightness = lambert(Matt{.ambient = 0.25, .diffuse = 0.5}, lamp);
    CHECK(abs(brightness - static_cast<Real>(0.25L + 0.5L * row.cosine)) <= epsilon);
  }
}

TEST_CASE_TEMPLATE("a matt surface is 0.2 in shadow and 1 under the lamp unless told otherwise", Real, float, double,
                   long double) {
  CHECK(lambert(Matt{}, Illumination<Real>{{0, 1, 0}, Real(0)}) == Real(0.2));
  // 0.2 and 0.8 are numbers of a scene, rounded in double.
  const Real lit = lambert(Matt{}, Illumination<Real>{{0, 1, 0}, Real(1)});
  CHECK(abs(lit - Real(1)) <= static_cast<Real>(std::numeric_limits<double>::epsilon()) / Real(2));
}

TEST_CASE_TEMPLATE("a thing between the lamp and the surface takes the light, and anything elsewhere leaves it", Real, float,
                   double, long double) {
  const PointLight above{{0, 5, 0}};
  struct Row {
    const char* where;
    Sphere sphere;
    bool dark;
  };
  const Row table[] = {
      {"between", {{0, 2.5, 0}, 0.5}, true},          {"between, off the line", {{0.4, 2.5, 0}, 0.5}, true},
      {"beside", {{0.6, 2.5, 0}, 0.5}, false},        {"behind the lamp", {{0, 7, 0}, 0.5}, false},
      {"below the ground", {{0, -2, 0}, 0.5}, false}, {"around the lamp", {{0, 5, 0}, 0.5}, true},
      {"around everything", {{0, 0, 0}, 50}, false},
  };
  for (const Row& row : table) {
    CAPTURE(row.where);
    for (const std::vector<Thing>& things :
         {std::vector<Thing>{{row.sphere}}, {{row.sphere}, {{{9, 9, 9}, 1}}}, {{{{9, 9, 9}, 1}}, {row.sphere}}}) {
      const Illumination<Real> lamp = illumination(above, things, ground<Real>);
      CHECK(lamp.cosine == (row.dark ? Real(0) : Real(1)));
      CHECK(lamp.to_light.y == Real(1));
    }
  }
}

TEST_CASE_TEMPLATE("a face turned away from the lamp costs no shadow ray and is as dark as with one", Real, float, double,
                   long double) {
  const std::vector<Thing> things = {{{{0, 2.5, 0}, 0.5}}, {{{0, -2.5, 0}, 0.5}}};
  for (const Point& position : {Point{0, -5, 0}, Point{3, -4, 0}, Point{5, 0, 0}, Point{0, 5, 0}, Point{3, 4, 0}}) {
    int looks = 0;
    const Illumination<Real> lamp = illumination(PointLight{position}, Watched{things, looks}, ground<Real>);
    CAPTURE(position.x);
    CAPTURE(position.y);
    CHECK(looks == (position.y > 0 ? 1 : 0));
    if (position.y <= 0) CHECK(lamp.cosine == Real(0));
  }
}

TEST_CASE_TEMPLATE("a sphere does not shade the half of itself that faces the lamp", Real, float, double, long double) {
  for (const double radius : {1e-3, 1.0, 1e3}) {
    const std::vector<Thing> things = {{{{radius, -2 * radius, 3 * radius}, radius}}};
    const Sphere& sphere = things[0].sphere;
    const PointLight light{{9 * radius, 7 * radius, 5 * radius}};
    int lit = 0;
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const double y = 1 - (2 * i + 1.0) / 2000;
      const Point out{std::sqrt(1 - y * y) * std::cos(i * 2.4), y, std::sqrt(1 - y * y) * std::sin(i * 2.4)};
      const Point eye = sphere.center + out * (3 * radius);
      const Ray<Real> ray{number_cast<Real>(eye), number_cast<Real>(-out)};
      const Hit<Real> hit = hit_at(sphere, ray, distance_to(sphere, ray));
      const Illumination<Real> alone = illumination(light, nothing, hit);
      const Illumination<Real> lamp = illumination(light, things, hit);
      if (lamp.cosine != alone.cosine) ++wrong;
      if (lamp.cosine > Real(0)) ++lit;
    }
    CAPTURE(radius);
    CHECK(wrong == 0);
    CHECK(lit > 800);
    CHECK(lit < 1000);
  }
}

TEST_CASE_TEMPLATE("the shadow ray starts at the lifted point, and the light's direction at the hit point", Real, float, double,
                   long double) {
  const std::vector<Thing> things = {{{{0, 2, 0}, 1}}};
  const PointLight above{{0, 9, 0}};
  Hit<Real> hit = ground<Real>;
  hit.outside = {0, Real(3.5), 0};  // already past the thing
  CHECK(illumination(above, things, hit).cosine == Real(1));
  CHECK(illumination(above, things, ground<Real>).cosine == Real(0));
}

#ifdef TEXMAP_HAVE_PACKS
TEST_CASE_TEMPLATE("each lane of a pack has its own shadow", T, float, double) {
  using Many = Pack<T>;
  const std::vector<Thing> things = {{{{0, 2, 0}, 0.5}}};
  const PointLight above{{0, 4, 0}};
  const auto x = from_lanes<Many>([](std::size_t i) { return i % 2 == 0 ? T(0) : T(3); });
  const Vec3<Many> at{x, Many(0), Many(0)};
  const Illumination<Many> lamps = illumination(above, things, Hit<Many>{{Many(0), Many(1), Many(0)}, at, at, at});
  for (std::size_t i = 0; i < lanes<Many>; ++i) {
    const Vec3<T> one{lane(x, i), 0, 0};
    const Illumination<T> lamp = illumination(above, things, Hit<T>{{0, 1, 0}, one, one, one});
    CHECK(lane(lamps.cosine, i) == lamp.cosine);
    CHECK(lane(lamps.to_light.x, i) == lamp.to_light.x);
    CHECK((lamp.cosine > T(0)) == (i % 2 == 1));
  }
}
#endif

}  // namespace
}  // namespace texmap
