// The progress line on the terminal.
#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <string>

namespace texmap {

/// A line on stderr that says how much is done and how long the rest will take.
/// It is written only to a terminal, after half a second, at most ten times a second, and is
/// cleared at the end.
class Progress {
 public:
  /// @param wanted  false for silence (--quiet)
  /// @param remark  returns the rest of the line, called from any thread; may be empty
  explicit Progress(bool wanted, std::function<std::string()> remark = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Reports that `done` of `total` parts are done; called from any thread.
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
