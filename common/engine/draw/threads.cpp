// Distributes the rows of a picture over threads.
#include "engine/draw/threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace texmap {

void for_each_row(int rows, int threads, const std::function<void(int, int)>& finished,
                  const std::function<void(int)>& work) {
  std::atomic<int> next = 0;
  std::atomic<int> done = 0;
  std::exception_ptr failure;
  std::mutex failure_lock;

  const auto take_rows = [&] {
    for (int row = next++; row < rows; row = next++) {
      try {
        work(row);
        const int so_far = ++done;
        if (finished) finished(so_far, rows);
      } catch (...) {
        const std::lock_guard lock(failure_lock);
        if (!failure) failure = std::current_exception();
        next = rows;
      }
    }
  };

  const int wanted =
      threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::thread> helpers;
  try {
    while (static_cast<int>(helpers.size()) + 1 < std::min(wanted, rows))
      helpers.emplace_back(take_rows);
  } catch (const std::exception&) {
    // If the system refuses more threads, those that there are draw everything.
  }
  take_rows();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace texmap
