// Another program that runs while this one goes on.
#include "process.hpp"

#include "engine/system/file_error.hpp"

#ifdef _WIN32

namespace texmap::grade {

Process::Process(std::vector<std::string> /*words*/) {
  throw FileError("this needs Linux or another POSIX system");
}
Process::~Process() = default;
bool Process::runs() { return false; }
int Process::end() { return -1; }

}  // namespace texmap::grade

#else

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>

extern char** environ;  // POSIX has it, and no header says so everywhere

namespace texmap::grade {

Process::Process(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int failed =
      posix_spawnp(&id_, arguments[0], nullptr, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (failed == 0) return;
  id_ = -1;
  throw FileError(words[0] + " cannot be started: " + std::strerror(failed));
}

Process::~Process() { end(); }

bool Process::runs() {
  if (id_ > 0 && waitpid(id_, &status_, WNOHANG) == id_) id_ = -1;
  return id_ > 0;
}

int Process::end() {
  if (id_ > 0) {
    kill(id_, SIGTERM);
    while (waitpid(id_, &status_, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
  }
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

}  // namespace texmap::grade

#endif
