// Numbers in sentences.
#pragma once
#include <array>
#include <cstdarg>
#include <cstdio>
#include <string>

namespace texmap::steps {

/// What printf would print, at most 400 characters of it. The compiler checks the values against the format.
[[nodiscard, gnu::format(printf, 1, 2)]] inline std::string form(const char* format, ...) {
  std::array<char, 400> text{};
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text.data(), text.size(), format, values);
  va_end(values);
  return text.data();
}

}  // namespace texmap::steps
