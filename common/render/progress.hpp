// How far a long piece of work is, on the terminal.
#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace texmap {

/// A line on stderr that says how much is done and how long the rest will take.
///
/// Nothing is written unless stderr is a terminal, nothing in the first half second, and then at most ten times a second.
/// The line is cleared when the work ends, so that what follows starts on a clean line.
class Progress {
 public:
  /// @param wanted  false for silence (--quiet)
  /// @param remark  what else the line says, asked for each time it is written, from any thread; may be empty
  explicit Progress(bool wanted, std::function<std::string()> remark = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says that `done` of `total` parts are done; may be called from any thread.
  void report(int done, int total);

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  std::function<std::string()> remark_;
  std::mutex lock_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  int written_ = 0;  // characters on the line
};

}  // namespace texmap
