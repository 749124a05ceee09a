// The progress line on the terminal.
#include "engine/draw/progress.hpp"

#include <cstdio>
#include <utility>

#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {

Progress::Progress(bool wanted, std::function<std::string()> remark)
    : enabled_(wanted && stderr_is_watched()), remark_(std::move(remark)) {}

Progress::~Progress() {
  // Spaces and carriage returns only: every terminal understands them.
  if (written_ > 0) std::fprintf(stderr, "\r%*s\r", written_, "");
}

void Progress::report(int done, int total) {
  if (!enabled_) return;
  const std::lock_guard guard(lock_);
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> elapsed = now - start_;
  if (elapsed < std::chrono::milliseconds(500) || now - last_ < std::chrono::milliseconds(100))
    return;
  last_ = now;
  const double percent = 100.0 * done / total;
  std::string line = text("%3d %% done", static_cast<int>(percent));
  // The first rows come after the memory for all, and would promise hours.
  if (percent >= 1)
    line += text(", about %.0f s left", elapsed.count() * (100 - percent) / percent);
  if (remark_) line += remark_();
  std::fprintf(stderr, "\r%-*s", written_, line.c_str());
  const int length = static_cast<int>(line.size());
  if (length > written_) written_ = length;
}

}  // namespace texmap
