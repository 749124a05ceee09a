// Draws a lesson with the wide packs that a file is compiled for. Only the files that add_chapter makes include it.
#pragma once
#include "draw.hpp"

namespace texmap {

/// Declared in draw.hpp.
///
/// The linker keeps one of several equal functions, the first it meets. Functions that calculate with packs have the packs'
/// instructions in their names and never meet others. Functions of plain numbers may, and then the main file, which comes
/// first, has the one that every machine can run; those it lacks are called from here only.
template <Instructions instructions, class Lesson>
Image draw_wide_packs(const Lesson& lesson, const View& view, Number number, const RenderSettings& settings) {
  return draw_packs<xsimd::default_arch>(lesson, view, number, settings);
}

}  // namespace texmap
