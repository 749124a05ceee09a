// Tests of engine/app/lesson.hpp and session.hpp: what a lesson states and its user is offered.
#include <doctest.h>

#include <string>

#include "engine/app/run_chapter.hpp"

namespace texmap::test {
namespace {

TEST_CASE("a set of objects contains those that were named, and no others") {
  constexpr ObjectSet none;
  constexpr ObjectSet some{0, 3, 31};
  for (int i = 0; i < 32; ++i) {
    CHECK_FALSE(none.contains(i));
    CHECK(some.contains(i) == (i == 0 || i == 3 || i == 31));
  }
  static_assert(ObjectSet{2, 2}.contains(2) && !ObjectSet{2, 2}.contains(1));
}

/// The session of a lesson, as its program has it before anything is typed.
struct Started {
  CommandLine line{"lesson", ""};
  Session session;

  explicit Started(const About& about, const Offers& offers = {}, const GroupWishes& wishes = {})
      : session("99_lesson", wished(line, wishes), about, offers) {}
  static CommandLine& wished(CommandLine& line, const GroupWishes& wishes) {
    line.wishes = wishes;
    return line;
  }
  [[nodiscard]] bool offers(const std::string& words) const {
    return line.help().find(words) != std::string::npos;
  }
};

TEST_CASE("a session begins with the lesson's size and samples, unless the user chose others") {
  Started own({.idea = "an idea", .size = {400, 225}}, {}, {.samples = 100});
  CHECK(own.session.settings.samples == 100);
  CHECK(own.session.settings.number == default_number);
  CHECK(own.session.settings.out == "out/99_lesson.png");
  CHECK(own.offers("(default: 225)"));
  CHECK(own.offers("(default: 100)"));
  REQUIRE(own.line.parse({"--width", "640"}));
  own.session.default_size(200, 100);
  CHECK(own.session.settings.width == 640);
  CHECK(own.session.settings.height == 100);
}

TEST_CASE("a lesson offers what its code runs with, and not what it goes without") {
  const Started usual({.idea = "an idea"});
  CHECK(usual.offers("--samples"));
  CHECK(usual.offers("float-pack"));
  CHECK(usual.offers("--at COLUMN,ROW"));
  CHECK_FALSE(usual.offers("--budget"));
  CHECK_FALSE(usual.offers("--show"));
  const Started about({.idea = "an idea", .without = {"--samples", "--zoom"}}, {.surfaces = true},
                      {.budget = "how far off"});
  CHECK_FALSE(about.offers("--samples"));
  CHECK_FALSE(about.offers("--at"));
  CHECK(about.offers("--budget"));
  CHECK(about.offers("--show color|normal|uv|object"));
  const Started single({.idea = "an idea", .numbers = Numbers::single});
  CHECK(single.offers("extended"));
  CHECK_FALSE(single.offers("float-pack"));
  CHECK(single.session.settings.number == NumberKind::double_);
  CHECK_FALSE(Started({.idea = "an idea", .numbers = Numbers::only_double}).offers("--number"));
}

}  // namespace
}  // namespace texmap::test
