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

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "engine/system/shared.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

constexpr int most_links = 40;  // as many as the system itself follows
constexpr std::size_t bytes_in_piece = std::size_t{8} << 20;  // written without looking for signals

// errno; a quota that is used up is a full disk.
std::error_code last_error() { return {errno == EDQUOT ? ENOSPC : errno, std::generic_category()}; }

// Throws a FileError with the reason in errno unless a call of the system has succeeded.
void require_success(bool succeeded) {
  if (!succeeded) throw FileError(words_of(last_error()));
}

// Owns one file descriptor, never 0, 1 or 2: a program may start with these three closed. A file
// would then get one of them, and messages would be written into it.
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

  // Below 0 if the file could not be opened; errno says why.
  [[nodiscard]] int number() const { return number_; }

  // Closes now and says whether everything written before has arrived; errno says why not.
  [[nodiscard]] bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

// While it lives, a file at its size limit and a pipe without a reader are errors of the write
// instead of signals.
class QuietWrites {
 public:
  QuietWrites() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t i = 0; i < ignored.size(); ++i)
      sigaction(ignored[i], &ignore, &action_before_[i]);
  }
  ~QuietWrites() {
    for (std::size_t i = 0; i < ignored.size(); ++i)
      sigaction(ignored[i], &action_before_[i], nullptr);
  }
  QuietWrites(const QuietWrites&) = delete;
  QuietWrites& operator=(const QuietWrites&) = delete;

 private:
  static constexpr std::array<int, 2> ignored = {SIGPIPE, SIGXFSZ};
  std::array<struct sigaction, 2> action_before_{};
};

// While it lives, signals that would end or stop the program wait. All other threads must have
// ended: a signal could still end the program in one of them.
class SignalGuard {
 public:
  SignalGuard() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : ending) sigaddset(&waiting, signal);
    sigaddset(&waiting, SIGTSTP);
    pthread_sigmask(SIG_BLOCK, &waiting, &mask_before_);
  }
  ~SignalGuard() { pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr); }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

  // A signal waits that will end the program when the guard is gone. (One that is ignored, as under
  // nohup, waits too.)
  [[nodiscard]] bool end_is_near() const {
    sigset_t waiting;
    sigemptyset(&waiting);
    sigpending(&waiting);
    return std::any_of(ending.begin(), ending.end(), [&](int signal) {
      struct sigaction action {};
      return sigismember(&waiting, signal) == 1 && sigismember(&mask_before_, signal) == 0 &&
             sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
    });
  }

 private:
  static constexpr std::array<int, 7> ending = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM,
                                                SIGALRM, SIGUSR1, SIGUSR2};
  sigset_t mask_before_{};
};

// open() alone says the same about a missing file and about a link that leads nowhere.
std::string why_not_opened(const std::filesystem::path& path, const std::error_code& error) {
  if (error == std::errc::no_such_file_or_directory && std::filesystem::is_symlink(path))
    return "it is a link to a file that does not exist";
  const bool forbidden = error.value() == EACCES || error.value() == EPERM;
  return forbidden ? "no permission to read it" : words_of(error);
}

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
  errno = ELOOP;
  throw FileError(words_of(last_error()));
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

Target find_target(const std::filesystem::path& named) {
  check_name(named);
  const std::string& path = named.native();
  if (path.ends_with('/')) throw FileError("the name is that of a folder");

  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    require_success(errno == ENOENT || errno == ENOTDIR);
    return {end_of_links(path), false, false, static_cast<mode_t>(0666U & ~current_umask())};
  }
  if (S_ISDIR(status.st_mode)) throw FileError("it is a folder");
  if (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode)) return {path, true, true};
  if (!S_ISREG(status.st_mode))
    throw FileError("it is neither a file nor a device that can be written to");
  return {end_of_links(path), true, false, static_cast<mode_t>(status.st_mode & 0777U)};
}

void check_target(const Target& target) {
  if (target.exists && access(target.path.c_str(), W_OK) != 0)
    throw FileError("it cannot be written to: " + words_of(last_error()));
  if (target.written_through) return;
  const std::string folder = folder_of(target.path);
  check_folder(folder);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw FileError("the folder '" + folder + "' cannot be written to: " + words_of(last_error()));
  const std::string name = target.path.substr(target.path.rfind('/') + 1);  // npos + 1 is 0
  if (name == "." || name == "..") throw FileError("the name is that of a folder");
  const long longest = pathconf(folder.c_str(), _PC_NAME_MAX);
  if (longest > 0 && name.size() > static_cast<std::size_t>(longest)) {
    errno = ENAMETOOLONG;
    throw FileError(words_of(last_error()));
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
  // O_NONBLOCK, since opening a pipe without a reader would wait forever. Once it is open, waiting
  // for a slow reader is right.
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
      : name_(folder_of(target.path) + "/.texmap-XXXXXX"),
        file_(mkostemp(name_.data(), O_CLOEXEC)) {
    require_success(file_.number() >= 0);
  }
  ~Draft() {
    if (!placed_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  // Gives up between two pieces if the program is about to end: a large file takes seconds.
  void fill(std::span<const std::uint8_t> bytes, const Target& target, const SignalGuard& guard) {
    require_success(fchmod(file_.number(), target.permissions) == 0);
    while (!bytes.empty()) {
      if (guard.end_is_near()) throw FileError("stopped by a signal");
      const std::size_t length = std::min(bytes.size(), bytes_in_piece);
      write_all(file_, bytes.first(length));
      require_success(fsync(file_.number()) == 0 || errno == EINVAL || errno == ENOTSUP);
      bytes = bytes.subspan(length);
    }
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
  const QuietWrites quiet;
  const Target target = find_target(path);
  check_target(target);
  if (target.written_through) return write_through(target, bytes);
  const SignalGuard guard;
  Draft draft(target);
  draft.fill(bytes, target, guard);
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
}

void end_with(std::string_view message) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  _exit(1);
}

}  // namespace texmap
