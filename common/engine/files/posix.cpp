// The system's answers on Linux, macOS and their like.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
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
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <system_error>

#include "engine/files/shared.hpp"
#include "engine/files/system.hpp"

namespace texmap {
namespace {

constexpr int most_links = 40;  // as many as the system itself follows

// What errno says; a quota that is used up is a full disk.
std::string last_words() {
  return words_of({errno == EDQUOT ? ENOSPC : errno, std::generic_category()});
}

std::string_view called;  // the program's name, as it was called

// The program's file by that name, as the shell found it; empty if it is not there.
std::filesystem::path file_of_call() {
  std::error_code error;
  if (called.find('/') != std::string::npos) return std::filesystem::canonical(called, error);
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / called;
    if (access(file.c_str(), X_OK) == 0) return std::filesystem::canonical(file, error);
  }
  return {};
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

// The number of an open file that a path names, such as /dev/stdout: what was opened may have been
// opened for appending. None for other paths.
std::optional<int> open_file_of(std::filesystem::path named) {
  std::error_code error;
  for (int link = 0; link <= most_links && !error && (link == 0 || named.is_absolute()); ++link) {
    const std::string path = named.lexically_normal().string();
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
      const std::string number = path.starts_with(folder) ? path.substr(folder.size()) : "";
      if (!number.empty() && number.size() < 6 &&
          number.find_first_not_of("0123456789") == std::string::npos)
        return std::stoi(number);
    }
    named = std::filesystem::read_symlink(named, error);
  }
  return std::nullopt;
}

// A file that can be written, as far as one can tell before.
struct Target {
  std::filesystem::path path;                // after all symbolic links
  bool device = false;                       // or a pipe: written to, not replaced
  std::optional<struct stat> replaced = {};  // the file that is
  std::optional<int> open = {};              // it is open already
};

Target find_target(const std::filesystem::path& named) {
  check_name(named);
  if (!named.has_filename() || named.filename() == "." || named.filename() == "..")
    throw FileError("the name is that of a folder");
  if (const std::optional<int> number = open_file_of(named)) {
    const int mode = fcntl(*number, F_GETFL);
    if (mode < 0 || (mode & O_ACCMODE) == O_RDONLY)
      throw FileError(mode < 0 ? "no file with this number is open" : "it was opened for reading");
    return {.path = named, .device = true, .open = number};
  }
  struct stat status {};
  const bool exists = stat(named.c_str(), &status) == 0;
  if (!exists && errno != ENOENT && errno != ENOTDIR) throw FileError(last_words());
  if (exists && S_ISDIR(status.st_mode)) throw FileError("it is a folder");
  const bool device = exists && (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode));
  if (exists && !device && !S_ISREG(status.st_mode))
    throw FileError("it is neither a file nor a device that can be written to");
  const std::filesystem::path path = device ? named : end_of_links(named);
  if (exists && access(path.c_str(), W_OK) != 0)
    throw FileError("it cannot be written to: " + last_words());
  if (device) return {.path = path, .device = true};
  const std::filesystem::path folder = folder_of(path);
  check_folder(folder);
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw FileError("the folder '" + name_of(folder) + "' cannot be written to: " + last_words());
  if (!exists) return {path};
  return {.path = path, .replaced = status};
}

// Gives a file the owner and mode of another. Only root can give a file away: else it is ours.
bool is_made_alike(const std::filesystem::path& file, const struct stat& other) {
  static_cast<void>(chown(file.c_str(), other.st_uid, other.st_gid) == 0);
  return chmod(file.c_str(), other.st_mode & 0777U) == 0;
}

// Writes to a file that was opened, or null; false with the reason in errno.
bool write_and_close(std::FILE* file, std::span<const std::uint8_t> bytes) {
  if (file == nullptr) return false;
  std::setbuf(file, nullptr);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = reason;
  return written && closed;
}

// Opening a pipe without a reader would wait for ever without O_NONBLOCK.
std::FILE* open_device(const std::filesystem::path& path) {
  const int opened = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (opened < 0) return nullptr;
  fcntl(opened, F_SETFL, fcntl(opened, F_GETFL) & ~O_NONBLOCK);
  return fdopen(opened, "wb");
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  check_name(path);
  const auto refuse = [&path] {
    if (errno == ENOENT && std::filesystem::is_symlink(path))
      throw FileError("it is a link to a file that does not exist");
    throw FileError(errno == EACCES || errno == EPERM ? "no permission to read it" : last_words());
  };
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) refuse();
  if (S_ISDIR(status.st_mode)) throw FileError("it is a folder, not a file");
  if (S_ISFIFO(status.st_mode)) throw FileError("it is a pipe, not a file");
  if (!S_ISREG(status.st_mode)) throw FileError("it is a device, not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  // Another file may have got the name since: the size is that of the one that is open.
  if (!file || fstat(fileno(file.get()), &status) != 0) refuse();
  return read_whole(static_cast<std::uint64_t>(status.st_size), most_bytes,
                    [&file](std::uint8_t* to, std::size_t bytes) {
                      const std::size_t got = std::fread(to, 1, bytes, file.get());
                      if (std::ferror(file.get()) != 0) throw FileError(last_words());
                      return got;
                    });
}

bool is_stream(const std::filesystem::path& path) {
  std::error_code error;
  return open_file_of(path) ||
         (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error));
}

bool is_standard_output(const std::filesystem::path& path) {
  return open_file_of(path) == STDOUT_FILENO;
}

void check_writable(const std::filesystem::path& path) { static_cast<void>(find_target(path)); }

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const Target target = find_target(path);
  if (target.device) {
    std::fflush(stdout);
    std::FILE* const file =
        target.open ? fdopen(dup(*target.open), "wb") : open_device(target.path);
    if (!write_and_close(file, bytes)) throw FileError(last_words());
    return;
  }
  // Beside the file, and then renamed. Ctrl-C waits for that, so that it leaves no draft behind.
  const std::filesystem::path draft =
      folder_of(target.path) / (".texmap-" + std::to_string(std::random_device()()));
  sigset_t ending, before;
  sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
  pthread_sigmask(SIG_BLOCK, &ending, &before);
  const bool done = write_and_close(std::fopen(draft.c_str(), "wb"), bytes) &&
                    (!target.replaced || is_made_alike(draft, *target.replaced)) &&
                    std::rename(draft.c_str(), target.path.c_str()) == 0;
  const int reason = errno;
  if (!done) std::remove(draft.c_str());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (done) return;
  errno = reason;
  throw FileError(last_words());
}

std::filesystem::path program_folder() {
  std::array<char, PATH_MAX> path{};
#ifdef __APPLE__
  std::uint32_t size = path.size();
  if (_NSGetExecutablePath(path.data(), &size) != 0) return {};
#else
  if (readlink("/proc/self/exe", path.data(), path.size() - 1) <= 0)
    return file_of_call().parent_path();
#endif
  std::error_code unknown;  // macOS may name a link
  const std::filesystem::path real = std::filesystem::canonical(path.data(), unknown);
  return (real.empty() ? std::filesystem::path(path.data()) : real).parent_path();
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

std::uint64_t free_memory() {
  // The first number after a word of a file of the system; without a word, at its beginning.
  const auto number_in = [](const char* name, const std::string& word) {
    std::ifstream file(name);
    for (std::string found; word.empty() || file >> found;) {
      if (found == word) break;
    }
    std::uint64_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt;
  };
  std::uint64_t least = ~std::uint64_t{0};
  if (const auto there = number_in("/proc/meminfo", "MemAvailable:")) least = *there << 10;
  // What a container may have in all.
  if (const auto most = number_in("/sys/fs/cgroup/memory.max", "")) least = std::min(least, *most);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    const std::uint64_t used = number_in("/proc/self/status", "VmSize:").value_or(0) << 10;
    least = std::min<std::uint64_t>(least,
                                    limit.rlim_cur - std::min<std::uint64_t>(used, limit.rlim_cur));
  }
  return least;
}

double system_load() {
  double load = -1;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

bool stderr_is_watched() { return isatty(STDERR_FILENO) == 1; }

std::vector<std::string> typed_words(int argc, const char* const* argv) {
  if (argc > 0) called = argv[0];
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
