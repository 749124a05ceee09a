// Tests of engine/draw/lesson.hpp and chosen.hpp: what a lesson states and its user is offered.
#include <doctest.h>

#include <functional>
#include <string>

#include "engine/run/run_chapter.hpp"

namespace texmap::test {
namespace {

/// What a lesson's user is offered, before anything is typed.
struct Started {
  CommandLine line{"lesson", ""};
  Chosen chosen;

  explicit Started(
      const About& about, const std::function<void(Offer&)>& more = [](Offer&) {})
      : chosen("99_lesson", offered(line, more), about) {}
  static Offer offered(CommandLine& line, const std::function<void(Offer&)>& more) {
    Offer offer{.line = line};
    more(offer);
    return offer;
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
  const Started sheet({.idea = "an idea"}, [](Offer& offer) {
    offer.camera = false;
    offer.surfaces = true;
    offer.budget = "how far off";
  });
  CHECK_FALSE(sheet.offers("--samples"));
  CHECK_FALSE(sheet.offers("--number"));
  CHECK_FALSE(sheet.offers("--at"));
  CHECK(sheet.offers("--budget"));
  CHECK(sheet.offers("--show color|normal|uv|object"));
  const Started waves({.idea = "an idea", .numbers = Numbers::no_intervals});
  CHECK(waves.offers("float-pack"));
  CHECK(waves.offers("not interval: they have no sin"));
  CHECK_FALSE(waves.offers("|interval"));
  const Started single({.idea = "an idea", .numbers = Numbers::single});
  CHECK(single.offers("extended"));
  CHECK_FALSE(single.offers("float-pack"));
  CHECK(single.chosen.settings.number == NumberKind::double_);
  CHECK_FALSE(Started({.idea = "an idea", .numbers = Numbers::only_double}).offers("--number"));
}

TEST_CASE("a budget is read with the line, and refused before anything is loaded") {
  Started started({.idea = "an idea"}, [](Offer& offer) { offer.budget = "how far off"; });
  CHECK(started.chosen.settings.budget.is_exact());
  REQUIRE(started.line.parse({"--budget", "levels=2"}));
  CHECK(started.chosen.settings.budget.limit == 2);
  CHECK_THROWS_AS(static_cast<void>(started.line.parse({"--budget", "levels"})), UsageError);
}

}  // namespace
}  // namespace texmap::test
