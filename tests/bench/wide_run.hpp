// Does jobs with the wide packs that a file is compiled for. Only the files made of wide_*.cpp.in include it.
#pragma once
#include "ways.hpp"

namespace texmap::bench {

/// Declared in ways.hpp; common/app/wide_packs.hpp says why the linker cannot mix these functions up with others.
template <Instructions instructions, class Job>
void run_wide_packs(const Job& job, Number number) {
  run_packs<xsimd::default_arch>(job, number);
}

}  // namespace texmap::bench
