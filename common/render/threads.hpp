// Rows of a picture, shared out over threads.
#pragma once
#include <functional>

namespace texmap {

/// Calls `work(row)` once for each row from 0 to rows - 1, from several threads, and returns when all are done.
///
/// @param threads   how many; 0 takes as many as the machine has cores. If the system refuses some, the others do their share
/// @param finished  called with (rows done, rows) after each row, from any thread; may be empty
/// Errors: the first exception that `work` throws is thrown again here, after all threads have stopped.
void for_each_row(int rows, int threads, const std::function<void(int, int)>& finished, const std::function<void(int)>& work);

}  // namespace texmap
