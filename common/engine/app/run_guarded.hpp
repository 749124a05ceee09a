// What every main program does with errors.
#pragma once
#include <functional>

namespace texmap {

class CommandLine;

/// Makes running out of memory end with a message and status 1. Called before anything else.
void expect_little_memory();

/// Calls `body` and turns what it throws into a message on stderr and an exit status: 1 for
/// failures, 2 for a wrong command line.
[[nodiscard]] int run_guarded(const CommandLine& line, const std::function<void()>& body);

}  // namespace texmap
