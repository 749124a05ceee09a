// Runs a work with the wide packs of a file. Only files made from wide_packs.cpp.in include it.
#pragma once
#include "engine/render/draw.hpp"

namespace texmap {

/// Declared in draw.hpp.
/// Functions of packs have their instructions in their names, so the linker never mixes them up. Of
/// functions of plain numbers it keeps the main file's, which every machine can run.
template <Instructions instructions, class Work>
typename Work::Result run_in_wide_packs(const Work& work, NumberKind number) {
  return run_in_packs<simd::default_arch>(work, number);
}

}  // namespace texmap
