// An open file that closes itself.
#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace texmap {

/// Owns one file descriptor of the system, never 0, 1 or 2.
///
/// A program may start with these three closed. A file would then get one of them, and messages
/// would be written into it.
class FileDescriptor {
 public:
  explicit FileDescriptor(int opened) : number_(opened) {
    if (number_ < 0 || number_ > 2) return;
    number_ = fcntl(opened, F_DUPFD_CLOEXEC, 3);
    const int error = errno;
    ::close(opened);
    errno = error;
  }
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  /// Below 0 if the file could not be opened; errno says why.
  [[nodiscard]] int number() const { return number_; }

  /// Closes now and says whether everything written before has arrived; errno says why not.
  [[nodiscard]] bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

}  // namespace texmap
