// The trade of a picture: what is said of ways whose differences and times are known.
#include "engine/compare/trade.hpp"

#include <doctest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

using texmap::Image, texmap::Rgb8, texmap::Way;

/// 4 x 3 pixels; the second has so much more red.
Image picture(int red = 0) {
  Image image(4, 3, {100, 100, 100});
  image.pixels[1].r = static_cast<std::uint8_t>(100 + red);
  return image;
}

/// A way that took so many milliseconds.
Way took(const std::string& words, double milliseconds, int levels) {
  return {words, {}, {milliseconds, milliseconds, 1}, levels > 0 ? 1U : 0U, levels, levels / 6.0};
}

}  // namespace

TEST_CASE("each way is compared with the right picture, and timed") {
  std::vector<texmap::TradePart> parts{
      {"a part: for a test",
       [] { return picture(); },
       {{"--number double", [] { return picture(); }}, {"--budget b", [] { return picture(6); }}}}};
  int last = 0, all = 0;
  texmap::measure_trade(parts, 0, [&](int done, int of) { last = done, all = of; });
  CHECK(last == all);
  CHECK(all > 0);
  const Way &same = parts[0].ways[0], &other = parts[0].ways[1];
  CHECK((same.changed == 0 && same.levels == 0 && same.error == 0));
  CHECK((other.changed == 1 && other.levels == 6));
  CHECK(other.error == doctest::Approx(6 / std::sqrt(36.0)));  // one of 36 channels
  CHECK((same.took.processor >= 0 && other.took.processor < 1e9));
}

TEST_CASE("the fastest way is recommended that changes nothing, then by one level, then by four") {
  texmap::TradePart part{"a part", {}, {took("--number double", 10, 0), took("--packs", 5, 0)}};
  const auto recommended = [&] { return recommendation(part, "./course run 03"); };
  CHECK(recommended() == "  the same picture, 2.0 times as fast:\n    ./course run 03 --packs\n");
  part.ways.push_back(took("--one", 4.9, 1));  // too little faster to be told from the packs
  CHECK(recommended().find("--one") == std::string::npos);
  part.ways.push_back(took("--two", 2, 2));
  part.ways.push_back(took("--nine", 1, 9));
  CHECK(
      recommended().ends_with("seen: off by 4 levels or less, 5.0 times as fast:\n"
                              "    ./course run 03 --two\n"));
  part.ways = {took("--number double", 10, 0), took("--packs", 9.6, 0)};
  CHECK(recommended() == "  the same picture: nothing that was tried saves 5 %\n");
  // Where all differ from the right one: those that no other beats.
  part.ways = {took("--one", 1, 9), took("--four", 4, 3), took("--slow", 5, 3),
               took("--bad", 4.5, 6), took("--best", 9, 1)};
  CHECK(recommended().ends_with(":\n    --one\n    --four\n    --best\n"));
}

TEST_CASE("the table and the plot have each way") {
  const texmap::TradePart part{
      "a part: for a test",
      {},
      {took("--number double", 10, 0), took("--number float-pack --instructions avx2", 2.5, 6)}};
  const std::string table = table_of(part, "./course run 03");
  CHECK(table.find("--number float-pack --instructions avx2       2.5    0.25           1          "
                   "6             1.000\n") != std::string::npos);
  CHECK(table.find("busy") == std::string::npos);
  const std::string plot = texmap::plot_of({part}, "./course run 03");
  CHECK(plot.find(">float-pack avx2<") != std::string::npos);
  CHECK(plot.find(">double<") != std::string::npos);
  CHECK(plot.find(">a part<") != std::string::npos);
}
