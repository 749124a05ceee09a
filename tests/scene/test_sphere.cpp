// Tests of scene/sphere.hpp, and of published/sphere.hpp where it differs.
#include <doctest.h>

#include "engine/kernels/prepared_scene.hpp"
#include "number/kinds/interval.hpp"
#include "number/kinds/pack.hpp"
#include "published/sphere.hpp"
#include "scene/sphere.hpp"
#include "scene/sphere_choice.hpp"
#include "support/dice.hpp"
#include "support/exact.hpp"
#include "support/lanes.hpp"
#include "texture/uv.hpp"

namespace texmap::test {
namespace {

/// The distance from `got` to the exact value in steps of Real.
template <class Real>
Exact ulps(Real got, Exact exact) {
  const Real magnitude = abs(static_cast<Real>(exact));
  return abs(static_cast<Exact>(got) - exact) /
         static_cast<Exact>(std::nextafter(magnitude, infinity<Real>()) - magnitude);
}

const Sphere<> unit_sphere{{0, 0, 0}, 1};
const Sphere<> hybrid_sphere{{0, 0, 0}, 1, SphereForm::hybrid};

TEST_CASE_TEMPLATE("distances obey their table: outside, inside, behind, missing and on the sphere",
                   Real, float, double, long double) {
  const Real miss = infinity<Real>();
  struct Row {
    const char* what;
    Sphere<> sphere;
    Ray<Real> ray;
    Real distance;
  };
  const Row table[] = {
      {"from the front", unit_sphere, {{0, 0, 5}, {0, 0, -1}}, 4},
      {"from the front, a long direction", unit_sphere, {{0, 0, 5}, {0, 0, -2}}, 2},
      {"from the left", unit_sphere, {{-3, 0, 0}, {1, 0, 0}}, 2},
      {"from above, another sphere", {{1, 2, 3}, 2}, {{1, 10, 3}, {0, -1, 0}}, 6},
      {"from the center, P21", {{0, 0, 0}, 3}, {{0, 0, 0}, {1, 2, 2}}, 1},
      {"from inside, ahead of the center", unit_sphere, {{0, 0, Real(0.5)}, {0, 0, 1}}, Real(0.5)},
      {"from inside, behind the center", unit_sphere, {{0, 0, Real(-0.5)}, {0, 0, 1}}, Real(1.5)},
      {"behind the ray", unit_sphere, {{0, 0, 5}, {0, 0, 1}}, miss},
      {"beside the ray", unit_sphere, {{0, 2, 5}, {0, 0, -1}}, miss},
      {"from the surface inward", unit_sphere, {{0, 0, 1}, {0, 0, -1}}, 2},
      {"from the surface outward", unit_sphere, {{0, 0, 1}, {0, 0, 1}}, miss},
      {"from the surface along it", unit_sphere, {{1, 0, 0}, {0, 0, 1}}, miss},
      {"without a direction", unit_sphere, {{0, 0, 5}, {0, 0, 0}}, miss},
      {"without a direction, from inside", unit_sphere, {{0, 0, 0}, {0, 0, 0}}, miss},
      {"with a direction that is no number",
       unit_sphere,
       {{0, 0, 5}, {0, std::numeric_limits<Real>::quiet_NaN(), -1}},
       miss},
  };
  for (const Row& row : table) {
    CAPTURE(row.what);
    CHECK(distance_to(row.sphere, row.ray) == row.distance);
  }
}

TEST_CASE_TEMPLATE("a tangent counts as a hit", Real, float, double, long double) {
  const Ray<Real> touching{{1, 0, -5}, {0, 0, 1}};
  CHECK(ulps(distance_to(unit_sphere, touching), 5) <= 2);
  const Ray<Real> passing{{std::nextafter(Real(1), Real(2)), 0, -5}, {0, 0, 1}};
  CHECK(distance_to(unit_sphere, passing) == infinity<Real>());
  const Hit<Real> hit = hit_at(unit_sphere, touching, distance_to(unit_sphere, touching));
  CHECK(abs(hit.normal.x - Real(1)) <= std::numeric_limits<Real>::epsilon());
}

TEST_CASE_TEMPLATE("a sphere ten million radii away is hit in the middle of its picture", Real,
                   float, double, long double) {
  const Ray<Real> ray{{0, 0, Real(1e7)}, {0, 0, -1}};
  const Real distance = distance_to(unit_sphere, ray);
  CHECK(ulps(distance, 9999999) <= 1);
  const Uv<Real> uv = uv_rtiow(hit_at(unit_sphere, ray, Real(9999999)).normal);
  CHECK(uv.u == Real(0.25));
  CHECK(uv.v == Real(0.5));
}

TEST_CASE("the published ray from 4096 radii away keeps its digits") {
  const Ray<double> ray{{0.5, 0.25, 4096}, {0, 0, -1}};
  const double distance = distance_to(unit_sphere, ray);
  CHECK(ulps(distance, 4095.1708438024112L) <= 4);
  const Uv<double> uv = uv_rtiow(hit_at(unit_sphere, ray, distance).normal);
  CHECK(abs(uv.u - 0.33636369543798065) <= 1e-12);
  CHECK(abs(uv.v - 0.58043062325516624) <= 1e-12);
}

TEST_CASE("the length of the direction changes the distance and not the place") {
  const Point direction{-0.1, 0.05, -1};
  const Ray<double> ray{{0.5, 0.25, 5}, direction};
  const double distance = distance_to(unit_sphere, ray);
  const Uv<double> place = uv_rtiow(hit_at(unit_sphere, ray, distance).normal);
  REQUIRE(distance < 10);
  for (const double length : {1e-20, 1e-3, 1e20}) {
    CAPTURE(length);
    const Ray<double> other{ray.origin, direction * length};
    const double other_distance = distance_to(unit_sphere, other);
    const Uv<double> other_place = uv_rtiow(hit_at(unit_sphere, other, other_distance).normal);
    CHECK(other_distance * length == doctest::Approx(distance).epsilon(1e-15));
    CHECK(abs(other_place.u - place.u) <= 1e-12);
    CHECK(abs(other_place.v - place.v) <= 1e-12);
  }
}

/// The distance along (0, 0, -1) from (0, height, distance) to the unit sphere, by Pythagoras.
Exact from_pythagoras(Exact height, Exact distance) {
  return distance - sqrt((1 - height) * (1 + height));
}

TEST_CASE_TEMPLATE("distances keep their digits from 1 to 100000 radii away", Real, float, double) {
  for (const double away : {1.5, 10.0, 1e3, 1e4, 1e5}) {
    Exact worst = 0;
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto height = static_cast<Real>((i + 0.5) / 2000 * 1.1);
      const Ray<Real> ray{{0, height, static_cast<Real>(away)}, {0, 0, -1}};
      const Real distance = distance_to(unit_sphere, ray);
      if ((distance < infinity<Real>()) != (height < Real(1))) ++wrong;
      if (height < Real(0.99))
        worst = std::max(worst, ulps(distance, from_pythagoras(widened(height),
                                                               widened(static_cast<Real>(away)))));
    }
    CAPTURE(away);
    MESSAGE("worst: " << static_cast<double>(worst) << " ulps at " << away << " radii");
    CHECK(wrong == 0);
    CHECK(worst <= (away < 2 ? 64 : 8));
  }
}

TEST_CASE_TEMPLATE(
    "a ray that starts a hair above the sphere knows how thick the hair is, by the hybrid form",
    Real, float, double, long double) {
  for (const long double hair : {1e-1L, 1e-3L, 1e-6L}) {
    const Real start = static_cast<Real>(1 + hair);
    CHECK(ulps(distance_to(hybrid_sphere, Ray<Real>{{0, 0, start}, {0, 0, -1}}),
               widened(start - Real(1))) <= 2);
    CHECK(ulps(distance_to(hybrid_sphere, Ray<Real>{{0, -start, 0}, {0, 1, 0}}),
               widened(start - Real(1))) <= 2);
  }
}

TEST_CASE(
    "the daily exercise's formula in float loses the sphere from far away, and the stable one does "
    "not") {
  const auto wrong_answers = [](const auto& distance_by, double away) {
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto height = static_cast<float>((i + 0.5) / 2000 * 1.1);
      const Ray<float> ray{{0, height, static_cast<float>(away)}, {0, 0, -1}};
      if ((distance_by(unit_sphere, ray) < infinity<float>()) != (height < 1)) ++wrong;
    }
    return wrong;
  };
  const auto daily = [](const Sphere<>& sphere, const Ray<float>& ray) {
    return published::distance_daily(sphere, ray);
  };
  const auto stable = [](const Sphere<>& sphere, const Ray<float>& ray) {
    return distance_to(sphere, ray);
  };
  CHECK(wrong_answers(daily, 10) == 0);
  CHECK(wrong_answers(daily, 1e3) > 0);
  CHECK(wrong_answers(daily, 1e5) > 100);
  CHECK(wrong_answers(stable, 1e5) == 0);

  // And where it hits, it is off by up to a whole radius.
  const Ray<float> ray{{0, 0.5F, 1e5F}, {0, 0, -1}};
  CHECK(static_cast<double>(abs(published::distance_daily(unit_sphere, ray) - 99999.134F)) > 0.5);
  CHECK(static_cast<double>(abs(distance_to(unit_sphere, ray) - 99999.134F)) < 0.01);
}

TEST_CASE_TEMPLATE("the daily exercise's formula agrees with the stable one nearby", Real, float,
                   double, long double) {
  const Real miss = infinity<Real>();
  CHECK(published::distance_daily(unit_sphere, Ray<Real>{{0, 0, 5}, {0, 0, -1}}) == Real(4));
  CHECK(published::distance_daily(unit_sphere, Ray<Real>{{0, 0, 5}, {0, 0, -2}}) == Real(2));
  CHECK(published::distance_daily({{1, 0, 0}, 2}, Ray<Real>{{1, 0, 0}, {0, 1, 0}}) == Real(2));
  CHECK(published::distance_daily(unit_sphere, Ray<Real>{{0, 0, 5}, {0, 0, 1}}) == miss);
  CHECK(published::distance_daily(unit_sphere, Ray<Real>{{0, 2, 5}, {0, 0, -1}}) == miss);
  CHECK(published::distance_daily(unit_sphere, Ray<Real>{{0, 0, Real(1.0005)}, {0, 0, -1}}) >
        Real(1.9));  // its fixed 0.001
}

/// What became of rays that leave a sphere where another ray has met it.
struct Secondaries {
  int hits = 0;       ///< points that were met at all
  int self_hits = 0;  ///< rays outward that met their own sphere
  int lost = 0;       ///< rays inward that found no far side
  /// Lift of the outside point over the true sphere, in unit roundoffs of |center| + 2 radius.
  Exact lowest = 1e30L;
  Exact highest = 0;
  Exact point_off = 0;   ///< distance of the hit point from the true sphere, likewise
  Exact normal_off = 0;  ///< difference of the normal's length from 1, in unit roundoffs
};

template <class Real>
Secondaries trace_secondaries(double radius, double away, int rays) {
  Dice dice;
  Secondaries seen;
  for (int i = 0; i < rays; ++i) {
    const Sphere<> sphere{dice.direction<double>() * away, radius};
    const Point eye =
        sphere.center + dice.direction<double>() * (radius * (3 + 2 * dice.between(-1, 1)));
    const Point aim = sphere.center + dice.direction<double>() * (radius * 0.7);
    const Ray<Real> ray{number_cast<Real>(eye),
                        normalize(number_cast<Real>(aim) - number_cast<Real>(eye))};
    const Real distance = distance_to(sphere, ray);
    if (!(distance < infinity<Real>())) continue;
    ++seen.hits;
    const Hit<Real> hit = hit_at(sphere, ray, distance);

    // The sphere as this number sees it.
    const Vec3<Real> center = number_cast<Real>(sphere.center);
    const auto true_radius = static_cast<Exact>(static_cast<Real>(radius));
    const auto height = [&](const Vec3<Real>& p) {
      const Vec3<Exact> from{widened(p.x) - widened(center.x), widened(p.y) - widened(center.y),
                             widened(p.z) - widened(center.z)};
      return length(from) - true_radius;
    };
    const Exact unit =
        widened(unit_roundoff<Real>()) * (widened(largest(center)) + 2 * true_radius);
    const Exact lift = height(hit.outside);
    seen.lowest = std::min(seen.lowest, lift / unit);
    seen.highest = std::max(seen.highest, lift / unit);
    seen.point_off = std::max(seen.point_off, abs(height(hit.point)) / unit);
    seen.normal_off = std::max(
        seen.normal_off, abs(widened(length(hit.normal)) - 1) / widened(unit_roundoff<Real>()));

    Vec3<Real> outward = number_cast<Real>(dice.direction<double>());
    if (dot(outward, hit.normal) < Real(0)) outward = -outward;
    if (distance_to(sphere, ray_from(hit, outward)) < infinity<Real>()) ++seen.self_hits;
    if (!(distance_to(sphere, ray_from(hit, -outward)) < infinity<Real>())) ++seen.lost;
  }
  return seen;
}

TEST_CASE("a ray from 1e4 radii away leaves its sphere for good, in float") {
  const Ray<float> ray{{1542.07446F, 769.21637F, -8833.47656F},
                       {-.171341956F, -.0854512379F, .981498837F}};
  const Vec3<float> onward{-.327263355F, .554320931F, -.451564074F};
  for (const SphereForm form : {SphereForm::robust, SphereForm::hybrid}) {
    const Sphere<> sphere{{0, 0, 0}, 1, form};
    const Hit<float> hit = hit_at(sphere, ray, distance_to(sphere, ray));
    CHECK(abs(widened(length(hit.normal)) - 1) < 4 * widened(unit_roundoff<float>()));
    CHECK(dot(hit.normal, onward) > 0);
    CHECK(distance_to(sphere, ray_from(hit, onward)) == infinity<float>());
  }
}

TEST_CASE_TEMPLATE("a sphere without a radius is missed by every form, and from everywhere", Real,
                   float, double, long double, Pack<float>) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    for (const double radius : {0.0, -0.0, -1.0, -1e-30, nan}) {
      const Sphere<> sphere{{0, 0, 0}, radius, form};
      for (const Vec3<Real>& origin :
           {Vec3<Real>{}, Vec3<Real>{Real(0), Real(0), Real(3)}, Vec3<Real>{Real(0.5), Real(0)}}) {
        const Ray<Real> ray{origin, {Real(0), Real(0), Real(-1)}};
        CHECK(lane(distance_to(sphere, ray), 0) == infinity<Scalar<Real>>());
      }
    }
  }
}

TEST_CASE("robust gives way to hybrid where it does not hold") {
  struct Object {
    Sphere<> shape;
  };
  const auto chosen = [](double radius, double away, int digits, SphereForm form) {
    std::vector<Object> objects{{{{0, 0, -away}, radius, form}}};
    keep_to_domains(objects, {0, 0, 0}, digits);
    return objects[0].shape.form;
  };
  const SphereForm robust = SphereForm::robust;
  const SphereForm hybrid = SphereForm::hybrid;
  CHECK(chosen(1, 1e4, 24, robust) == robust);
  CHECK(chosen(1, 1.01e4, 24, robust) == hybrid);
  CHECK(chosen(1e3, 1e7, 24, robust) == robust);
  CHECK(chosen(1, 1e7, 53, robust) == robust);
  CHECK(chosen(1, 1.01e7, 53, robust) == hybrid);
  CHECK(chosen(1e30, 2e30, 24, robust) == hybrid);
  CHECK(chosen(1e-30, 2e-30, 24, robust) == hybrid);
  CHECK(chosen(1e30, 2e30, 53, robust) == robust);
  CHECK(chosen(1, 1e9, 24, SphereForm::plain) == SphereForm::plain);
  CHECK(chosen(1, 1, 24, hybrid) == hybrid);

  // Rays start on other objects, too: the large one's far side is 2e6 radii from the small one.
  std::vector<Object> objects{{{{0, 0, 0}, 1e-3}}, {{{0, -1000, 0}, 1e3}}};
  keep_to_domains(objects, {0, 0, 1}, 24);
  CHECK(objects[0].shape.form == hybrid);
  CHECK(objects[1].shape.form == robust);
}

TEST_CASE_TEMPLATE("rays that leave a sphere never meet it, and rays into it find the far side",
                   Real, float, double, long double) {
  const bool in_float = std::is_same_v<Real, float>;
  const int rays = in_float ? 2000 : 10000;
  Secondaries worst;
  for (const double radius : {1e-6, 1e-4, 1e-3, 1.0, 3.0, 1e3, 1e6}) {
    for (const double away : {0.0, 1.0, 1e3, 1e5, 1e7}) {
      CAPTURE(radius);
      CAPTURE(away);
      const Secondaries seen = trace_secondaries<Real>(radius, away, rays);
      CHECK(seen.self_hits == 0);
      worst.lowest = std::min(worst.lowest, seen.lowest);
      worst.highest = std::max(worst.highest, seen.highest);
      // A sphere that is smaller than the grid of floats around it is no sphere.
      if (in_float && away > 1e3 * radius) continue;
      CHECK(seen.hits > rays - 10);
      CHECK(seen.lost == 0);
      worst.point_off = std::max(worst.point_off, seen.point_off);
      worst.normal_off = std::max(worst.normal_off, seen.normal_off);
    }
  }
  MESSAGE("lift from " << static_cast<double>(worst.lowest) << " to "
                       << static_cast<double>(worst.highest) << " unit roundoffs; worst: hit point "
                       << static_cast<double>(worst.point_off) << ", normal "
                       << static_cast<double>(worst.normal_off));
  CHECK(worst.lowest >= 12);
  CHECK(worst.highest <= 20);
  CHECK(worst.point_off <= 4);
  CHECK(worst.normal_off <= 6);
}

TEST_CASE_TEMPLATE(
    "the root ahead is within 2 unit roundoffs of that of its four numbers, and none is ahead of "
    "no "
    "number",
    Real, float, double) {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real a = dice.number<Real>(-10, 10);
    const Real b = static_cast<Real>(dice.sign()) * dice.number<Real>(-10, 10);
    const Real c = static_cast<Real>(dice.sign()) * dice.number<Real>(-20, 20);
    const Real root = dice.number<Real>(-10, 10);
    // From outside, ahead: c over the sum. From inside: the one root above 0.
    const Exact sum = abs(widened(b)) + widened(root);
    const bool ahead = c > 0 ? b > 0 : true;
    const Exact exact = c > 0 || b < 0 ? abs(widened(c)) / sum : sum / widened(a);
    const Real got = root_ahead(a, b, c, root);
    REQUIRE((got < infinity<Real>()) == ahead);
    if (ahead)
      worst = std::max(worst, static_cast<double>(abs(widened(got) / exact - 1) /
                                                  widened(unit_roundoff<Real>())));
  }
  CHECK(worst <= 2);
  if (std::numeric_limits<Exact>::digits > std::numeric_limits<Real>::digits) CHECK(worst > 1.5);
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(root_ahead(Real(0), Real(0), Real(1), Real(0)) == infinity<Real>());
  CHECK(root_ahead(Real(0), Real(0), Real(-1), Real(0)) == infinity<Real>());
  CHECK(root_ahead(Real(1), nan, Real(1), Real(1)) == infinity<Real>());
  CHECK(root_ahead(Real(1), Real(1), Real(1), nan) == infinity<Real>());
}

TEST_CASE_TEMPLATE("all three forms meet an ordinary sphere in the same place, wherever it is",
                   Real, double, long double) {
  Dice dice(5);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point center = dice.direction<double>() * 7.0;
    const double radius = 1.5 + dice.between(-1, 1);
    const Point to_side = dice.direction<double>() * (1.5 * radius);
    const Point eye = center + dice.direction<double>() * (radius + 3);
    const Ray<Real> ray{number_cast<Real>(eye), number_cast<Real>((center + to_side - eye) * 0.25)};
    const Sphere<> robust{center, radius, SphereForm::robust};
    const Vec3<Real> past = ray.origin - number_cast<Real>(center);
    const Real nearest = length(cross(past, ray.direction)) / length(ray.direction);
    if (abs(nearest - Real(radius)) < Real(0.01)) continue;  // there rounding decides
    for (const SphereForm form : {SphereForm::plain, SphereForm::hybrid}) {
      const Sphere<> other{center, radius, form};
      const Real expected = distance_to(robust, ray);
      const Real distance = distance_to(other, ray);
      if (!(expected < infinity<Real>())) {
        REQUIRE(distance == expected);
        continue;
      }
      ++met;
      REQUIRE(abs(distance - expected) <= Real(1e-12) * expected);
      REQUIRE(largest(normal_at(other, ray, distance) - normal_at(robust, ray, expected)) <=
              Real(1e-12));
    }
  }
  CHECK(met > 1000);
  CHECK(met < 3800);
}

TEST_CASE_TEMPLATE(
    "a ray without a direction, or with one that is no number, leaves from outside and meets "
    "nothing",
    Real, float, double, long double) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    const Sphere<> sphere{{0, 0, 0}, 1, form};
    const Hit<Real> hit = hit_at(sphere, Ray<Real>{{0, 0, 5}, {0, 0, -1}}, Real(4));
    for (const Vec3<Real>& direction :
         {Vec3<Real>{}, Vec3<Real>{nan, nan, nan}, Vec3<Real>{0, nan, 0}}) {
      const Ray<Real> ray = ray_from(hit, direction);
      CHECK(ray.origin.z == hit.outside.z);
      CHECK(distance_to(sphere, ray) == infinity<Real>());
    }
  }
}

TEST_CASE_TEMPLATE("a hit has its normal, its point and its lifted point where geometry puts them",
                   Real, float, double, long double) {
  const Sphere<> sphere{{2, 0, -4}, 2};
  const Hit<Real> hit = hit_at(sphere, Ray<Real>{{2, 0, 6}, {0, 0, -2}}, Real(4));
  CHECK(hit.normal.x == Real(0));
  CHECK(hit.normal.y == Real(0));
  CHECK(hit.normal.z == Real(1));
  CHECK(hit.point.x == Real(2));
  CHECK(hit.point.y == Real(0));
  CHECK(hit.point.z == Real(-2));
  CHECK(hit.outside.x == Real(2));
  CHECK(hit.outside.y == Real(0));
  CHECK(hit.outside.z > Real(-2));
  CHECK(hit.outside.z <= Real(-2) + Real(200) * unit_roundoff<Real>());
}

TEST_CASE_TEMPLATE(
    "the normal of a sphere far from the world's origin keeps the digits a texture needs", Real,
    float, double) {
  // Center and origin are whole numbers, so every number type holds them. The ray runs along -z, so
  // Pythagoras gives the rest.
  for (const double away : {0.0, 1e3, 1e6}) {
    Exact worst = 0;
    for (int i = -10; i <= 10; ++i) {
      const Sphere<> sphere{{away, -away, away}, 16};
      const Ray<Real> ray{
          {static_cast<Real>(away + i), static_cast<Real>(-away), static_cast<Real>(away + 64)},
          {0, 0, -1}};
      const Hit<Real> hit = hit_at(sphere, ray, distance_to(sphere, ray));
      const Exact x = i / widened(16);
      worst = std::max(
          {worst, abs(widened(hit.normal.x) - x), abs(widened(hit.normal.z) - sqrt(1 - x * x))});
      REQUIRE(hit.normal.y == Real(0));
    }
    CAPTURE(away);
    MESSAGE("worst: " << static_cast<double>(worst / widened(unit_roundoff<Real>()))
                      << " unit roundoffs");
    CHECK(worst <= 8 * widened(unit_roundoff<Real>()));
  }
}

TEST_CASE_TEMPLATE("a pack meets in each lane what a single ray meets", T, float, double) {
  using Many = Pack<T>;
  const Sphere<> sphere{{0.5, -0.25, 1}, 1.25};
  Dice dice;
  for (int i = 0; i < 500; ++i) {
    const Ray<Many> rays{{any_pack<Many>(dice, -2, 2), Many(0.25), Many(5)},
                         {any_pack<Many>(dice, -0.2, 0.2), Many(0), Many(-1)}};
    check_each_lane<Many>(
        [&sphere]<class Real>(const Ray<Real>& ray) {
          const Real distance = distance_to(sphere, ray);
          const Mask<Real> met = distance < infinity<Real>();
          const Hit<Real> hit = hit_at(sphere, ray, select(met, distance, Real(1)));
          return std::tuple(distance, hit.normal, hit.point, hit.outside);
        },
        rays);
  }
}

TEST_CASE(
    "the inverse of a radius is the number's own quotient, and an interval holds the true one") {
  for (const double radius : {3.0, 0.1, 7e5}) {
    const Sphere<> sphere{{0, 0, 0}, radius};
    CHECK(inverse_radius<float>(sphere) == 1.0F / static_cast<float>(radius));
    CHECK(inverse_radius<double>(sphere) == 1.0 / radius);
    CHECK(prepare<double>(sphere).inverse == 1.0 / radius);
    const Interval inverse = inverse_radius<Interval>(sphere);
    CHECK(std::fma(inverse.low(), radius, -1.0) <= 0);  // exact in its sign
    CHECK(std::fma(inverse.high(), radius, -1.0) >= 0);
    CHECK(inverse.low() < inverse.high());
  }
}

}  // namespace
}  // namespace texmap::test
