// A whole file, written so that nobody ever sees a part of it.
#include "engine/picture/files/write_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "engine/picture/files/errno_message.hpp"
#include "engine/picture/files/file_descriptor.hpp"
#include "engine/picture/files/file_error.hpp"
#include "engine/picture/files/signal_guard.hpp"

namespace texmap {
namespace {

constexpr int most_links = 40;  // as many as the system itself follows

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

// Where a chain of symbolic links ends; the file there need not exist.
std::string end_of_links(std::string path) {
  for (int link = 0; link <= most_links; ++link) {
    std::array<char, PATH_MAX> target{};
    const ssize_t length = readlink(path.c_str(), target.data(), target.size());
    if (length < 0) return path;
    const std::string next(target.data(), static_cast<std::size_t>(length));
    path = next.starts_with('/') ? next : folder_of(path).append("/").append(next);
  }
  throw FileError(errno_message(ELOOP));
}

// The umask can only be read by setting it.
mode_t current_umask() {
  const mode_t mask = umask(077);
  umask(mask);
  return mask;
}

struct Target {
  std::string path;  // after all symbolic links
  bool exists = false;
  bool written_through = false;  // a device or a pipe
  mode_t permissions = 0;
};

Target find_target(const std::string& path) {
  check_name(path);
  if (path.ends_with('/')) throw FileError("the name is that of a folder");

  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    require_success(errno == ENOENT || errno == ENOTDIR);
    return {end_of_links(path), false, false, 0666U & ~current_umask()};
  }
  if (S_ISDIR(status.st_mode)) throw FileError("it is a folder");
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) return {path, true, true};
  if (!S_ISREG(status.st_mode))
    throw FileError("it is neither a file nor a device that can be written to");
  return {end_of_links(path), true, false, status.st_mode & 0777U};
}

void check_folder(const std::string& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) {
    if (errno == ENOENT) throw FileError("the folder '" + folder + "' does not exist");
    throw FileError(errno_message(errno));
  }
  if (!S_ISDIR(status.st_mode)) throw FileError("'" + folder + "' is a file, not a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw FileError("the folder '" + folder + "' cannot be written to: " + errno_message(errno));
  }
}

void check_target(const Target& target) {
  if (target.exists && access(target.path.c_str(), W_OK) != 0)
    throw FileError("it cannot be written to: " + errno_message(errno));
  if (target.written_through) return;
  check_folder(folder_of(target.path));
  const std::string name = target.path.substr(target.path.rfind('/') + 1);  // npos + 1 is 0
  if (name == "." || name == "..") throw FileError("the name is that of a folder");
  const long longest = pathconf(folder_of(target.path).c_str(), _PC_NAME_MAX);
  if (longest > 0 && name.size() > static_cast<std::size_t>(longest))
    throw FileError(errno_message(ENAMETOOLONG));
}

void write_all(const FileDescriptor& file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    require_success(written >= 0);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void write_through(const Target& target, std::span<const std::uint8_t> bytes) {
  // O_NONBLOCK, since opening a pipe without a reader would wait forever. Once it is open, waiting
  // for a slow reader is right.
  FileDescriptor file(open(target.path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  require_success(file.number() >= 0);
  const int flags = fcntl(file.number(), F_GETFL);
  require_success(flags >= 0 && fcntl(file.number(), F_SETFL, flags & ~O_NONBLOCK) >= 0);
  write_all(file, bytes);
  require_success(file.close());
}

// A new file beside the target, which is gone again unless it takes the target's name.
class Draft {
 public:
  explicit Draft(const Target& target)
      : name_(folder_of(target.path) + "/.texmap-XXXXXX"),
        file_(mkostemp(name_.data(), O_CLOEXEC)) {
    require_success(file_.number() >= 0);
  }
  ~Draft() {
    if (!placed_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void fill(std::span<const std::uint8_t> bytes, const Target& target) {
    require_success(fchmod(file_.number(), target.permissions) == 0);
    write_all(file_, bytes);
    require_success(fsync(file_.number()) == 0 || errno == EINVAL || errno == ENOTSUP);
    require_success(file_.close());
  }

  void take_name_of(const Target& target) {
    require_success(std::rename(name_.c_str(), target.path.c_str()) == 0);
    placed_ = true;
  }

 private:
  std::string name_;
  FileDescriptor file_;
  bool placed_ = false;
};

}  // namespace

void check_writable(const std::string& path) { check_target(find_target(path)); }

void write_file_atomically(const std::string& path, std::span<const std::uint8_t> bytes) {
  const SignalGuard guard;
  const Target target = find_target(path);
  check_target(target);
  if (target.written_through) return write_through(target, bytes);
  Draft draft(target);
  draft.fill(bytes, target);
  draft.take_name_of(target);
}

}  // namespace texmap
