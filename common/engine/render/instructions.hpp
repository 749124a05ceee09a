// The instruction sets that packs are compiled for, and which of them this machine has.
#pragma once

namespace texmap {

/// Instruction sets for packs. Wider ones are compiled in files of their own (wide/), so that one
/// program runs on every machine.
enum class Instructions {
  baseline,  ///< on every machine of this kind: SSE2 on x86-64, 16 bytes at once
  avx2,      ///< 32 bytes at once
  avx512,    ///< 64 bytes at once
};

/// True if this machine and its operating system support them.
[[nodiscard]] bool machine_has(Instructions instructions);

/// The widest that this machine has.
[[nodiscard]] Instructions widest_instructions();

}  // namespace texmap
