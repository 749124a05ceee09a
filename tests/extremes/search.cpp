// How inputs are drawn, and how the worst of them are searched for.
#include <algorithm>
#include <array>

#include "claims.hpp"

namespace texmap::extremes {
namespace {

/// An input as the dice's draws, and its error. Any input can be changed this way, whatever it is.
struct Found {
  Dice::Tape tape{};
  std::size_t taken = 0;
  double off = -1;
};

Found evaluated(const Measurement& measurement, Dice::Tape tape, std::uint64_t seed) {
  Dice dice(tape, seed);
  Worst worst{.describes = false};
  measurement.one_input(dice, worst);
  return {std::move(tape), dice.taken(), worst.off};
}

/// The tape with one to three of its places changed: drawn again, or by some power of two.
Dice::Tape changed(const Found& found, Dice& chance) {
  Dice::Tape tape = found.tape;
  for (int places = chance.within(1, 3); places > 0 && found.taken > 0; --places) {
    std::uint64_t& place = tape[chance.bits() % found.taken];
    const std::uint64_t fresh = chance.bits();
    const std::uint64_t step = std::uint64_t{1} << chance.within(8, 63);
    place = chance.once_in(4) ? fresh : chance.once_in(2) ? place + step : place - step;
  }
  return tape;
}

}  // namespace

Worst searched(const Measurement& measurement, int inputs, std::uint64_t seed) {
  if (measurement.every_input) return measurement.every_input();
  Dice chance(seed);
  const int evaluations = measurement.times * inputs;
  std::array<Found, 4> starts;  // the worst of a quarter, from the worst on
  for (int i = 0; i < evaluations / 4; ++i) {
    Found drawn = evaluated(measurement, {}, chance.bits());
    if (!(drawn.off > starts.back().off)) continue;
    starts.back() = std::move(drawn);
    std::sort(starts.begin(), starts.end(),
              [](const Found& a, const Found& b) { return a.off > b.off; });
  }
  const int steps = evaluations * 3 / 4 / static_cast<int>(starts.size());
  for (Found& found : starts) {
    for (int i = 0; i < steps; ++i) {
      Found next = evaluated(measurement, changed(found, chance), chance.bits());
      if (next.off >= found.off) found = std::move(next);
    }
  }
  Found& worst_found = *std::max_element(
      starts.begin(), starts.end(), [](const Found& a, const Found& b) { return a.off < b.off; });
  Dice dice(worst_found.tape, 0);
  Worst worst;
  measurement.one_input(dice, worst);
  return worst;
}

}  // namespace texmap::extremes
