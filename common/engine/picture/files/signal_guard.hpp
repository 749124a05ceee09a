// Signals that wait.
#pragma once
#include <signal.h>

#include <array>
#include <cstddef>

namespace texmap {

/// While it lives, signals that would end the program wait, so a file is written whole. Signals
/// about a file at its size limit or a pipe without a reader become errors of the write.
///
/// Join all other threads first: a signal could still end the program in one of them.
class SignalGuard {
 public:
  SignalGuard() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, SIGTSTP})
      sigaddset(&waiting, signal);
    pthread_sigmask(SIG_BLOCK, &waiting, &mask_before_);
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t i = 0; i < ignored.size(); ++i)
      sigaction(ignored[i], &ignore, &action_before_[i]);
  }
  ~SignalGuard() {
    for (std::size_t i = 0; i < ignored.size(); ++i)
      sigaction(ignored[i], &action_before_[i], nullptr);
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
  }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  static constexpr std::array<int, 2> ignored = {SIGPIPE, SIGXFSZ};
  sigset_t mask_before_{};
  std::array<struct sigaction, 2> action_before_{};
};

}  // namespace texmap
