// Whole programs, timed alternately.
#include "processes.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>

#include "engine/measure/interleaved.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): unistd.h need not declare it

namespace texmap::bench {
namespace {

/// A folder for the chapters' pictures, removed with all that is in it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "texmap-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs a line of the shell, its output thrown away.
/// @return  the processor's time that it and its children took, user and system, in milliseconds
double processor_milliseconds(const std::string& command) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::string shell = "sh";
  std::string option = "-c";
  std::string line = command;
  char* const words[] = {shell.data(), option.data(), line.data(), nullptr};
  pid_t child = 0;
  const int refused = posix_spawn(&child, "/bin/sh", &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (refused != 0) throw std::runtime_error("cannot run /bin/sh");
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child)
    throw std::runtime_error("cannot wait for: " + command);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("this command failed: " + command);
  const auto milliseconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_usec) / 1e3;
  };
  return milliseconds(used.ru_utime) + milliseconds(used.ru_stime);
}

}  // namespace

Measured measure_beside(const std::vector<std::string>& commands, const Effort& effort,
                        const std::function<void(double)>& report) {
  const Folder pictures;
  std::vector<std::string> names = commands;
  std::vector<std::string> lines = commands;
  for (const std::string name : TEXMAP_CHAPTER_NAMES) {
    names.push_back(name);
    lines.push_back("'" TEXMAP_BIN_DIR "/" + name + "' --quiet --threads 1 --out '" +
                    (pictures.path() / (name + ".png")).string() + "'");
  }

  std::vector<double> processor(lines.size(), std::numeric_limits<double>::infinity());
  std::vector<Work> works;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    works.emplace_back(
        [&, i] { processor[i] = std::min(processor[i], processor_milliseconds(lines[i])); });
  }
  const int rounds = rounds_within(20e3 * effort.part, works, effort.least, 200);
  const std::vector<WorkTime> wall = work_times(works, rounds, [&](int done, int runs) {
    if (report) report(static_cast<double>(done) / runs);
  });

  Measured measured{{.name = "beside",
                     .title = "Whole programs",
                     .text = "",
                     .unit = "ms",
                     .ratio = Ratio::speed,
                     .seconds = 20,
                     .note = "",
                     .rows = {}},
                    {}};
  for (const bool by_wall : {false, true}) {
    const auto time_of = [&](std::size_t i) { return by_wall ? wall[i].wall : processor[i]; };
    const std::size_t base = measured.timings.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string column = by_wall ? "wall clock" : "user and system";
      measured.group.rows.push_back(
          {.line = names[i], .column = column, .set = column, .prepare = {}});
      measured.timings.push_back(
          {.time = time_of(i), .ratio = time_of(0) / time_of(i), .base = base});
    }
  }
  return measured;
}

}  // namespace texmap::bench
