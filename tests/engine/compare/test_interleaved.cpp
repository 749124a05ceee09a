// Alternate timing: the order, the counts and the shortest time; never how long anything takes on
// this machine.
#include "engine/compare/interleaved.hpp"

#include <doctest.h>

#include <chrono>
#include <string>
#include <thread>

#include "engine/files/system.hpp"

TEST_CASE(
    "works alternate, each once more than it is timed; every run is told, and after every round it "
    "is asked whether that is enough") {
  std::string order;
  std::vector<std::pair<int, int>> told;
  std::vector<int> asked;
  const auto times = texmap::work_times(
      {[&] { order += 'a'; }, [&] { order += 'b'; }}, 9,
      [&](int done, int total) { told.emplace_back(done, total); },
      [&](int rounds) {
        asked.push_back(rounds);
        return rounds == 2;
      });
  CHECK(order == "ababab");
  CHECK(told.size() == 6);
  CHECK(told.back() == std::pair{6, 20});
  CHECK(asked == std::vector<int>{1, 2});
  REQUIRE(times.size() == 2);
  for (const texmap::WorkTime& time : times) {  // clocks that go forward, and no infinity left
    CHECK((time.wall >= 0 && time.wall < 1e9));
    CHECK((time.processor >= 0 && time.processor < 1e9));
    CHECK(time.spread >= 1);
  }
  order.clear();
  (void)texmap::work_times({[&] { order += 'a'; }}, 3);
  CHECK(order == "aaaa");
}

TEST_CASE(
    "the processor's time leaves out what the thread slept, and the spread is median over "
    "shortest") {
  int run = 0;
  const auto times = texmap::work_times(
      {[] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); },
       [&] {  // after the run that does not count: 2, 20 and 20 ms
         const double until = texmap::thread_milliseconds() + (++run == 2 ? 2 : 20);
         while (texmap::thread_milliseconds() < until) {
         }
       }},
      3);
  CHECK(times[0].wall >= 30);
#ifndef _WIN32  // which counts in steps of 16 ms
  CHECK(times[0].processor < 15);
#endif
  CHECK(times[1].processor >= 2);
  CHECK(times[1].spread >= doctest::Approx(20 / times[1].processor));
}

TEST_CASE("as many rounds as fit into the time, within their limits") {
  CHECK(texmap::rounds_within(0, {[] {}}, 7, 100) == 7);
  CHECK(texmap::rounds_within(1e9, {[] {}}, 7, 100) == 100);
  const auto sleep = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  const int rounds = texmap::rounds_within(1000, {sleep, sleep}, 1, 100);  // of 40 ms or more
  CHECK(rounds <= 25);
}
