// Where something is measured, and how it was compiled: a time means little without them.
#pragma once
#include <string>
#include <vector>

#include "engine/files/json.hpp"

namespace texmap {

/// A machine and a compiler.
struct Machine {
  std::string processor, compiler;
  std::string flags;                      ///< what the measured code was compiled with
  std::vector<std::string> instructions;  ///< that packs are made of
  int processors = 0;                     ///< that programs can use at once
  double load = -1;  ///< programs that wanted one, over the last minute; below 0: unknown

  /// Such as: AMD EPYC, 2 processors, load 0.3; g++ 12.2.0 -O3; packs of baseline, avx2.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Json json() const;
};

/// This machine as it is now, and the compiler of this library.
///
/// @param flags         of the code that is measured
/// @param instructions  that its packs are made of
[[nodiscard]] Machine this_machine(const std::string& flags,
                                   const std::vector<std::string>& instructions);

}  // namespace texmap
