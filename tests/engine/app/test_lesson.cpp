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

TEST_CASE("a session begins with the lesson's size and samples, and the help shows them") {
  const Started usual({.idea = "an idea"});
  CHECK(usual.session.settings.width == 800);
  CHECK(usual.session.settings.height == 600);
  CHECK(usual.session.settings.samples == 1);
  CHECK(usual.session.settings.number == default_number);
  CHECK(usual.session.settings.out == "out/99_lesson.png");
  const Started own({.idea = "an idea", .size = {400, 225}}, {}, {.samples = 100});
  CHECK(own.session.settings.width == 400);
  CHECK(own.session.settings.height == 225);
  CHECK(own.session.settings.samples == 100);
  CHECK(own.offers("(default: 225)"));
  CHECK(own.offers("(default: 100)"));
}

TEST_CASE("options that a lesson goes without are not offered") {
  const About about{.idea = "an idea", .without = {"--samples", "--number"}};
  CHECK(Started({.idea = "an idea"}).offers("--samples"));
  CHECK_FALSE(Started(about).offers("--samples"));
  CHECK_FALSE(Started(about).offers("--number"));
  CHECK(Started(about).offers("--threads"));
  CHECK_FALSE(Started(about).offers("--budget"));
  CHECK(Started(about, {}, {.budget = "how far off"}).offers("--budget"));
  CHECK_FALSE(Started(about).offers("--show"));
  CHECK(Started(about, {.surfaces = true}).offers("--show color|normal|uv|object"));
  CHECK_FALSE(Started({.idea = "an idea", .without = {"--zoom"}}).offers("--at"));
  CHECK(Started(about).offers("--at COLUMN,ROW"));
}

TEST_CASE("numbers are offered as far as the lesson's code runs with them") {
  const auto words = [](Numbers numbers) {
    return Started({.idea = "an idea", .numbers = numbers}).line.help();
  };
  CHECK(words(Numbers::all).find("float-pack") != std::string::npos);
  CHECK(words(Numbers::single).find("extended") != std::string::npos);
  CHECK(words(Numbers::single).find("float-pack") == std::string::npos);
  CHECK(words(Numbers::only_double).find("--number") == std::string::npos);
  CHECK(Started({.idea = "", .numbers = Numbers::single}).session.settings.number ==
        NumberKind::double_);
}

TEST_CASE("a chapter's own size holds unless the user chose another") {
  Started started({.idea = "an idea"});
  REQUIRE(started.line.parse({"--width", "640"}));
  started.session.default_size(400, 200);
  CHECK(started.session.settings.width == 640);
  CHECK(started.session.settings.height == 200);
  CHECK(started.session.was_given("--width"));
  CHECK_FALSE(started.session.was_given("--height"));
}

}  // namespace
}  // namespace texmap::test
