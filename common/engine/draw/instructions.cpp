// Detects the machine's instruction sets.

#include "engine/draw/settings.hpp"

namespace texmap {

bool machine_has(Instructions instructions) {
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

Instructions widest_instructions() {
  for (const Instructions wide : {Instructions::avx512, Instructions::avx2}) {
    if (machine_has(wide)) return wide;
  }
  return Instructions::baseline;
}

}  // namespace texmap
