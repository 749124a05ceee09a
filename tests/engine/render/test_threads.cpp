// Tests of common/engine/render/threads.hpp: rows shared out over threads.
#include <doctest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
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

/// A place where so many threads meet. If one waits in vain for a minute, all give up.
class MeetingPlace {
 public:
  explicit MeetingPlace(int expected) : expected_(expected) {}

  void arrive_and_wait() {
    std::unique_lock lock(lock_);
    ++arrived_;
    changed_.notify_all();
    const bool met = changed_.wait_for(lock, std::chrono::minutes(1),
                                       [this] { return arrived_ >= expected_ || gave_up_; });
    gave_up_ = gave_up_ || !met;
    changed_.notify_all();
  }
  /// How many came; to be asked when all threads have ended.
  [[nodiscard]] int arrived() const { return arrived_; }
  [[nodiscard]] bool gave_up() const { return gave_up_; }

 private:
  int expected_;
  int arrived_ = 0;
  bool gave_up_ = false;
  std::mutex lock_;
  std::condition_variable changed_;
};

/// The numbers of this process's threads, where the system lists them (Linux).
std::set<std::string> threads_of_process() {
  std::set<std::string> numbers;
  std::error_code error;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", error))
    numbers.insert(task.path().filename().string());
  return numbers;
}

/// How many threads are new; one that ended a moment ago may still be listed before.
int new_threads_since(const std::set<std::string>& before) {
  int count = 0;
  for (const std::string& number : threads_of_process()) count += before.count(number) == 0 ? 1 : 0;
  return count;
}

/// Draws `rows` rows on `threads` threads, of which `expected` should be at work at once.
void check_rows_at_once(int rows, int threads, int expected) {
  CAPTURE(rows);
  CAPTURE(threads);
  MeetingPlace meeting(expected);
  std::mutex lock;
  std::set<std::thread::id> workers;
  const std::thread::id caller = std::this_thread::get_id();
  std::thread([] {}).join();  // a sanitizer starts a thread of its own with the first
  const std::set<std::string> before = threads_of_process();
  int helpers = -1;
  for_each_row(rows, threads, {}, [&](int row) {
    if (row < expected) {
      // Nobody has ended yet: the first rows are held until all threads have one.
      if (std::this_thread::get_id() == caller) helpers = new_threads_since(before);
      meeting.arrive_and_wait();
    }
    const std::lock_guard guard(lock);
    workers.insert(std::this_thread::get_id());
  });
  REQUIRE_FALSE(meeting.gave_up());
  CHECK(meeting.arrived() == expected);
  CHECK(workers.size() == static_cast<std::size_t>(expected));
  CHECK(workers.count(caller) == 1);
  if (!before.empty()) CHECK(helpers == expected - 1);
}

TEST_CASE("as many rows are at work at once as there are threads, and no more threads are made") {
  for (const int threads : {1, 2, 3, 7}) {
    check_rows_at_once(threads, threads, threads);
    check_rows_at_once(50, threads, threads);
  }
  check_rows_at_once(1, 7, 1);
  check_rows_at_once(3, 7, 3);
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  check_rows_at_once(4 * cores, 0, cores);
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

TEST_CASE("when every row throws, one exception reaches the caller") {
  std::atomic<int> worked = 0;
  const auto work = [&](int row) {
    ++worked;
    throw row;
  };
  CHECK_THROWS_AS(for_each_row(100, 4, {}, work), int);
  CHECK(worked >= 1);
  CHECK(worked <= 4);
}

TEST_CASE("an exception of the progress report reaches the caller too") {
  const auto finished = [](int done, int) {
    if (done == 2) throw std::runtime_error("report");
  };
  CHECK_THROWS_WITH(for_each_row(10, 2, finished, [](int) {}), "report");
}

}  // namespace
}  // namespace texmap::test
