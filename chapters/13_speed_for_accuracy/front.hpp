// The front: of all that was tried, what nothing else beats in both time and error.
#pragma once
#include <algorithm>
#include <vector>

namespace texmap::chapter_13 {

/// Times whose ratio is smaller are the same to the clock.
inline constexpr double same_time = 1.05;

/// A time and an error, and which of many it belongs to.
struct Tradeoff {
  double time, error;
  std::size_t index;
};

/// Those that no other beats: whatever is faster than one of them is farther off. From the fastest to the most exact.
///
/// Of several with the same time the most exact counts, of several with the same error the fastest.
[[nodiscard]] inline std::vector<Tradeoff> front_of(std::vector<Tradeoff> all) {
  std::sort(all.begin(), all.end(),
            [](const Tradeoff& a, const Tradeoff& b) { return a.time < b.time || (a.time == b.time && a.error < b.error); });
  std::vector<Tradeoff> front;
  for (const Tradeoff& next : all) {
    if (front.empty() || next.error < front.back().error) front.push_back(next);
  }
  return front;
}

}  // namespace texmap::chapter_13
