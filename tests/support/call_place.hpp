// Where a check is called: std::source_location, which clang++ 14 lacks with g++'s library.
#pragma once

namespace texmap::test {

struct CallPlace {
  const char* file = "";
  int line = 0;

  /// As a default argument: the line of the call.
  [[nodiscard]] static constexpr CallPlace current(const char* file = __builtin_FILE(),
                                                   int line = __builtin_LINE()) {
    return {file, line};
  }
};

}  // namespace texmap::test
