// Distributes the rows of a picture over threads.
#pragma once
#include <functional>

namespace texmap {

/// Calls `work(row)` once for each row from 0 to rows - 1, on several threads, and waits for all.
///
/// @param threads   0: all cores; with fewer than asked for, those that there are do everything
/// @param finished  called with (rows done, rows) after each row, from any thread; may be empty
/// Errors: the first exception of `work`, after all threads have stopped.
void for_each_row(int rows, int threads, const std::function<void(int, int)>& finished,
                  const std::function<void(int)>& work);

}  // namespace texmap
