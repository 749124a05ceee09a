// Running a program and reading what it says.
#pragma once
#ifndef _WIN32
#include <sys/wait.h>
#endif

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "engine/files/load_image.hpp"
#include "support/temporary_folder.hpp"

namespace texmap::test {

/// What a program left behind.
struct Outcome {
  int status = -1;  ///< its exit status; -1 if a signal ended it
  std::string out;  ///< what it wrote to stdout
  std::string err;  ///< what it wrote to stderr
};

/// Runs a program: on Windows a line of cmd, elsewhere of sh. Double quotes serve both.
[[nodiscard]] inline Outcome run(const std::string& command) {
  const TemporaryFolder folder;
  const std::string streams = " >\"" + (folder / "out") + "\" 2>\"" + (folder / "err") + "\"";
#ifdef _WIN32
  const int status = std::system(("\"" + command + streams + "\"").c_str());
#else
  const int result = std::system(("{ " + command + "; }" + streams).c_str());
  const int status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
#endif
  return {status, text_in(folder / "out"), text_in(folder / "err")};
}

/// The picture that a program draws with these options.
[[nodiscard]] inline Image drawn_by(const std::string& program, const std::string& options) {
  const TemporaryFolder folder;
  const std::string file = folder / "new folder/picture.png";
  const Outcome outcome = run("\"" + program + "\" " + options + " --out \"" + file + "\"");
  if (outcome.status != 0) throw std::runtime_error(outcome.err);
  return load_image(file);
}

}  // namespace texmap::test
