// What a function does with arguments that it cannot take.
#pragma once
#include <string>

namespace texmap {
/// Throws std::invalid_argument; a program that is compiled without exceptions ends.
[[noreturn]] void refuse_argument(const std::string& why);
}  // namespace texmap
