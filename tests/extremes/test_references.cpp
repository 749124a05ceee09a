// Tests of the exact answers: two independent formulas agree, and known values come out.
#include <doctest.h>

#include "references.hpp"
#include "shots.hpp"

namespace texmap::extremes {
namespace {

constexpr int inputs = TEXMAP_EXTREMES_INPUTS / 4;

/// Agreement beyond what any judged number has.
const Digits50 same("1e-30");

TEST_CASE("the units of a number are its own") {
  CHECK(ulp_at<double>(1) == Digits50(std::numeric_limits<double>::epsilon()));
  CHECK(ulp_at<float>(Digits50(1.5)) == Digits50(std::numeric_limits<float>::epsilon()));
  CHECK(ulp_at<double>(0) == Digits50(std::numeric_limits<double>::denorm_min()));
  CHECK(ulp_at<float>(Digits50("1e-60")) == Digits50(std::numeric_limits<float>::denorm_min()));
  CHECK(ulp_at<long double>(2) == 2 * Digits50(std::numeric_limits<long double>::epsilon()));
  CHECK(ulps_off(1.0F, Digits50(1)) == 0);
  CHECK(ulps_off(std::nextafter(1.0F, 2.0F), Digits50(1)) == 1);
  CHECK(ulps_off(std::numeric_limits<double>::quiet_NaN(), Digits50(1)) == infinity<double>());
}

TEST_CASE("(u, v) by angles is (u, v) by inverse cosines") {
  Dice dice(1);
  for (int i = 0; i < inputs; ++i) {
    Vec3<double> p = rounded<double>(dice.direction());
    if (dice.once_in(2)) p.x = p.x * static_cast<double>(dice.power_of_ten(-8, 0));
    if (dice.once_in(2)) p.z = p.z * static_cast<double>(dice.power_of_ten(-8, 0));
    const ExactUv<Digits50> one = exact_uv(exactly(p));
    const ExactUv<Digits100> other = exact_uv_by_acos(exactly<Digits100>(p));
    REQUIRE(around(one.u, Digits50(other.u)) < same);
    REQUIRE(abs(one.v - Digits50(other.v)) < same);
  }
  CHECK(exact_uv(Vec3<Digits50>{1, 0, 0}).u == Digits50(0.5));
  CHECK(abs(exact_uv(Vec3<Digits50>{0, 0, -1}).u - Digits50(0.75)) < same);
}

TEST_CASE("the quadratic equation finds what half chords find, and it lies on the sphere") {
  Dice dice(3);
  int met = 0;
  for (int i = 0; i < inputs; ++i) {
    const Shots shots;
    const Shot<double> shot = draw_shot<double>(dice, shots, draw_shared(dice, shots));
    const ExactMeeting<Digits50> one = shot.meeting();
    const ExactMeeting<Digits100> other =
        exact_meeting_by_chord(exactly<Digits100>(shot.ray.origin),
                               exactly<Digits100>(shot.ray.direction), Digits100(shot.radius));
    REQUIRE(one.meets == other.meets);
    REQUIRE(abs(one.impact - Digits50(other.impact)) < Digits50("1e-25"));
    if (!one.meets) continue;
    ++met;
    REQUIRE(abs(one.distance / Digits50(other.distance) - 1) < Digits50("1e-25"));
    REQUIRE(length(one.normal - exactly(other.normal)) < Digits50("1e-15"));
    REQUIRE(abs(dot(one.normal, one.normal) - 1) < Digits50("1e-25"));
  }
  CHECK(met > inputs / 3);
  CHECK(met < inputs);
}

TEST_CASE("angles reduced in whole numbers have the sines of the unreduced ones") {
  Dice dice(4);
  for (int i = 0; i < inputs; ++i) {
    const auto degrees = static_cast<double>(dice.sign() * dice.power_of_ten(-30, 30));
    const ExactAngle<Digits50> one = exact_angle(degrees);
    const Digits100 radians = Digits100(degrees) * circle<Digits100>() / 180;
    REQUIRE(abs(one.sine - Digits50(sin(radians))) < same);
    REQUIRE(abs(one.cosine - Digits50(cos(radians))) < same);
  }
  CHECK(abs(exact_angle(1e9).sine - exact_angle(280.0).sine) < same);
  CHECK(exact_angle(90.0).cosine == 0);
  CHECK(exact_angle(-720.0).sine == 0);
  CHECK(abs(exact_angle(-30.0).sine + Digits50(0.5)) < same);
}

TEST_CASE("weights by Cramer's rule are weights by areas") {
  Dice dice(5);
  for (int i = 0; i < inputs; ++i) {
    const auto corner = [&dice] { return rounded<double>(dice.direction()); };
    const Vec3<double> a = corner();
    const Vec3<double> b = corner();
    const Vec3<double> c =
        dice.once_in(2) ? rounded<double>({b.x + dice.power_of_ten(-8, 0), b.y, b.z}) : corner();
    const Vec3<double> p = corner();
    const Vec3<Digits50> one = exact_weights(exactly(a), exactly(b), exactly(c), exactly(p));
    const Vec3<Digits100> other = exact_weights_by_areas(
        exactly<Digits100>(a), exactly<Digits100>(b), exactly<Digits100>(c), exactly<Digits100>(p));
    const Digits50 largest = abs(one.x) + abs(one.y) + abs(one.z);
    REQUIRE(texmap::largest(one - exactly(other)) < same * largest);
  }
}

}  // namespace
}  // namespace texmap::extremes
