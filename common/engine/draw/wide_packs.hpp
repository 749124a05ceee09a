// Runs a work with the wide packs of a file. Programs get it from wide_packs.cpp.in alone.
#pragma once
#include <stdexcept>

#include "engine/draw/draw.hpp"

namespace texmap {

/// Declared in draw.hpp.
/// Functions of packs have their instructions in their names, so the linker never mixes them up. Of
/// functions of plain numbers it keeps the main file's, which every machine can run.
template <Instructions instructions, class Work>
typename Work::Result run_in_wide_packs([[maybe_unused]] const Work& work,
                                        [[maybe_unused]] NumberKind number) {
  if constexpr (Work::for_packs) {
    return run_in_packs<simd::default_arch>(work, number);
  } else {
    throw std::logic_error("a lesson that does not run on packs was drawn with them");
  }
}

}  // namespace texmap
