// Whole programs, timed alternately.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "bench.hpp"
#include "support/temporary_folder.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): unistd.h need not declare it

namespace texmap::bench {
namespace {

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

Group measure_beside(const std::vector<std::string>& commands, const Effort& effort,
                     const Report& report) {
  const test::TemporaryFolder pictures;
  std::vector<std::string> names = commands;
  std::vector<std::string> lines = commands;
  for (const std::string name : TEXMAP_CHAPTER_NAMES) {
    names.push_back(name);
    lines.push_back("'" TEXMAP_BIN_DIR "/" + name + "' --quiet --threads 1 --out '" +
                    (pictures / (name + ".png")) + "'");
  }

  std::vector<double> processor(lines.size(), std::numeric_limits<double>::infinity());
  std::vector<Work> works;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    works.emplace_back(
        [&, i] { processor[i] = std::min(processor[i], processor_milliseconds(lines[i])); });
  }
  const int rounds = rounds_within(20e3 * effort.part, works, effort.least, 200);
  const std::vector<WorkTime> wall = work_times(works, rounds, report);

  Group group{.name = "beside", .title = "Whole programs", .unit = "ms"};
  const auto add = [&](const std::string& column, const auto& time_of) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      group.rows.push_back({.line = names[i],
                            .column = column,
                            .set = column,
                            .time = time_of(i),
                            .ratio = time_of(0) / time_of(i)});
    }
  };
  add("wall clock", [&](std::size_t i) { return wall[i].wall; });
  add("user and system", [&](std::size_t i) { return processor[i]; });
  return group;
}

}  // namespace texmap::bench
