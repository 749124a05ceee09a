// The words of --number and --instructions, and which of them this program and machine have.
#pragma once
#include <array>
#include <cstddef>

#include "engine/draw/settings.hpp"

namespace texmap {

// As the options --number and --instructions have them.
[[nodiscard]] constexpr const char* name_of(NumberKind number) {
  return std::array{"float", "double", "extended", "float-pack", "double-pack", "interval"}
      [static_cast<std::size_t>(number)];
}
[[nodiscard]] constexpr const char* name_of(Instructions instructions) {
  return std::array{"baseline", "avx2", "avx512"}[static_cast<std::size_t>(instructions)];
}

[[nodiscard]] constexpr bool is_pack(NumberKind number) {
  return number == NumberKind::float_pack || number == NumberKind::double_pack;
}
[[nodiscard]] constexpr bool is_float(NumberKind number) {
  return number == NumberKind::float_ || number == NumberKind::float_pack;
}

inline constexpr std::array all_instructions = {Instructions::baseline, Instructions::avx2,
                                                Instructions::avx512};

/// True if this program has packs of them and this machine can run them. (Each file for itself:
/// only those of a program with wide packs are compiled with TEXMAP_WIDE_PACKS.)
[[nodiscard]] static inline bool has_packs_of(Instructions instructions) {
#ifdef TEXMAP_WIDE_PACKS
  return machine_has(instructions);
#else
  return instructions == Instructions::baseline;
#endif
}

}  // namespace texmap
