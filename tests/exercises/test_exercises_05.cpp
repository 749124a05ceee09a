// The exercises of chapter 05, and what strangers write for them.
#include "solutions/05.hpp"

const std::vector<double> texmap::test::answers{45, 90};

// p after a turn from the first axis to the second, in radians.
static V turn(V p, V first, V second, D w) {
  const D x = dot(p, first), y = dot(p, second);
  return p + first * (x * cos(w) - y * sin(w) - x) + second * (x * sin(w) + y * cos(w) - y);
}
static V about_y(V p, D w) { return turn(p, {0, 0, 1}, {1, 0, 0}, w); }
static V about_x(V p, D w) { return turn(p, {0, 1, 0}, {0, 0, 1}, w); }
static V about_z(V p, D w) { return turn(p, {1, 0, 0}, {0, 1, 0}, w); }

TEST_CASE("05: strangers' answers get their words") {
  turned("for radians", [](V p, D degrees) { return about_x(p, degrees); });
  turned("", [](V p, D degrees) { return about_x(p, int(degrees) / 180. * pi); });
  turned("digits", [](V p, D degrees) { return about_x(p, degrees / 180 * 3.14159); });
  turned("exchanged", [](V p, D degrees) { return about_x(p, pi / 2 - degrees / 180 * pi); });
  turned("about the y axis", [](V p, D degrees) { return about_y(p, degrees / 180 * pi); });
  turned("for radians", [](V p, D degrees) { return about_x(p, -degrees); });  // and the other way

  const auto by_longitude = [](const char* text, auto angle) {  // of what the eye faces
    angle_to_show(text, [=](D longitude, V eye) {
      return angle(longitude, atan2(-eye.z, eye.x) / pi * 180);
    });
  };
  by_longitude("moves the other way", [](D wanted, D faced) { return faced - wanted; });
  by_longitude("always on +z", [](D wanted, D faced) { return wanted - -90; });
  by_longitude("subtract the eye", [](D wanted, D faced) { return wanted + faced + 360; });
  angle_to_show.right([](D longitude, V eye) {  // by the turn from the eye to the place
    const V to{cos(longitude * pi / 180), 0, -sin(longitude * pi / 180)};
    return 360 + atan2(cross(eye, to).y, eye.x * to.x + eye.z * to.z) / pi * 180;
  });

  looked_up("for radians", [](V p, D lean, D turn) { return about_y(about_z(p, lean), turn); });
  const auto by_radians = [](const char* text, auto look) {
    looked_up(text, [=](V p, D lean, D turn) { return look(p, lean / 180 * pi, turn / 180 * pi); });
  };
  by_radians("turn of x and y", [](V p, D a, D b) { return about_y(p, a + b); });
  by_radians("turn comes first", [](V p, D a, D b) { return about_z(about_y(p, b), a); });
  by_radians("to the left", [](V p, D a, D b) { return about_y(about_z(p, -a), b); });
  by_radians("turn the direction that is looked up",
             [](V p, D a, D b) { return about_y(about_z(p, a), -b); });
  by_radians("comes back", [](V p, D a, D b) { return about_z(about_y(about_z(p, a), b), -a); });
}

TEST_CASE("where no mistake fits, it is said which numbers are right") {
  const std::function<V(V, D)> noise = [](V p, D degrees) { return V{p.x, degrees, NAN}; };
  const auto& turned_exercise = texmap::check::exercises_of_chapter().exercises[0];
  CHECK(turned_exercise.verdict(noise).fact.find("(NaN)") != std::string::npos);
  const std::function<V(V, D)> wrong = [](V p, D degrees) { return V{p.x, degrees, p.z + 1}; };
  CHECK(turned_exercise.verdict(wrong).fact == "right at every place: x; wrong: y z");
  const std::function<V(V, D)> twice = [](V p, D degrees) {
    return 2 * about_x(p, degrees / 180 * pi);
  };
  CHECK(turned_exercise.verdict(twice).fact == "2 times the right value at every place");
}

TEST_CASE("what happens to any vector needs no row") {
  const auto by_right = [](const char* text, auto change) {
    turned(text, [=](V p, D degrees) { return change(about_x(p, degrees / 180 * pi)); });
  };
  by_right("x and z are exchanged", [](V q) { return V{q.z, q.y, q.x}; });
  by_right("z is a copy of x", [](V q) { return V{q.x, q.y, q.x}; });
  by_right("y is missing", [](V q) { return V{q.x, 0, q.z}; });
  by_right("the sign of x is wrong; and y is a copy of x", [](V q) { return V{-q.x, q.x, q.z}; });
}
