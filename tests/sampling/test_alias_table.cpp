// Tests of common/sampling/alias_table.hpp: every thing has its own probability.
#include "sampling/alias_table.hpp"

#include <doctest.h>

namespace texmap::test {
namespace {

/// The probability of each thing, summed over all boxes.
std::vector<double> probabilities(const AliasTable& table, std::size_t things) {
  std::vector<CompensatedSum<double>> sums(table.boxes().size());
  for (std::size_t i = 0; i < table.boxes().size(); ++i) {
    const AliasTable::Box& box = table.boxes()[i];
    REQUIRE(box.share >= 0);
    REQUIRE(box.share <= 1);
    sums[i].add(box.share);
    sums[box.other].add(1 - box.share);
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double probability = sums[i].value() / static_cast<double>(sums.size());
    if (i < things)
      result.push_back(probability);
    else
      REQUIRE(probability == 0);  // boxes that fill up a power of two
  }
  return result;
}

std::vector<double> random_weights(std::size_t count, double contrast) {
  std::vector<double> weights;
  std::uint32_t state = 5;
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 1664525U + 1013904223U;
    weights.push_back(std::pow(static_cast<double>(state >> 8) * 0x1p-24, contrast));
  }
  return weights;
}

/// The largest relative difference between a table's probabilities and its weights.
double worst(const std::vector<double>& weights) {
  CompensatedSum<double> total;
  for (const double weight : weights) total.add(weight);
  const std::vector<double> found = probabilities(AliasTable(weights), weights.size());
  double most = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double expected = weights[i] / total.value();
    if (weights[i] == 0)
      CHECK(found[i] == 0);
    else
      most = std::max(most, std::abs(found[i] / expected - 1));
  }
  return most;
}

}  // namespace

TEST_CASE("the shares of all boxes add up to each thing's weight, within a few roundings") {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  CHECK(worst({1}) == 0);
  CHECK(worst({1, 3}) <= 2 * u);
  CHECK(worst({0, 0, 5, 0, 0}) <= 2 * u);
  CHECK(worst({1, 2, 3, 4, 5, 6, 7}) <= 4 * u);
  CHECK(worst(std::vector<double>(1000, 1.0)) < 1e-13);  // the last box takes all roundings
  CHECK(worst(random_weights(3000, 1)) <= 8 * u);
  CHECK(worst(random_weights(3000, 6)) < 1e-11);  // weights to 1e-40: the smallest take a rounding
}

TEST_CASE("a thing that gives to thousands of boxes keeps its weight") {
  std::vector<double> weights(100000, 0.1);
  weights[12345] = 7e5;
  CHECK(worst(weights) < 1e-11);
}

TEST_CASE("drawn with every pair of a fine grid, things come as often as their weights say") {
  const std::vector<double> weights = {3, 0, 1, 10, 2};
  const AliasTable table(weights);
  std::vector<double> count(5, 0);
  constexpr int n = 512;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) count[table.draw((i + 0.5) / n, (k + 0.5) / n)] += 1;
  }
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(count[i] / (n * n) == doctest::Approx(weights[i] / 16).epsilon(0.003));
  CHECK(count[1] == 0);
  CHECK(table.boxes().size() == 8);  // a power of two: each box has as many of the 2^24 numbers
}

TEST_CASE(
    "the largest sample stays inside, and weights by which nothing can be drawn are refused") {
  const AliasTable table(std::vector<double>{1, 1, 1});
  CHECK(table.draw(1 - 0x1p-24, 1 - 0x1p-24) < 3);
  CHECK(table.draw(0, 0) < 3);
  CHECK(AliasTable().draw(0.99, 0.5) == 0);
  CHECK_THROWS_AS(AliasTable(std::vector<double>{}), std::invalid_argument);
  CHECK_THROWS_AS(AliasTable(std::vector<double>{0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(AliasTable(std::vector<double>{1, -1}), std::invalid_argument);
  CHECK_THROWS_AS(AliasTable(std::vector<double>{1, std::nan("")}), std::invalid_argument);
  CHECK_THROWS_AS(AliasTable(std::vector<double>{1, std::numeric_limits<double>::infinity()}),
                  std::invalid_argument);
}

}  // namespace texmap::test
