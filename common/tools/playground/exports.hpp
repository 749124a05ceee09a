// How a page and a module talk: functions that the page calls, memory for what it hands over, texts
// that end with a zero byte. A text that begins with ! says what went wrong.
#pragma once
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#define EXPORTED(name) extern "C" __attribute__((export_name(#name)))

/// Memory for what the page hands over; the page gives it back.
EXPORTED(take) void* take(int bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }
EXPORTED(give_back) void give_back(void* memory) { std::free(memory); }

namespace texmap::live {

/// The text that `work` returns, or why it failed; valid until the next call.
template <class Work>
const char* answer(const Work& work) {
  static std::string text;
  try {
    text = work();
  } catch (const std::bad_alloc&) {
    text = "!there is not enough memory for this";
  } catch (const std::exception& error) {
    text = std::string("!") + error.what();
  }
  return text.c_str();
}

}  // namespace texmap::live
