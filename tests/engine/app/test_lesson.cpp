// Tests of engine/app/lesson.hpp and session.hpp: what a lesson states and its user is offered.
#include <doctest.h>

#include <string>

#include "engine/app/run_chapter.hpp"

namespace texmap::test {
namespace {

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
  const Started waves({.idea = "an idea", .numbers = Numbers::no_intervals});
  CHECK(waves.offers("float-pack"));
  CHECK(waves.offers("not interval: they have no sin"));
  CHECK_FALSE(waves.offers("|interval"));
  const Started single({.idea = "an idea", .numbers = Numbers::single});
  CHECK(single.offers("extended"));
  CHECK_FALSE(single.offers("float-pack"));
  CHECK(single.session.settings.number == NumberKind::double_);
  CHECK_FALSE(Started({.idea = "an idea", .numbers = Numbers::only_double}).offers("--number"));
}

}  // namespace
}  // namespace texmap::test
