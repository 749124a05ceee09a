// The numbers that works are timed with: plain ones, and packs made of each set of instructions;
// and rows of them.
#pragma once
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "bench.hpp"
#include "engine/draw/draw.hpp"
#include "engine/draw/number_names.hpp"

namespace texmap::bench {

/// A number, and the instructions that packs of it are made of: a column of a table.
struct Variant {
  std::string name;
  NumberKind number;
  Instructions instructions = Instructions::baseline;

  /// True if this build has code for it and this machine can run it.
  [[nodiscard]] bool is_here() const { return !is_pack(number) || has_packs_of(instructions); }
};

inline const Variant in_double{"double", NumberKind::double_};
inline const Variant in_float{"float", NumberKind::float_};

/// The variants of some letters: double, float, extended, Double packs, Float packs.
[[nodiscard]] inline std::vector<Variant> variants_of(std::string_view letters) {
  std::vector<Variant> variants;
  for (const char letter : letters) {
    if (letter == 'd') variants.push_back(in_double);
    if (letter == 'f') variants.push_back(in_float);
    if (letter == 'e') variants.push_back({"extended", NumberKind::extended});
    if (letter != 'D' && letter != 'F') continue;
    const NumberKind number = letter == 'D' ? NumberKind::double_pack : NumberKind::float_pack;
    for (const Instructions each : all_instructions)
      variants.push_back({std::string(name_of(number)) + " " + name_of(each), number, each});
  }
  return variants;
}

/// Double, and the widest packs of it that can be run here.
[[nodiscard]] inline std::vector<Variant> double_and_widest_packs() {
  Variant widest;
  for (const Variant& variant : variants_of("D")) {
    if (variant.is_here()) widest = variant;
  }
  return {in_double, {"double-pack", NumberKind::double_pack, widest.instructions}};
}

/// A row for a job.
///
/// @param make  called when the row's turn comes, makes the job and what it needs: gives a pointer
///              to something with run(variant)
template <class Make>
[[nodiscard]] Row row_of(const std::string& line, const std::string& set, const Variant& variant,
                         double items, Make make) {
  Row row{.line = line, .column = variant.name, .set = set, .items = items};
  if (!variant.is_here()) return row;
  row.prepare = [make, variant]() -> Work {
    auto ready = make();
    return [ready, variant] { ready->run(variant); };
  };
  return row;
}

/// A work with double and packs of it: it is not compiled for other numbers.
template <class Work>
struct InDouble {
  using Result = typename Work::Result;
  static constexpr bool for_packs = true;
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
