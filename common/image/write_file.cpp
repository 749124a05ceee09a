// A whole file, written so that nobody ever sees a part of it.
#include "write_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include "file_descriptor.hpp"
#include "image_error.hpp"
#include "signal_guard.hpp"
#include "system_words.hpp"

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
  throw Refusal(system_words(ELOOP));
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
  if (path.empty()) throw Refusal("the name is empty");
  if (path.find('\0') != std::string::npos) throw Refusal("the name has a zero byte in it");
  if (path.ends_with('/')) throw Refusal("the name is that of a folder");

  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) throw Refusal(system_words(errno));
    return {end_of_links(path), false, false, 0666U & ~current_umask()};
  }
  if (S_ISDIR(status.st_mode)) throw Refusal("it is a folder");
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) return {path, true, true};
  if (!S_ISREG(status.st_mode)) throw Refusal("it is neither a file nor a device that can be written to");
  return {end_of_links(path), true, false, status.st_mode & 0777U};
}

void check_folder(const std::string& folder) {
  struct stat status {};
  if (stat(folder.c_str(), &status) != 0) {
    if (errno == ENOENT) throw Refusal("the folder '" + folder + "' does not exist");
    throw Refusal(system_words(errno));
  }
  if (!S_ISDIR(status.st_mode)) throw Refusal("'" + folder + "' is a file, not a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Refusal("the folder '" + folder + "' cannot be written to: " + system_words(errno));
  }
}

void check_target(const Target& target) {
  if (target.exists && access(target.path.c_str(), W_OK) != 0) throw Refusal("it cannot be written to: " + system_words(errno));
  if (target.written_through) return;
  check_folder(folder_of(target.path));
  const std::string name = target.path.substr(target.path.rfind('/') + 1);  // npos + 1 is 0
  if (name == "." || name == "..") throw Refusal("the name is that of a folder");
  const long longest = pathconf(folder_of(target.path).c_str(), _PC_NAME_MAX);
  if (longest > 0 && name.size() > static_cast<std::size_t>(longest)) throw Refusal(system_words(ENAMETOOLONG));
}

void write_all(const FileDescriptor& file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw Refusal(system_words(errno));
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void write_through(const Target& target, std::span<const std::uint8_t> bytes) {
  // A pipe that nobody reads would make a blocking open wait for ever; once open, waiting for a slow reader is right.
  FileDescriptor file(open(target.path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0) throw Refusal(system_words(errno));
  const int flags = fcntl(file.number(), F_GETFL);
  if (flags < 0 || fcntl(file.number(), F_SETFL, flags & ~O_NONBLOCK) < 0) throw Refusal(system_words(errno));
  write_all(file, bytes);
  if (!file.close()) throw Refusal(system_words(errno));
}

// A new file beside the target, which is gone again unless it takes the target's name.
class Draft {
 public:
  explicit Draft(const Target& target)
      : name_(folder_of(target.path) + "/.texmap-XXXXXX"), file_(mkostemp(name_.data(), O_CLOEXEC)) {
    if (file_.number() < 0) throw Refusal(system_words(errno));
  }
  ~Draft() {
    if (!placed_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void fill(std::span<const std::uint8_t> bytes, const Target& target) {
    if (fchmod(file_.number(), target.permissions) != 0) throw Refusal(system_words(errno));
    write_all(file_, bytes);
    if (fsync(file_.number()) != 0 && errno != EINVAL && errno != ENOTSUP) throw Refusal(system_words(errno));
    if (!file_.close()) throw Refusal(system_words(errno));
  }

  void take_name_of(const Target& target) {
    if (std::rename(name_.c_str(), target.path.c_str()) != 0) throw Refusal(system_words(errno));
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
