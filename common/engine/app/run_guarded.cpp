// What every main program does with errors: a message and an exit status.
#include "engine/app/run_guarded.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "engine/app/command_line.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

void complain(const std::string& what) { std::fputs(("error: " + what + "\n").c_str(), stderr); }

/// Called when there is not even the memory to throw an exception.
[[noreturn]] void give_up() {
  if (std::current_exception()) {
    try {
      throw;
    } catch (const std::bad_alloc&) {  // libc++ keeps some memory for this exception
    } catch (...) {
      std::abort();
    }
  }
  end_with("error: not enough memory\n");
}

}  // namespace

void expect_little_memory() { std::set_terminate(give_up); }

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
