// Numbers in sentences, of any length.
#include "engine/measure/text.hpp"

#include <doctest.h>

TEST_CASE("a text is what printf prints, however long") {
  CHECK(texmap::text("%d of %s, %.2f %%", 3, "four", 1.005) == "3 of four, 1.00 %");
  CHECK(texmap::text("%s", "").empty());
  const std::string long_one(5000, 'x');
  CHECK(texmap::text("<%s>", long_one.c_str()) == "<" + long_one + ">");
}

TEST_CASE("markup is escaped, each sign once") {
  CHECK(texmap::escaped_markup("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
}
