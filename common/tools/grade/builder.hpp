// Building and running the chapters of checkouts: build_and_run.py does it, this starts it and
// reads what it finds out.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/system/file_error.hpp"

namespace texmap::grade {

/// A chapter of a student that is to be built, run and tested.
struct Task {
  std::string id;                  ///< unique, without blanks
  std::filesystem::path checkout;  ///< the folder that holds chapters/
  std::string item;
};

/// What became of a task; the columns of results.tsv. Numbers are as written there.
struct TaskResult {
  std::string id, item;
  std::string containment;  ///< bwrap, unshare or none
  std::string build, run;
  std::string cpu_seconds, limit_cpu_seconds;
  std::filesystem::path picture, expected, hidden_picture, hidden_expected;
  std::string tests_passed, tests_run;
  bool cached = false;
  std::string note;
};

/// The builder refused, and said why on standard error.
class AlreadySaid : public FileError {
 public:
  using FileError::FileError;
};

/// A field of results.tsv, where \t, \n and \\ are a tab, a line end and a backslash.
[[nodiscard]] std::string unescaped_field(std::string_view field);

/// A line of results.tsv. Errors: FileError if it has too few fields.
[[nodiscard]] TaskResult task_result(std::string_view line);

/// Where and how tasks are run.
struct Builder {
  std::filesystem::path program;     ///< build_and_run.py, or any program with its interface
  std::filesystem::path tree;        ///< the instructor's checkout
  std::filesystem::path work;        ///< a folder for what is built, kept for the next time
  std::vector<std::string> options;  ///< such as --no-tests

  /// Runs the tasks and calls `take` for each as it ends, until `stopped` says so.
  ///
  /// Errors: FileError with a remedy, if the program cannot be run here or does not run to its end;
  /// AlreadySaid.
  void run(const std::vector<Task>& tasks, const std::function<void(const TaskResult&)>& take,
           const std::function<bool()>& stopped) const;
};

}  // namespace texmap::grade
