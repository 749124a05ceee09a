// Tests of common/engine/draw/threads.hpp: rows shared out over threads.
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

#include "engine/draw/threads.hpp"
#include "support/shown_values.hpp"

namespace texmap::test {

TEST_CASE("every row is worked on once, and then told once, for any number of rows and threads") {
  for (const int rows : {0, 1, 2, 7, 500}) {
    for (const int threads : {0, 1, 2, 7, 64}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(rows));
      std::vector<std::atomic<int>> told(static_cast<std::size_t>(rows) + 1);
      std::atomic<int> worked = 0, wrong = 0;
      const auto finished = [&](int done, int total) {
        ++told.at(static_cast<std::size_t>(done));
        wrong += worked < done || total != rows ? 1 : 0;
      };
      for_each_row(rows, threads, finished, [&](int row) {
        ++visits[static_cast<std::size_t>(row)];
        ++worked;
      });
      CAPTURE(rows);
      CAPTURE(threads);
      CHECK(std::count(visits.begin(), visits.end(), 1) == rows);
      CHECK(std::count(told.begin() + 1, told.end(), 1) == rows);
      CHECK(told[0] == 0);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("as many rows are at work at once as there are threads, the caller's among them") {
  for (const int threads : {1, 2, 7}) {
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

TEST_CASE("the first exception of work or report reaches the caller, and the other rows are left") {
  for (const int threads : {1, 2, 7}) {
    std::atomic<int> worked = 0;
    const auto work = [&](int row) {
      ++worked;
      if (row == 3) throw std::runtime_error("row 3");
    };
    const auto finished = [](int done, int) {
      if (done == 2) throw std::runtime_error("report");
    };
    CAPTURE(threads);
    CHECK_THROWS_WITH_AS(for_each_row(1000000, threads, {}, work), "row 3", std::runtime_error);
    CHECK(worked < 1000000);
    CHECK_THROWS_WITH(for_each_row(10, threads, finished, [](int) {}), "report");
  }
}

}  // namespace texmap::test
