// Another program that runs while this one goes on.
#pragma once
#include <string>
#include <vector>

namespace texmap::grade {

/// A program with its words, ended with this object. It has a process group of its own, so that
/// Ctrl-C reaches it only through us. Standard output and error are ours.
class Process {
 public:
  /// Errors: FileError with a reason, if it cannot be started, as on Windows.
  explicit Process(std::vector<std::string> words);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  [[nodiscard]] bool runs();
  /// Asks it to end, and waits until it has; its exit status, or -1 if a signal ended it.
  int end();

 private:
  int id_ = -1;
  int status_ = 0;
};

}  // namespace texmap::grade
