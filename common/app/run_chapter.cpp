// Runs a chapter: turns what went wrong into a message and an exit status.
#include "run_chapter.hpp"

#include <cstdio>
#include <exception>
#include <new>

#include "standard_streams.hpp"

namespace texmap {
namespace {

void complain(const std::string& what) { std::fputs(("error: " + what + "\n").c_str(), stderr); }

}  // namespace

int run_guarded(const CommandLine& line, const std::function<void()>& body) {
  secure_standard_streams();
  try {
    body();
    return 0;
  } catch (const UsageError& error) {
    complain(std::string(error.what()) + "\n" + line.usage());
    return 2;
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return 1;
}

}  // namespace texmap
