// The variants of a picture: which are tried, and how they are called in tables.
#pragma once
#include <string>
#include <vector>

#include "engine/measure/interleaved.hpp"
#include "globe.hpp"
#include "sampling/sampler_kind.hpp"

namespace texmap::chapter_13 {

/// One way to draw the globe.
struct Variant {
  NumberKind number = NumberKind::double_;
  Instructions instructions = Instructions::baseline;
  int degree = 0;  ///< of the (u, v) kernel's arc tangent; 0 for the reference formula
  Filter filter = Filter::nearest;
  Curve curve = Curve::none;
  TexelFormat format = TexelFormat::bytes;

  bool operator==(const Variant&) const = default;
};

/// How far off a variant is: the error that was measured, and the bound that was proven.
struct Errors {
  /// Of hits that are not nearer to the rim than least_cosine.
  double worst_texels = 0, mean_texels = 0, texels_bound = 0;
  /// With a curve: levels before they are rounded to bytes.
  double worst_unrounded = 0, mean_unrounded = 0, unrounded_bound = 0;
  long changed = 0, may_change = 0;  ///< pixels with other bytes than the reference
  int levels = 0, levels_bound = 0;  ///< the largest change of a channel, of 255
};

/// A variant that was tried.
struct Trial {
  Variant variant;
  Errors errors = {};
  WorkTime took = {0, 0, 1};  ///< for one picture, on one thread
  double time = 0;            ///< as a part of plain double's time
};

[[nodiscard]] bool is_pack(NumberKind number);

/// The (u, v) kernels that are useful for a number: beyond degree 17 rounding is all that is left
/// of float's errors, and below degree 23 double is no better than float.
[[nodiscard]] std::vector<int> degrees_for(NumberKind number);

/// The sets of instructions that this program has packs of and this machine can run.
///
/// @param widest  the last one that is wanted
[[nodiscard]] std::vector<Instructions> usable_instructions(Instructions widest);

/// Every number, as packs of every set of instructions, with every kernel and both filters. The
/// first is plain double with the reference formula and the nearest texel: all times are parts of
/// its time.
[[nodiscard]] std::vector<Trial> all_places(Instructions widest);

/// Every curve from light to bytes with the numbers that differ in it, and roots where they are at
/// most one level off.
[[nodiscard]] std::vector<Trial> all_curves(Instructions widest);

/// Both texel formats with every number, for many rays per pixel. The first: plain double, bytes.
[[nodiscard]] std::vector<Trial> all_texel_formats(Instructions widest);

/// The trial of a variant, or nullptr.
[[nodiscard]] const Trial* find_trial(const std::vector<Trial>& trials, const Variant& variant);

// As the options --number, --instructions and --sampler have them.
[[nodiscard]] const char* name_of(NumberKind number);
[[nodiscard]] const char* name_of(Instructions instructions);
[[nodiscard]] const char* name_of(SamplerKind kind);

[[nodiscard]] const char* name_of(Filter filter);
[[nodiscard]] const char* name_of(Curve curve);
[[nodiscard]] const char* name_of(TexelFormat format);
[[nodiscard]] std::string name_of_kernel(int degree);

/// What a variant calculates with, such as: float-pack of avx2.
[[nodiscard]] std::string described_number(const Variant& variant);
/// The same and its kernel, such as: float-pack of avx2, degree 9.
[[nodiscard]] std::string described(const Variant& variant);
/// Its texels and its curve, such as: roots, 4 terms.
[[nodiscard]] std::string described_light(const Variant& variant);

}  // namespace texmap::chapter_13
