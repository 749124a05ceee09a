// Tests of common/sampling/cumulative_table.hpp: every thing is drawn as often as it weighs.
#include "sampling/cumulative_table.hpp"

#include <doctest.h>

#include <cmath>

namespace texmap::test {
namespace {

constexpr double whole = CumulativeTable::steps;

std::vector<double> random_weights(std::size_t count, double contrast) {
  std::vector<double> weights;
  std::uint32_t state = 5;
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 1664525U + 1013904223U;
    weights.push_back(std::pow(static_cast<double>(state >> 8) * 0x1p-24, contrast));
  }
  weights[count / 3] = 0;
  return weights;
}

const std::vector<std::vector<double>> lists = {
    {1},
    {1, 3},
    {0, 0, 5, 0, 0},
    {3, 0, 1, 10, 2},
    std::vector<double>(1000, 0.1),
    std::vector<double>(1 << 12, 7e-320),
    {1e-300, 1, 1e-300},
    {1, 1e300, 0, 1},
    random_weights(3000, 1),
    random_weights(3001, 60),
};

}  // namespace

TEST_CASE("a thing has as many of the 2^24 numbers as it weighs, and one at least if it weighs") {
  for (const std::vector<double>& weights : lists) {
    const CumulativeTable table(weights);
    long double total = 0;  // of products of whole numbers and doubles: 64 bits hold enough
    long double with_weight = 0;
    for (const double weight : weights) {
      total += static_cast<long double>(weight);
      with_weight += weight > 0 ? 1 : 0;
    }
    std::uint32_t all = 0;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
      const std::uint32_t steps = table.steps_of(i);
      all += steps;
      if (weights[i] == 0) CHECK(steps == 0);
      if (weights[i] == 0) continue;
      const long double share = (static_cast<long double>(whole) - with_weight) *
                                (static_cast<long double>(weights[i]) / total);
      CHECK(std::abs(static_cast<double>(steps - 1 - share)) < 1.0001);
      CHECK(steps >= 1);
    }
    CHECK(all == CumulativeTable::steps);
  }
}

TEST_CASE(
    "what a number draws is what a search from the start finds, at every edge and beside it") {
  for (const std::vector<double>& weights : lists) {
    const CumulativeTable table(weights);
    const auto searched = [&](std::uint32_t step) {
      std::uint32_t thing = 0;
      for (std::uint32_t sum = table.steps_of(0); sum <= step; sum += table.steps_of(++thing)) {
      }
      return thing;
    };
    std::uint32_t edge = 0;
    for (std::uint32_t i = 0; i < weights.size(); edge += table.steps_of(i++)) {
      for (const std::uint32_t step : {edge - 1, edge, edge + 1}) {  // 0 - 1 is beyond the line
        if (step >= CumulativeTable::steps) continue;
        const CumulativeTable::Drawn drawn = table.draw(step / whole);
        REQUIRE(drawn.thing == searched(step));
        REQUIRE(weights[drawn.thing] > 0);
        REQUIRE(drawn.place > 0);
        REQUIRE(drawn.place < 1);
      }
    }
    CHECK(table.draw(0).thing == searched(0));
    CHECK(table.draw(1 - 0x1p-24).thing == searched(CumulativeTable::steps - 1));
  }
}

TEST_CASE("all numbers of a thing together lie evenly across it, and in the order of the numbers") {
  const CumulativeTable table(std::vector<double>{3, 0, 1, 10, 2});
  std::vector<double> count(5, 0), places(5, 0);
  double before = 0;
  for (std::uint32_t step = 0; step < CumulativeTable::steps; ++step) {
    const CumulativeTable::Drawn drawn = table.draw(step / whole);
    REQUIRE(drawn.thing + drawn.place > before);
    before = drawn.thing + drawn.place;
    count[drawn.thing] += 1;
    places[drawn.thing] += drawn.place;
  }
  for (const std::uint32_t i : {0U, 2U, 3U, 4U}) {
    CHECK(count[i] == table.steps_of(i));
    CHECK(places[i] / count[i] == doctest::Approx(0.5).epsilon(1e-9));
  }
  CHECK(count[1] == 0);
}

TEST_CASE("weights by which nothing can be drawn are refused") {
  CHECK(CumulativeTable().draw(0.99).thing == 0);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& weights : std::vector<std::vector<double>>{
           {}, {0, 0}, {1, -1}, {1, std::nan("")}, {1, infinite}, {1e308, 1e308}})
    CHECK_THROWS_AS(CumulativeTable{weights}, std::invalid_argument);
}

}  // namespace texmap::test
