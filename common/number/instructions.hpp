// The sets of machine instructions that packs of numbers can be made of, and which of them this machine has.
#pragma once
#include <initializer_list>

namespace texmap {

/// Instructions for packs. The wider sets are compiled into files of their own (wide_packs.hpp), so that one program runs on
/// every machine and is as fast as each allows.
enum class Instructions {
  baseline,  ///< those that every machine of this kind has: SSE2 on x86-64, 16 bytes at once
  avx2,      ///< 32 bytes at once
  avx512,    ///< 64 bytes at once
};

/// True if this machine, and its operating system, can run them.
[[nodiscard]] inline bool machine_has(Instructions instructions) {
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_cpu_init();
  if (instructions == Instructions::avx2) return __builtin_cpu_supports("avx2") != 0;
  if (instructions == Instructions::avx512) {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512cd") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
  }
#endif
  return instructions == Instructions::baseline;
}

/// The widest that this machine has.
[[nodiscard]] inline Instructions widest_instructions() {
  for (const Instructions wide : {Instructions::avx512, Instructions::avx2}) {
    if (machine_has(wide)) return wide;
  }
  return Instructions::baseline;
}

}  // namespace texmap
