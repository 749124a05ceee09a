// Numbers in sentences, of any length.
#include "engine/measure/text.hpp"

#include <doctest.h>

#include <clocale>
#include <cstdlib>

TEST_CASE("a text is what printf prints, however long") {
  CHECK(texmap::text("%d of %s, %.2f %%", 3, "four", 1.005) == "3 of four, 1.00 %");
  CHECK(texmap::text("%s", "").empty());
  const std::string long_one(5000, 'x');
  CHECK(texmap::text("<%s>", long_one.c_str()) == "<" + long_one + ">");
}

TEST_CASE("markup is escaped, each sign once") {
  CHECK(texmap::escaped_markup("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
}

TEST_CASE("a number is as short as it can be, with a point in any locale, and reads back") {
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  if (set == nullptr)
    MESSAGE("the locale de_DE.UTF-8 is not installed: only the C locale was tried");
  CHECK(texmap::round_trip(0) == "0");
  CHECK(texmap::round_trip(0.1) == "0.1");
  CHECK(texmap::round_trip(-0.25) == "-0.25");
  CHECK(texmap::round_trip(1.0 / 3) == "0.3333333333333333");
  std::setlocale(LC_ALL, "C");
  double value = 1;
  for (int i = 0; i < 2000; ++i) {
    value *= -1.37;
    REQUIRE(std::strtod(texmap::round_trip(value).c_str(), nullptr) == value);
  }
}
