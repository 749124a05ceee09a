// The numbers that works are timed with: plain ones, and packs made of each set of instructions.
#pragma once
#include <array>
#include <string_view>
#include <type_traits>

#include "draw.hpp"

namespace texmap::bench {

/// A number, and the instructions that packs of it are made of: a column of a table.
struct Way {
  std::string_view name;
  Number number;
  Instructions instructions = Instructions::baseline;
};

inline constexpr Way in_float{"float", Number::float_};
inline constexpr Way in_double{"double", Number::double_};
inline constexpr Way in_extended{"extended", Number::extended};
inline constexpr std::array in_float_packs = {
    Way{"float-pack baseline", Number::float_pack, Instructions::baseline},
    Way{"float-pack avx2", Number::float_pack, Instructions::avx2},
    Way{"float-pack avx512", Number::float_pack, Instructions::avx512},
};
inline constexpr std::array in_double_packs = {
    Way{"double-pack baseline", Number::double_pack, Instructions::baseline},
    Way{"double-pack avx2", Number::double_pack, Instructions::avx2},
    Way{"double-pack avx512", Number::double_pack, Instructions::avx512},
};

/// True if this build has code for it and this machine can run it.
[[nodiscard]] inline bool is_here(const Way& way) {
  if (way.number != Number::float_pack && way.number != Number::double_pack) return true;
#ifdef TEXMAP_HAVE_PACKS
#ifdef TEXMAP_WIDE_PACKS
  return machine_has(way.instructions);
#else
  return way.instructions == Instructions::baseline;
#endif
#else
  return false;
#endif
}

/// The widest packs of double that can be run here.
[[nodiscard]] inline Way widest_double_pack() {
  Way widest = in_double_packs[0];
  for (const Way& way : in_double_packs) {
    if (is_here(way)) widest = way;
  }
  return {"double-pack", Number::double_pack, widest.instructions};
}

/// A job that is done in double only: packs of float are not compiled for it.
template <class Job>
concept DoubleOnly = Job::double_only;

#ifdef TEXMAP_HAVE_PACKS
/// A job that draws pictures, for which packs are taken by twos.
template <class Job>
concept DrawsPictures = Job::draws_pictures;

/// What a job's packs are.
template <class Job, class Pack>
using PacksOf = std::conditional_t<DrawsPictures<Job>, Paired<Pack>, Pack>;

/// Does a job with packs made of the instructions that the file is compiled for.
///
/// @tparam Job  has run<Real>(), which does the work
template <class Arch, class Job>
void run_packs(const Job& job, Number number) {
  if (number == Number::double_pack) {
    job.template run<PacksOf<Job, Pack<double, Arch>>>();
  } else if constexpr (!DoubleOnly<Job>) {
    job.template run<PacksOf<Job, Pack<float, Arch>>>();
  }
}

/// The same with other instructions: defined in files compiled for them (wide_*.cpp.in), for each job by name.
template <Instructions instructions, class Job>
void run_wide_packs(const Job& job, Number number);
#endif

/// Does a job with the number of `way`, which is_here().
template <class Job>
void run(const Job& job, const Way& way) {
  switch (way.number) {
    case Number::float_:
      if constexpr (!DoubleOnly<Job>) job.template run<float>();
      return;
    case Number::double_:
      job.template run<double>();
      return;
    case Number::float_pack:
    case Number::double_pack:
#ifdef TEXMAP_HAVE_PACKS
#ifdef TEXMAP_WIDE_PACKS
      if (way.instructions == Instructions::avx512) return run_wide_packs<Instructions::avx512>(job, way.number);
      if (way.instructions == Instructions::avx2) return run_wide_packs<Instructions::avx2>(job, way.number);
#endif
      run_packs<xsimd::default_arch>(job, way.number);
#endif
      return;
    case Number::extended:
    case Number::interval:
      return;  // no work is timed with these but whole pictures, by draw()
  }
}

}  // namespace texmap::bench
