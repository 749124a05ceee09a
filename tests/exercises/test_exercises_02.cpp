// The exercises of chapter 02: each fails as shipped, its solution passes, each known mistake
// gets its word.
#include <doctest.h>

#include "exercise.hpp"
#include "support/exercise_checks.hpp"

namespace start_1 {
#include "starts/02_1.hpp"
}
namespace solution_1 {
#include "exercises/02_1.hpp"
}
namespace start_2 {
#include "starts/02_2.hpp"
}
namespace solution_2 {
#include "exercises/02_2.hpp"
}
namespace start_3 {
#include "starts/02_3.hpp"
}
namespace solution_3 {
#include "exercises/02_3.hpp"
}

using namespace texmap::test;

TEST_CASE("02.1: where on the map") {
  check_start("02.1", start_1::uv_of);
  check_solution("02.1", solution_1::uv_of);

  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(p.z, p.x) / (2 * pi) + 0.5, std::acos(-p.y) / pi};
      },
      "mirrored");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, std::acos(std::clamp(p.y, -1., 1.)) / pi};
      },
      "upside down");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi) + 0.5, std::acos(-p.y) / pi};
      },
      "beyond 1 at the pole");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x) / (2 * pi), std::asin(std::clamp(p.y, -1., 1.)) / pi + 0.5};
      },
      "half is missing");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::atan2(-p.z, p.x), std::acos(-p.y)};
      },
      "radians");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{std::acos(std::clamp(-p.y, -1., 1.)) / pi,
                  std::atan2(-p.z, p.x) / (2 * pi) + 0.5};
      },
      "exchanged");
  check_mistake(
      "02.1",
      +[](Vec3 p) {
        return Uv{0.5 - std::atan2(p.z, p.x) / 360, std::acos(std::clamp(-p.y, -1., 1.)) / 180};
      },
      "not 360");
  check_unknown(
      "02.1", +[](Vec3 p) {
        return Uv{p.x, p.z};
      });
}

TEST_CASE("02.2: which square") {
  check_start("02.2", start_2::is_first_color);
  check_solution("02.2", solution_2::is_first_color);

  check_mistake(
      "02.2", +[](Uv uv, int squares) { return static_cast<int>(uv.u * squares) % 2 == 0; },
      "stripes");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) + static_cast<int>(uv.v * squares)) % 2 != 0;
      },
      "exchanged");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) + static_cast<int>(uv.v * squares)) % 2 == 0;
      },
      "v = 1");
  check_mistake(
      "02.2",
      +[](Uv uv, int squares) {
        return (static_cast<int>(uv.u * squares) * static_cast<int>(uv.v * squares)) % 2 == 0;
      },
      "added");
}

TEST_CASE("02.3: square squares") {
  check_start("02.3", start_3::twice_around);
  check_solution("02.3", solution_3::twice_around);

  check_mistake(
      "02.3",
      +[](Uv uv) {
        return Uv{2 * uv.u, 2 * uv.v};
      },
      "v");
  check_mistake(
      "02.3",
      +[](Uv uv) {
        return Uv{uv.u / 2, uv.v};
      },
      "once in two turns");
}

TEST_CASE("the questions of chapter 02 have the answers of its page") {
  check_answer("02.a", 60);
  check_answer("02.b", 80);
}
