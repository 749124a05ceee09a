// The command line: what is read as a number, what is refused, and what the message says.
#include <doctest.h>

#include <string>
#include <vector>

#include "engine/run/command_line.hpp"

using namespace texmap;

namespace {

struct Fruit {
  int count = 3;
  double weight = 0.5;
  std::string name = "apple";
  bool ripe = false;
  int color = 1;
  std::array<double, 2> size{4, 0.5};
};

CommandLine line_for(Fruit& fruit) {
  CommandLine line("fruit", "counts fruit");
  line.whole("--count", fruit.count, 1, 16384, "how many");
  line.decimal("--weight", fruit.weight, -1e300, 1e300, "in kilograms");
  line.text("--name", "NAME", fruit.name, "what it is");
  line.flag("--ripe", fruit.ripe, "it is");
  line.choice<int>("--color", fruit.color, {{"red", 1}, {"green", 2}}, "its color");
  line.pair("--size", "WxH", fruit.size, -10, 10, "in centimeters");
  return line;
}

template <class... Words>
Fruit read(Words... words) {
  Fruit fruit;
  CommandLine line = line_for(fruit);
  const bool goes_on = line.parse({words...});
  CHECK(goes_on);
  return fruit;
}

template <class... Words>
std::string complaint(Words... words) {
  try {
    (void)read(words...);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("two groups may give one option words: each reads its own, and all are listed") {
  int size = 1;
  bool peeled = false;
  CommandLine line("fruit", "what a fruit is like");
  line.choice<int>("--as", size, {{"small", 1}, {"large", 2}}, "how large");
  line.choice<bool>("--as", peeled, {{"whole", false}, {"peeled", true}}, "how it is served");
  REQUIRE(line.parse({"--as", "peeled", "--as", "large"}));
  CHECK(size == 2);
  CHECK(peeled);
  CHECK(line.help().find("--as small|large|whole|peeled") != std::string::npos);
  CHECK(line.help().find("how large; how it is served (default: small)") != std::string::npos);
  for (const char* const wrong : {"", "pee", "small|large", "peeled "}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH_AS(
        (void)line.parse({"--as", wrong}),
        ("--as takes small|large|whole|peeled, not '" + std::string(wrong) + "'").c_str(),
        UsageError);
  }
}

TEST_CASE("a name that is declared twice is an error, unless both have words, and other ones") {
  Fruit fruit;
  const auto twice = [&](const auto& declare) {
    CommandLine line = line_for(fruit);
    CHECK_THROWS_WITH_AS(declare(line), doctest::Contains("is declared twice"), std::logic_error);
  };
  twice([&](CommandLine& line) { line.text("--name", "NAME", fruit.name, "again"); });
  twice([&](CommandLine& line) { line.flag("--ripe", fruit.ripe, "again"); });
  twice([&](CommandLine& line) { line.text("--count", "FILE", fruit.name, "another kind"); });
  twice([&](CommandLine& line) { line.flag("--color", fruit.ripe, "another kind"); });
  twice([&](CommandLine& line) {
    line.choice<int>("--color", fruit.color, {{"blue", 1}, {"green", 2}}, "again");
  });
}

TEST_CASE("an option that does not begin with -- is an error of the program") {
  CommandLine line("fruit", "counts fruit");
  bool ripe = false;
  for (const char* name : {"ripe", "-ripe"})
    CHECK_THROWS_AS(line.flag(name, ripe, "it is"), std::logic_error);
}

TEST_CASE(
    "options are read in any order, with a space or an equals sign, and the last one counts") {
  const Fruit fruit = read("--ripe", "--color", "green", "--count=7", "--weight", "-2.5e-3",
                           "--name=a b=c", "--count", "8");
  CHECK(fruit.ripe);
  CHECK(fruit.color == 2);
  CHECK(fruit.count == 8);
  CHECK(fruit.weight == -2.5e-3);
  CHECK(fruit.name == "a b=c");
}

TEST_CASE("what is no number in the range is refused with the range") {
  for (const char* good : {"1", "16384", "007"}) CHECK(complaint("--count", good).empty());
  for (const char* bad : {"0", "16385", "4.5", "", " 4", "4x", "+4", "99999999999999999999"}) {
    CHECK(complaint("--count", bad) ==
          "--count takes a whole number from 1 to 16384, not '" + std::string(bad) + "'");
  }
  for (const auto& [word, number] :
       {std::pair{"-0.25", -0.25}, {"+3", 3.0}, {".5", 0.5}, {"5.", 5.0}, {"1E-3", 0.001}})
    CHECK(read("--weight", word).weight == number);
  for (const char* bad : {"", "-", "1e", "nan", "-inf", "0x1p3", "1,5", "1 ", "1..2", "1e301"}) {
    CHECK(complaint("--weight", bad) ==
          "--weight takes a number from -1e+300 to 1e+300, not '" + std::string(bad) + "'");
  }
}

TEST_CASE("two numbers are read with the letter between them, and refused with an example") {
  CHECK(read("--size", "-1.5x1e-3").size == std::array{-1.5, 1e-3});
  for (const std::string bad : {"", "3", "3,4"})
    CHECK(complaint("--size", bad) == "--size takes two numbers such as 4x0.5, not '" + bad + "'");
  CHECK(complaint("--size", "3x") ==
        "the second number of --size takes a number from -10 to 10, not ''");
  CHECK(complaint("--size", "11x2x3").starts_with("the first number of --size takes"));
}

TEST_CASE("the message says what is wrong and what would be right") {
  CHECK(complaint("--count") == "--count needs a value: --count N");
  CHECK(complaint("--name", "") == "--name needs a name, and got an empty one");
  CHECK(complaint("--color", "blue") == "--color takes red|green, not 'blue'");
  CHECK(complaint("--colour", "red") == "there is no option --colour");
  CHECK(complaint("--ripe=yes") == "--ripe takes no value");
  CHECK(complaint("pear") == "'pear' is not an option; options begin with --");
  CHECK(complaint("-x") == "there is no option -x");
}

TEST_CASE("the help names every option with its default") {
  Fruit fruit;
  const std::string help = line_for(fruit).help();
  for (const char* part :
       {"--count N", "(default: 3)", "--weight X", "(default: 0.5)", "--name NAME",
        "(default: apple)", "--ripe", "--color red|green", "(default: red)", "--size WxH",
        "(default: 4x0.5)", "--help", "--version", "exit status"}) {
    CAPTURE(part);
    CHECK(help.find(part) != std::string::npos);
  }
}

namespace {

struct Basket {
  std::string first, second;
  int count = 3;
};

template <class... Words>
std::string filled(Basket& basket, Words... words) {
  CommandLine line("basket", "holds two fruits");
  line.positional("FIRST", basket.first, "on the left");
  line.whole("--count", basket.count, 1, 9, "how many");
  line.positional("SECOND", basket.second, "on the right");
  line.statuses("0 it fits; 5 it does not");
  try {
    const bool goes_on = line.parse({words...});
    CHECK(goes_on);
    CHECK(line.was_given("FIRST"));
    CHECK(line.was_given("SECOND"));
  } catch (const UsageError& error) {
    return std::string(error.what()) + "\n" + line.usage();
  }
  return line.help();
}

}  // namespace

TEST_CASE(
    "words without an option are taken in their order; one too few, too many or empty is refused "
    "with the call that would be right") {
  const std::string call = "\nusage: basket FIRST SECOND [options]     (basket --help lists them)";
  Basket basket;
  (void)filled(basket, "pear", "--count", "7", "fig");
  CHECK(basket.first == "pear");
  CHECK(basket.second == "fig");
  CHECK(basket.count == 7);
  CHECK(filled(basket) == "FIRST is missing" + call);
  CHECK(filled(basket, "pear", "--count", "7") == "SECOND is missing" + call);
  CHECK(filled(basket, "pear", "fig", "plum") ==
        "'plum' is not an option; options begin with --" + call);
  CHECK(filled(basket, "pear", "") == "SECOND must not be empty" + call);
  CHECK(filled(basket, "pear", "-fig") == "there is no option -fig" + call);
  const std::string help = filled(basket, "pear", "fig");
  for (const char* part : {"usage: basket FIRST SECOND [options]\n", "FIRST", "on the right",
                           "exit status: 0 it fits; 5 it does not"})
    CHECK(help.find(part) != std::string::npos);
}

TEST_CASE(
    "an option that may be given several times collects its texts in their order, and refuses an "
    "empty one") {
  std::vector<std::string> stones;
  CommandLine line("fruit", "counts fruit");
  line.texts("--stone", "NAME", stones, "may be given several times");
  CHECK(line.parse({"--stone", "plum", "--stone=cherry"}));
  CHECK(stones == std::vector<std::string>{"plum", "cherry"});
  CHECK_THROWS_AS((void)line.parse({"--stone", ""}), UsageError);
  CHECK(line.help().find("--stone NAME") != std::string::npos);
}
