// Running a program and reading what it says.
#pragma once
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/temporary_folder.hpp"

namespace texmap::test {

/// What a program left behind.
struct Outcome {
  int status = -1;  ///< its exit status; -1 if a signal ended it
  std::string out;  ///< what it wrote to stdout
  std::string err;  ///< what it wrote to stderr
};

/// Runs a line of the shell.
[[nodiscard]] inline Outcome run(const std::string& command) {
  const TemporaryFolder folder;
  const int result = std::system(
      ("{ " + command + "; } >'" + (folder / "out") + "' 2>'" + (folder / "err") + "'").c_str());
  const auto text = [&folder](const char* name) {
    const std::vector<std::uint8_t> bytes = bytes_of(folder / name);
    return std::string(bytes.begin(), bytes.end());
  };
  return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, text("out"), text("err")};
}

}  // namespace texmap::test
