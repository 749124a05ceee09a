// Signals that wait.
#pragma once
#include <signal.h>

#include <array>
#include <cstddef>

namespace texmap {

/// While it lives, signals that would end the program in the middle of a file wait for its end, and those about a file that
/// cannot grow or a pipe nobody reads are errors of the write instead.
///
/// A program that waits for its other threads before it writes is safe: a signal could still end it in one of those.
class SignalGuard {
 public:
  SignalGuard() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, SIGTSTP}) sigaddset(&waiting, signal);
    pthread_sigmask(SIG_BLOCK, &waiting, &mask_before_);
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t i = 0; i < ignored.size(); ++i) sigaction(ignored[i], &ignore, &action_before_[i]);
  }
  ~SignalGuard() {
    for (std::size_t i = 0; i < ignored.size(); ++i) sigaction(ignored[i], &action_before_[i], nullptr);
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
