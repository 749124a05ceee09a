// Tests of common/engine/render/threads.hpp: rows shared out over threads.
#include <doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/render/threads.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {
namespace {

TEST_CASE("every row is worked on once, for any number of rows and threads") {
  for (const int rows : {0, 1, 2, 7, 500}) {
    for (const int threads : {0, 1, 2, 7, 64}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(rows));
      for_each_row(rows, threads, {}, [&](int row) { ++visits[static_cast<std::size_t>(row)]; });
      CAPTURE(rows);
      CAPTURE(threads);
      CHECK(std::all_of(visits.begin(), visits.end(),
                        [](const std::atomic<int>& count) { return count == 1; }));
    }
  }
}

TEST_CASE("each count of finished rows is told once, and only after as many rows") {
  for (const int threads : {1, 2, 7}) {
    constexpr int rows = 200;
    std::mutex lock;
    std::vector<int> told(rows + 1);
    std::atomic<int> worked = 0;
    int early = 0;
    int wrong_total = 0;
    const auto finished = [&](int done, int total) {
      const std::lock_guard guard(lock);
      ++told.at(static_cast<std::size_t>(done));
      if (worked < done) ++early;
      if (total != rows) ++wrong_total;
    };
    for_each_row(rows, threads, finished, [&](int) { ++worked; });
    CAPTURE(threads);
    CHECK(told[0] == 0);
    CHECK(std::count(told.begin() + 1, told.end(), 1) == rows);
    CHECK(early == 0);
    CHECK(wrong_total == 0);
  }
}

TEST_CASE("one thread is the caller's own and goes through the rows in order") {
  std::vector<int> order;
  bool same_thread = true;
  const std::thread::id caller = std::this_thread::get_id();
  for_each_row(5, 1, {}, [&](int row) {
    order.push_back(row);
    same_thread = same_thread && std::this_thread::get_id() == caller;
  });
  CHECK(order == std::vector<int>{0, 1, 2, 3, 4});
  CHECK(same_thread);
}

TEST_CASE("as many rows are at work at once as there are threads, and no more threads are made") {
  for (const int threads : {2, 7}) {
    for (const int rows : {threads, 50}) {
      CAPTURE(threads);
      CAPTURE(rows);
      std::mutex lock;
      std::condition_variable changed;
      int arrived = 0;
      bool met = true;
      std::set<std::thread::id> workers;
      for_each_row(rows, threads, {}, [&](int row) {
        std::unique_lock guard(lock);
        workers.insert(std::this_thread::get_id());
        if (row >= threads) return;
        // Nobody has ended yet: the first rows are held until all threads have one.
        ++arrived;
        changed.notify_all();
        met = met &&
              changed.wait_for(guard, std::chrono::seconds(5), [&] { return arrived >= threads; });
      });
      CHECK(met);
      CHECK(workers.size() == static_cast<std::size_t>(threads));
      CHECK(workers.count(std::this_thread::get_id()) == 1);
    }
  }
}

TEST_CASE("the first exception of the work reaches the caller, and the rest of the rows is left") {
  for (const int threads : {1, 2, 7}) {
    std::atomic<int> worked = 0;
    const auto work = [&](int row) {
      ++worked;
      if (row == 3) throw std::runtime_error("row 3");
    };
    CAPTURE(threads);
    CHECK_THROWS_WITH_AS(for_each_row(1000000, threads, {}, work), "row 3", std::runtime_error);
    CHECK(worked < 1000000);
  }
}

TEST_CASE("an exception of the progress report reaches the caller too") {
  const auto finished = [](int done, int) {
    if (done == 2) throw std::runtime_error("report");
  };
  CHECK_THROWS_WITH(for_each_row(10, 2, finished, [](int) {}), "report");
}

}  // namespace
}  // namespace texmap::test
