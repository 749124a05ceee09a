// The progress line on the terminal.
#include "engine/render/progress.hpp"

#include <cstdio>
#include <utility>

#include "engine/measure/text.hpp"
#include "engine/system/system.hpp"

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
  const double left = elapsed.count() * (total - done) / done;
  const std::string line =
      text("%3d %% done, about %.0f s left", static_cast<int>(100.0 * done / total), left) +
      (remark_ ? remark_() : "");
  std::fprintf(stderr, "\r%-*s", written_, line.c_str());
  const int length = static_cast<int>(line.size());
  if (length > written_) written_ = length;
}

}  // namespace texmap
