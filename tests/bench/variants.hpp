// The numbers that works are timed with: plain ones, and packs made of each set of instructions.
#pragma once
#include <array>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "engine/render/draw.hpp"
#include "engine/render/number_names.hpp"

namespace texmap::bench {

/// A number, and the instructions that packs of it are made of: a column of a table.
struct Variant {
  std::string_view name;
  NumberKind number;
  Instructions instructions = Instructions::baseline;
};

inline constexpr Variant in_float{"float", NumberKind::float_};
inline constexpr Variant in_double{"double", NumberKind::double_};
inline constexpr Variant in_extended{"extended", NumberKind::extended};
inline constexpr std::array in_float_packs = {
    Variant{"float-pack baseline", NumberKind::float_pack, Instructions::baseline},
    Variant{"float-pack avx2", NumberKind::float_pack, Instructions::avx2},
    Variant{"float-pack avx512", NumberKind::float_pack, Instructions::avx512},
};
inline constexpr std::array in_double_packs = {
    Variant{"double-pack baseline", NumberKind::double_pack, Instructions::baseline},
    Variant{"double-pack avx2", NumberKind::double_pack, Instructions::avx2},
    Variant{"double-pack avx512", NumberKind::double_pack, Instructions::avx512},
};

/// True if this build has code for it and this machine can run it.
[[nodiscard]] inline bool is_here(const Variant& variant) {
  return !is_pack(variant.number) || has_packs_of(variant.instructions);
}

/// The widest packs of double that can be run here.
[[nodiscard]] inline Variant widest_double_pack() {
  Variant widest = in_double_packs[0];
  for (const Variant& variant : in_double_packs) {
    if (is_here(variant)) widest = variant;
  }
  return {"double-pack", NumberKind::double_pack, widest.instructions};
}

/// A small job as a work of draw.hpp: with float, double, and single packs of them.
template <class Job>
struct JobWork {
  using Result = void;
  const Job& job;

  template <class Real>
  void run() const {
    if constexpr (requires(Real pair) { pair.second; }) {
      job.template run<decltype(Real::first)>();
    } else if constexpr (!std::is_same_v<Real, long double>) {
      job.template run<Real>();
    }
  }
};

/// Does a job with the number of `variant`, which is_here().
template <class Job>
void run(const Job& job, const Variant& variant) {
  run_in_number(JobWork<Job>{job}, variant.number, variant.instructions);
}

/// A work with double and packs of it: it is not compiled for other numbers.
template <class Work>
struct InDouble {
  using Result = typename Work::Result;
  Work work;

  template <class Real>
  [[nodiscard]] Result run() const {
    if constexpr (std::is_same_v<Scalar<Real>, double>) {
      return work.template run<Real>();
    } else {
      throw std::logic_error("this work is compiled for double only");
    }
  }
};

}  // namespace texmap::bench
