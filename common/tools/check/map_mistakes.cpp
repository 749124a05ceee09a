// The mistakes with (u, v): wrong forms of u and of v, in chapter 02's convention.
#include "map_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace texmap::check {

namespace {

using Vector = Vec3<double>;
using Law2 = Law<Uv<double>(Vector)>;
constexpr double pi = std::numbers::pi;

Vector times(const Vector& a, const Vector& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// A point as a student's lines see it.
struct Seen {
  Vector p;
  bool limited;  ///< y to -1 and 1, for acos and asin
  double y = limited ? std::clamp(p.y, -1.0, 1.0) : p.y;
  double longitude = std::atan2(-p.z, p.x);
  double from_south = std::acos(-y);
  double u = 0.5 + longitude / (2 * pi);
  double v = from_south / pi;
};

constexpr const char* no_half =
    "the 1/2 is missing in u (in C++ 1 / 2 is 0, so write 0.5): u can be negative";
constexpr const char* no_half_in_v =
    "v is 0 on the equator, and has to be 1/2 there: add 0.5 (in C++ 1 / 2 is 0)";
constexpr const char* precedence = "C++ reads a / 2 * pi as (a / 2) * pi: write a / (2 * pi)";
constexpr const char* exchanged =
    "the arguments of atan2 are exchanged: z comes first, the sine's side";
constexpr const char* upward = "y goes up: the longitude is an angle between x and z";
constexpr const char* radians = "the angles are not divided by 2 pi and pi: they are in radians";
constexpr const char* degrees = "the angles are in radians: a whole turn is 2 pi, not 360";
constexpr const char* whole =
    "u and v are parts of 1, not degrees: divide by 2 pi and by pi instead";
constexpr const char* half_turn =
    "u is 0 on +x, where it has to be 1/2: the map is turned by half a turn";
constexpr const char* axis = "y is the axis from pole to pole: v comes from y";
constexpr const char* quotient =
    "std::atan sees only the quotient z / x, half of the globe: use std::atan2";

/// A wrong u or v, with its word.
struct Form {
  const char* word;
  double (*number)(const Seen&);
};

constexpr Form forms_of_u[] = {
    {no_half, [](const Seen& s) { return s.longitude / (2 * pi); }},
    {"1/2 is added, not subtracted: u can be negative",
     [](const Seen& s) { return s.longitude / (2 * pi) - 0.5; }},
    {precedence, [](const Seen& s) { return 0.5 + s.longitude / 2 * pi; }},
    {precedence, [](const Seen& s) { return s.longitude / 2 * pi; }},
    {precedence, [](const Seen& s) { return (s.longitude + pi) / 2 * pi; }},
    {"u is in radians: divide the angle by 2 pi, then add 1/2",
     [](const Seen& s) { return s.longitude; }},
    {"u is in radians: divide the angle by 2 pi, then add 1/2",
     [](const Seen& s) { return s.longitude + 0.5; }},
    {"u is in radians: divide the angle by 2 pi, then add 1/2",
     [](const Seen& s) { return s.longitude + pi; }},
    {"only the angle is divided: write (angle + pi) / (2 * pi), or angle / (2 * pi) + 0.5",
     [](const Seen& s) { return pi + s.longitude / (2 * pi); }},
    {degrees, [](const Seen& s) { return 0.5 + s.longitude / 360; }},
    {degrees, [](const Seen& s) { return s.longitude / 360; }},
    {"u is divided by pi: the map goes around twice",
     [](const Seen& s) { return 0.5 + s.longitude / pi; }},
    {exchanged, [](const Seen& s) { return 0.5 + std::atan2(s.p.x, s.p.z) / (2 * pi); }},
    {exchanged, [](const Seen& s) { return 0.5 - std::atan2(s.p.x, s.p.z) / (2 * pi); }},
    {exchanged, [](const Seen& s) { return std::atan2(s.p.x, s.p.z) / (2 * pi); }},
    {half_turn, [](const Seen& s) { return s.u < 0.5 ? s.u + 0.5 : s.u - 0.5; }},
    {half_turn, [](const Seen& s) { return 0.5 + std::atan2(-s.p.z, -s.p.x) / (2 * pi); }},
    {"u is 1/2 everywhere: in C++ 1 / 2 is 0, and 0 times the angle is 0",
     [](const Seen&) { return 0.5; }},
    {upward, [](const Seen& s) { return 0.5 - std::atan2(s.p.y, s.p.x) / (2 * pi); }},
    {upward, [](const Seen& s) { return 0.5 + std::atan2(s.p.x, -s.p.y) / (2 * pi); }},
    {upward, [](const Seen& s) { return 0.5 + std::atan2(-s.p.z, -s.p.y) / (2 * pi); }},
    {upward, [](const Seen& s) { return 0.5 + std::atan2(s.p.y, s.p.x) / (2 * pi); }},
    {upward, [](const Seen& s) { return 0.5 + std::atan2(s.p.x, s.p.y) / (2 * pi); }},
    {upward, [](const Seen& s) { return 0.5 + std::atan2(-s.p.z, s.p.y) / (2 * pi); }},
    {quotient, [](const Seen& s) { return 0.5 + std::atan(-s.p.z / s.p.x) / (2 * pi); }},
    {quotient, [](const Seen& s) { return 0.5 + std::atan(-s.p.z / s.p.x) / pi; }},
};

constexpr Form forms_of_v[] = {
    {no_half_in_v, [](const Seen& s) { return std::asin(s.y) / pi; }},
    {"v is in radians: divide the angle by pi", [](const Seen& s) { return s.from_south; }},
    {degrees, [](const Seen& s) { return s.from_south / 180; }},
    {degrees, [](const Seen& s) { return 0.5 + std::asin(s.y) / 180; }},
    {"acos runs from 0 to pi: divide v by pi, not by 2 pi",
     [](const Seen& s) { return s.from_south / (2 * pi); }},
    {"asin runs from -pi/2 to pi/2: divide v by pi, not by 2 pi",
     [](const Seen& s) { return 0.5 + std::asin(s.y) / (2 * pi); }},
    {"v grows with the angle, not with the height y: take acos or asin",
     [](const Seen& s) { return (s.p.y + 1) / 2; }},
    {"v grows with the angle, not with the height y: take acos or asin",
     [](const Seen& s) { return s.p.y; }},
    {axis, [](const Seen& s) { return std::acos(std::clamp(s.p.x, -1.0, 1.0)) / pi; }},
    {axis, [](const Seen& s) { return std::acos(std::clamp(-s.p.x, -1.0, 1.0)) / pi; }},
    {axis, [](const Seen& s) { return std::acos(std::clamp(s.p.z, -1.0, 1.0)) / pi; }},
    {axis, [](const Seen& s) { return std::acos(std::clamp(-s.p.z, -1.0, 1.0)) / pi; }},
    {"limit y to -1 and 1, not to 0 and 1: half of the globe has negative y",
     [](const Seen& s) { return std::acos(std::clamp(-s.p.y, 0.0, 1.0)) / pi; }},
    {"acos gives no negative angle: the minus belongs to y, acos(-y)",
     [](const Seen& s) { return -s.from_south / pi; }},
    {"the square root is missing in v: the distance from the axis is sqrt(x * x + z * z)",
     [](const Seen& s) { return std::atan2(s.p.x * s.p.x + s.p.z * s.p.z, -s.p.y) / pi; }},
};

/// Mistakes in u and in v at once, which have one cause.
struct FormOfBoth {
  const char* word;
  Uv<double> (*place)(const Seen&);
};

constexpr FormOfBoth forms_of_both[] = {
    {whole,
     [](const Seen& s) {
       return Uv<double>{s.longitude * 180 / pi, s.from_south * 180 / pi};
     }},
    {whole,
     [](const Seen& s) {
       return Uv<double>{0.5 + s.longitude * 180 / pi, s.from_south * 180 / pi};
     }},
    {"u and v are exchanged",
     [](const Seen& s) {
       return Uv<double>{s.v, s.u};
     }},
    {radians,
     [](const Seen& s) {
       return Uv<double>{s.longitude, s.from_south};
     }},
    {radians,
     [](const Seen& s) {
       return Uv<double>{0.5 + s.longitude, s.from_south};
     }},
    {degrees,
     [](const Seen& s) {
       return Uv<double>{0.5 + s.longitude / 360, s.from_south / 180};
     }},
    {no_half,
     [](const Seen& s) {
       return Uv<double>{s.longitude / (2 * pi), std::asin(s.y) / pi};
     }},
};

}  // namespace

void add_map_mistakes(Law2& law, const Vector& signs) {
  // Those who make another mistake often have a sign wrong or do not limit y, too.
  for (const Vector& wrong_signs :
       {Vector{1, 1, 1}, Vector{1, 1, -1}, Vector{1, -1, 1}, Vector{1, -1, -1}}) {
    const auto add = [&](const char* word, auto place) {
      for (const bool limited : {true, false}) {
        law.mistakes.push_back({word, [=](const Vector& p) {
                                  return place(Seen{times(times(p, signs), wrong_signs), limited});
                                }});
      }
    };
    for (const FormOfBoth& form : forms_of_both) add(form.word, form.place);
    for (const Form& form : forms_of_u) {
      add(form.word, [=](const Seen& s) { return Uv<double>{form.number(s), s.v}; });
    }
    for (const Form& form : forms_of_v) {
      add(form.word, [=](const Seen& s) { return Uv<double>{s.u, form.number(s)}; });
    }
  }
}

}  // namespace texmap::check
