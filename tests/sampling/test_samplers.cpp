// Tests of common/sampling/samplers.hpp: where samples lie, how far off their means are, and that
// all numbers agree.
#include <doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "engine/draw/sample_random.hpp"
#include "sampling/sampled_numbers.hpp"
#include "support/shown_values.hpp"
#include "support/whole_numbers.hpp"

namespace texmap::test {
namespace {

constexpr std::array all_kinds = {SamplerKind::random, SamplerKind::stratified,
                                  SamplerKind::multi_jitter, SamplerKind::sobol};
std::string name_of(SamplerKind kind) {
  constexpr std::array names = {"random", "stratified", "multi-jitter", "Sobol'"};
  return names[static_cast<std::size_t>(kind)];
}

/// Looks at every kind of sampler with each of these numbers of samples.
void for_all_samplers(std::initializer_list<int> counts, void (*law)(SamplerKind kind, int count)) {
  for (const SamplerKind kind : all_kinds) {
    for (const int count : counts) {
      CAPTURE(name_of(kind));
      CAPTURE(count);
      law(kind, count);
    }
  }
}

/// All samples of a pixel.
std::vector<Point2<double>> samples_of(const Sampler& sampler, std::uint32_t column,
                                       std::uint32_t row, std::uint32_t dimension) {
  std::vector<Point2<double>> all;
  for (int i = 0; i < sampler.samples(); ++i) {
    all.push_back(sampler.pair<double>(test::hash_row<double>(column, row),
                                       static_cast<std::uint32_t>(i), dimension));
  }
  return all;
}

/// True when no cell of a grid holds two samples: of as many cells as samples each has one then.
bool all_apart(const std::vector<Point2<double>>& samples, std::uint32_t columns,
               std::uint32_t rows) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
  for (const Point2<double>& at : samples) {
    cells.emplace(static_cast<std::uint32_t>(at.u * columns),
                  static_cast<std::uint32_t>(at.v * rows));
  }
  return cells.size() == samples.size();
}

/// How far counts are from all being equal, as a sum of squares: by chance about as many as there
/// are counts.
template <class Counts>
double chi_squared(const Counts& counts) {
  double sum = 0, chi = 0;
  for (const double found : counts) sum += found;
  const double expected = sum / static_cast<double>(counts.size());
  for (const double found : counts) chi += (found - expected) * (found - expected) / expected;
  return chi;
}

TEST_CASE_TEMPLATE("every number draws the same samples, one pixel at a time or many", Real,
                   TEXMAP_SAMPLED_NUMBERS) {
  for_all_samplers(
      {1, 2, 3, 7, 16, 64, 97, 100, 256, 1000, most_samples}, [](SamplerKind kind, int count) {
        const Sampler sampler(kind, count, 11);
        for (int i = 0; i < count; i += count < 300 ? 1 : count / 100) {
          for (const std::uint32_t dimension : {0U, 3U, 50U}) {
            const auto sample = static_cast<std::uint32_t>(i);
            const Point2<Real> pack =
                sampler.pair<Real>(test::hash_row<Real>(16, 5), sample, dimension);
            for (std::uint32_t at = 0; at < lanes<Real>; ++at) {
              const Point2<double> single =
                  sampler.pair<double>(test::hash_row<double>(16 + at, 5), sample, dimension);
              REQUIRE(static_cast<double>(lane(pack.u, at)) == single.u);
              REQUIRE(static_cast<double>(lane(pack.v, at)) == single.v);
            }
          }
        }
      });
}

TEST_CASE("a number of samples that is not from 1 to 16384 is refused") {
  CHECK_THROWS_AS(Sampler(SamplerKind::sobol, 0), std::invalid_argument);
  CHECK_THROWS_AS(Sampler(SamplerKind::random, -1), std::invalid_argument);
  CHECK_THROWS_AS(Sampler(SamplerKind::stratified, most_samples + 1), std::invalid_argument);
  CHECK(Sampler(SamplerKind::multi_jitter, most_samples).samples() == most_samples);
}

TEST_CASE(
    "a shuffle is a permutation, whatever its count, and takes each integer to each place equally "
    "often") {
  for (std::uint32_t count = 1; count < 300; ++count) {
    CAPTURE(count);
    const sampling::Shuffle shuffle(count);
    const std::uint32_t keys = count <= 16 || count == 64 || count == 100 ? 4000 : 20;
    std::vector<double> places(std::size_t{count} * count);
    for (std::uint32_t k = 0; k < keys; ++k) {
      std::vector<bool> taken(count);
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t place = shuffle(i, hash_bits(k + 1));
        REQUIRE(place < count);
        REQUIRE_FALSE(taken[place]);
        taken[place] = true;
        places[std::size_t{i} * count + place] += 1;
      }
    }
    const double freedom = (count - 1.0) * (count - 1.0);
    if (keys > 20) CHECK(chi_squared(places) < freedom + 6 * std::sqrt(2 * freedom) + 1e-9);
  }
}

TEST_CASE("a grid has a cell for each sample, none too many where the count has two like factors") {
  for (std::uint32_t count = 1; count <= static_cast<std::uint32_t>(most_samples); ++count) {
    const sampling::CellGrid grid(count);
    REQUIRE(grid.columns * grid.rows >= count);
    REQUIRE(grid.columns * grid.rows < count + grid.columns);
    for (std::uint32_t cell = count > 40 ? count - 40 : 0; cell < grid.columns * grid.rows;
         ++cell) {
      REQUIRE(grid.row_of(cell) == cell / grid.columns);
    }
  }
  CHECK(sampling::CellGrid(100).columns == 10);
  CHECK(sampling::CellGrid(128).columns == 8);
  CHECK(sampling::CellGrid(72).rows == 9);
}

TEST_CASE(
    "stratified and multi-jitter: no cell holds two samples; multi-jitter: no column, no row") {
  for (const int count : {1,  2,  3,   4,   5,   6,   12,  13,   16,   36,          64,
                          72, 97, 100, 128, 251, 256, 400, 1024, 8191, most_samples}) {
    const auto n = static_cast<std::uint32_t>(count);
    const sampling::CellGrid grid(n);
    CAPTURE(count);
    for (std::uint32_t column = 0; column < (count > 1024 ? 1U : 16U); ++column) {
      const auto stratified = samples_of(Sampler(SamplerKind::stratified, count), column, 9, 3);
      CHECK(all_apart(stratified, grid.columns, grid.rows));
      const auto jittered = samples_of(Sampler(SamplerKind::multi_jitter, count), column, 9, 3);
      if (grid.columns * grid.rows == n) CHECK(all_apart(jittered, grid.columns, grid.rows));
      CHECK(all_apart(jittered, grid.columns * grid.rows, 1));
      CHECK(all_apart(jittered, 1, n));
    }
  }
}

TEST_CASE(
    "Sobol': every grid of powers of two holds one sample in each cell, after scrambling and "
    "shuffling too") {
  for (std::uint32_t k = 0; k <= 12; ++k) {
    for (std::uint32_t column = 0; column < 8; ++column) {
      const auto samples = samples_of(Sampler(SamplerKind::sobol, 1 << k), column, k, 3 + column);
      for (std::uint32_t j = 0; j <= k; ++j) {
        CAPTURE(k);
        CAPTURE(j);
        CHECK(all_apart(samples, 1U << j, 1U << (k - j)));
      }
    }
  }
}

TEST_CASE("Sobol': other counts are a net for each power of two in them") {
  const auto samples = samples_of(Sampler(SamplerKind::sobol, 100), 3, 4, 5);  // 64 + 32 + 4
  for (const auto& [first, size] : {std::pair{0, 64}, {64, 32}, {96, 4}}) {
    const std::vector<Point2<double>> net(samples.begin() + first, samples.begin() + first + size);
    for (int j = 1; j <= size; j *= 2) {
      CHECK(all_apart(net, static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(size / j)));
    }
  }
  const std::vector<Point2<double>> two_nets(samples.begin(), samples.begin() + 96);
  CHECK(all_apart(two_nets, 128, 1));  // the second net is between the points of the first
}

TEST_CASE(
    "each pixel, each dimension and each seed has samples of its own, spread over the whole "
    "square") {
  for_all_samplers({8, 16, 64, 97}, [](SamplerKind kind, int count) {
    // One sample over pixels: uniform, and one pixel's tells nothing about the next one's.
    const Sampler sampler(kind, count, 5), reseeded(kind, count, 6);
    std::array<double, 64> bins{};
    // Correlations with the next pixel, the next dimension, another seed, the other coordinate.
    std::array<double, 4> alike{};
    constexpr int side = 256;
    for (std::uint32_t row = 0; row < side; ++row) {
      for (std::uint32_t column = 0; column < side; ++column) {
        const auto here = test::hash_row<double>(column, row);
        const auto at = sampler.pair<double>(here, 7, 3);
        const Point2<double> others[] = {
            sampler.pair<double>(test::hash_row<double>(column + 1, row), 7, 3),
            sampler.pair<double>(here, 7, 4),
            reseeded.pair<double>(here, 7, 3),
            {at.v, 0.5}};
        bins[static_cast<std::size_t>(at.v * 8) * 8 + static_cast<std::size_t>(at.u * 8)] += 1;
        for (std::size_t k = 0; k < alike.size(); ++k)
          alike[k] += (at.u - 0.5) * (others[k].u - 0.5) + (at.v - 0.5) * (others[k].v - 0.5);
      }
    }
    CHECK(chi_squared(bins) < 63 + 5 * std::sqrt(2 * 63.0));
    for (const double sum : alike) CHECK(std::abs(sum) < 4 * side / 12.0 * std::numbers::sqrt2);
  });
}

TEST_CASE(
    "two dimensions of a pixel are paired by chance: products of them have the error of random "
    "samples") {
  for_all_samplers({16, 64, 100, 256}, [](SamplerKind kind, int count) {
    const Sampler sampler(kind, count, 3);
    std::array<double, 3> squares{};  // of sums of products: u by u, u by v, and of their halves
    constexpr int pixels = 2048;
    for (std::uint32_t p = 0; p < pixels; ++p) {
      const auto first = samples_of(sampler, p, 0, 3);
      const auto second = samples_of(sampler, p, 0, 4);
      std::array<double, 3> sums{};
      for (std::size_t i = 0; i < first.size(); ++i) {
        sums[0] += (first[i].u - 0.5) * (second[i].u - 0.5) * 12;
        sums[1] += (first[i].u - 0.5) * (second[i].v - 0.5) * 12;
        sums[2] += (first[i].u < 0.5) == (second[i].u < 0.5) ? 1 : -1;
      }
      for (std::size_t k = 0; k < 3; ++k) squares[k] += sums[k] * sums[k] / count;
    }
    // A permutation of 16 gives 16/15, and chance another 0.13.
    for (const double sum : squares) CHECK(std::abs(sum / pixels - 1) < 0.25);
  });
}

TEST_CASE_TEMPLATE(
    "numbers handed out one after another are the sampler's own, whoever asks for how many", Real,
    TEXMAP_SAMPLED_NUMBERS) {
  const auto pixels = test::hash_row<Real>(8, 9);
  for (const SamplerKind kind : all_kinds) {
    const Sampler sampler(kind, 100, 3);
    SampleSums<Real> sums(sampler);
    for (const auto& [first, end] : {std::pair(0, 50), {50, 100}, {7, 39}, {37, 38}}) {
      int done = first, sum = 0;
      const auto one_sample = [&pixels, &sampler, &done](auto& random) {
        bool right = true;
        // Some samples ask for nothing, the first of a block among them; some for more than is
        // kept.
        for (int dimension = 0; dimension < done * 5 % 8; ++dimension) {
          const Point2<Real>& got = random.next_2d();
          const Point2<Real> own = sampler.pair<Real>(pixels, static_cast<std::uint32_t>(done),
                                                      static_cast<std::uint32_t>(dimension));
          right =
              right && all_lanes(got.u) == all_lanes(own.u) && all_lanes(got.v) == all_lanes(own.v);
        }
        REQUIRE(right);
        return done++;
      };
      sums.add(pixels, first, end, one_sample, sum);
      REQUIRE(done == end);
      CHECK(sum == (end - first) * (first + end - 1) / 2);
    }
  }
}

}  // namespace
}  // namespace texmap::test
