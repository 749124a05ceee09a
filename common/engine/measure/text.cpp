// Numbers in sentences.
#include "engine/measure/text.hpp"

#include <cstdarg>
#include <cstdio>

namespace texmap {

std::string text(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::va_list again;
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string result(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  std::vsnprintf(result.data(), result.size() + 1, format, again);
  va_end(again);
  return result;
}

std::string escaped_markup(const std::string& plain) {
  std::string markup;
  for (const char c : plain) {
    if (c == '&') {
      markup += "&amp;";
    } else if (c == '<') {
      markup += "&lt;";
    } else if (c == '>') {
      markup += "&gt;";
    } else if (c == '"') {
      markup += "&quot;";
    } else {
      markup += c;
    }
  }
  return markup;
}

}  // namespace texmap
