// The system's answers on Linux, macOS and their like.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#include <sys/sysctl.h>
#endif

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include "engine/system/shared.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

constexpr int most_links = 40;  // as many as the system itself follows

// errno; a quota that is used up is a full disk.
std::error_code last_error() { return {errno == EDQUOT ? ENOSPC : errno, std::generic_category()}; }

// Throws a FileError with the reason in errno unless a call of the system has succeeded.
void require_success(bool succeeded) {
  if (!succeeded) throw FileError(words_of(last_error()));
}

// Owns a file descriptor.
class FileDescriptor {
 public:
  explicit FileDescriptor(int opened) : number_(opened) {}
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  // Below 0 if the file could not be opened; errno says why.
  [[nodiscard]] int number() const { return number_; }

  // Closes now and says whether everything written before has arrived; errno says why not.
  [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

// While it lives, signals that would end or stop the program wait, so that no draft is left. All
// other threads must have ended: a signal could still end the program in one of them.
class SignalGuard {
 public:
  SignalGuard() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP})
      sigaddset(&waiting, signal);
    pthread_sigmask(SIG_BLOCK, &waiting, &mask_before_);
  }
  ~SignalGuard() { pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr); }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  sigset_t mask_before_{};
};

// open() alone says the same about a missing file and about a link that leads nowhere.
std::string why_not_opened(const std::filesystem::path& path, const std::error_code& error) {
  if (error == std::errc::no_such_file_or_directory && std::filesystem::is_symlink(path))
    return "it is a link to a file that does not exist";
  const bool forbidden = error.value() == EACCES || error.value() == EPERM;
  return forbidden ? "no permission to read it" : words_of(error);
}

// Where a chain of symbolic links ends; the file there need not exist.
std::filesystem::path end_of_links(std::filesystem::path path) {
  for (int link = 0; std::filesystem::is_symlink(path); ++link) {
    if (link == most_links)
      throw FileError(words_of(std::make_error_code(std::errc::too_many_symbolic_link_levels)));
    path = path.parent_path() / std::filesystem::read_symlink(path);
  }
  return path;
}

// The umask can only be read by setting it.
mode_t current_umask() {
  const mode_t mask = umask(077);
  umask(mask);
  return mask;
}

struct Target {
  std::filesystem::path path;  // after all symbolic links
  bool exists = false;
  bool written_through = false;  // a device or a pipe
  mode_t permissions = 0;
};

Target find_target(const std::filesystem::path& named) {
  check_name(named);
  if (!named.has_filename() || named.filename() == "." || named.filename() == "..")
    throw FileError("the name is that of a folder");

  struct stat status {};
  if (stat(named.c_str(), &status) != 0) {
    require_success(errno == ENOENT || errno == ENOTDIR);
    return {end_of_links(named), false, false, static_cast<mode_t>(0666U & ~current_umask())};
  }
  if (S_ISDIR(status.st_mode)) throw FileError("it is a folder");
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) return {named, true, true};
  if (!S_ISREG(status.st_mode))
    throw FileError("it is neither a file nor a device that can be written to");
  return {end_of_links(named), true, false, static_cast<mode_t>(status.st_mode & 0777U)};
}

void check_target(const Target& target) {
  if (target.exists && access(target.path.c_str(), W_OK) != 0)
    throw FileError("it cannot be written to: " + words_of(last_error()));
  if (target.written_through) return;
  const std::filesystem::path folder = folder_of(target.path);
  check_folder(folder);
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw FileError("the folder '" + name_of(folder) +
                    "' cannot be written to: " + words_of(last_error()));
  }
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
  // Opening a pipe without a reader would wait for ever without O_NONBLOCK.
  FileDescriptor file(open(target.path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  require_success(file.number() >= 0);
  const int flags = fcntl(file.number(), F_GETFL);
  require_success(flags >= 0 && fcntl(file.number(), F_SETFL, flags & ~O_NONBLOCK) >= 0);
  write_all(file, bytes);
  require_success(file.close());
}

// A temporary file in the target's folder. It is renamed to the target, or deleted.
class Draft {
 public:
  explicit Draft(const Target& target)
      : name_(folder_of(target.path) / ".texmap-XXXXXX"), file_(mkostemp(name_.data(), O_CLOEXEC)) {
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

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  check_name(path);

  // Opening a pipe would wait for a writer without O_NONBLOCK.
  FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0) throw FileError(why_not_opened(path, last_error()));

  struct stat status {};
  require_success(fstat(file.number(), &status) == 0);
  if (S_ISDIR(status.st_mode)) throw FileError("it is a folder, not a file");
  if (S_ISFIFO(status.st_mode)) throw FileError("it is a pipe, not a file");
  if (!S_ISREG(status.st_mode)) throw FileError("it is a device, not a file");
  return read_whole(static_cast<std::uint64_t>(status.st_size), most_bytes,
                    [&file](std::uint8_t* to, std::size_t bytes) {
                      ssize_t got = -1;
                      do {
                        got = read(file.number(), to, bytes);
                      } while (got < 0 && errno == EINTR);
                      require_success(got >= 0);
                      return static_cast<std::size_t>(got);
                    });
}

void check_writable(const std::filesystem::path& path) { check_target(find_target(path)); }

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const Target target = find_target(path);
  check_target(target);
  if (target.written_through) return write_through(target, bytes);
  const SignalGuard guard;
  Draft draft(target);
  draft.fill(bytes, target);
  draft.take_name_of(target);
}

std::filesystem::path program_folder() {
  std::array<char, PATH_MAX> path{};
#ifdef __APPLE__
  std::uint32_t size = path.size();
  if (_NSGetExecutablePath(path.data(), &size) != 0) return {};
#else
  if (readlink("/proc/self/exe", path.data(), path.size() - 1) <= 0) return {};
#endif
  return std::filesystem::path(path.data()).parent_path();
}

std::filesystem::path folder_in_environment(const char* variable) {
  const char* const folder = std::getenv(variable);
  return folder == nullptr ? "" : folder;
}

double thread_milliseconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

std::string processor_name() {
#ifdef __APPLE__
  std::array<char, 256> name{};
  std::size_t size = name.size() - 1;
  if (sysctlbyname("machdep.cpu.brand_string", name.data(), &size, nullptr, 0) == 0)
    return name.data();
#endif
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

double system_load() {
  double load = -1;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

bool stderr_is_watched() { return isatty(STDERR_FILENO) == 1; }

std::vector<std::string> typed_words(int argc, const char* const* argv) {
  return {argv + (argc > 0 ? 1 : 0), argv + argc};
}

void secure_standard_streams() {
  // open() returns the lowest free number, so this order fills the gaps.
  for (int stream = 0; stream <= 2; ++stream) {
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
      [[maybe_unused]] const int opened =
          open("/dev/null", O_RDWR);  // NOLINT: stays open as long as the program runs
    }
  }
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);  // a file at its size limit is an error of the write
}

void end_with(std::string_view message) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  _exit(1);
}

}  // namespace texmap
