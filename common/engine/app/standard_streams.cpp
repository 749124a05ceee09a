// Makes standard input, output and error safe to use.
#include "engine/app/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

namespace texmap {

void secure_standard_streams() {
  // open() returns the lowest free number, so this order fills the gaps.
  for (int stream = 0; stream <= 2; ++stream) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
      [[maybe_unused]] const int opened =
          open("/dev/null", O_RDWR);  // NOLINT: stays open as long as the program runs
    }
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw std::runtime_error("cannot write to standard output: " +
                             std::generic_category().message(errno));
  }
}

}  // namespace texmap
