// How this chapter calls what it has tried, and how it writes numbers.
#pragma once
#include <array>
#include <cstdio>
#include <string>

#include "noise.hpp"

namespace texmap::chapter_13 {

/// A text made as printf makes it, of at most 399 bytes.
template <class... Values>
[[nodiscard]] std::string printed(const char* format, Values... values) {
  std::array<char, 400> text{};
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
#pragma GCC diagnostic ignored "-Wformat-security"
  std::snprintf(text.data(), text.size(), format, values...);
#pragma GCC diagnostic pop
  return text.data();
}

/// As the option --number has it.
[[nodiscard]] inline const char* name_of(Number number) {
  switch (number) {
    case Number::float_:
      return "float";
    case Number::extended:
      return "extended";
    case Number::float_pack:
      return "float-pack";
    case Number::double_pack:
      return "double-pack";
    default:
      return "double";
  }
}

/// As the option --instructions has it.
[[nodiscard]] inline const char* name_of(Instructions instructions) {
  return instructions == Instructions::avx512 ? "avx512" : instructions == Instructions::avx2 ? "avx2" : "baseline";
}

[[nodiscard]] inline const char* name_of(Filter filter) { return filter == Filter::nearest ? "nearest" : "bilinear"; }

[[nodiscard]] inline const char* name_of(Curve curve) {
  switch (curve) {
    case Curve::formula:
      return "power";
    case Curve::exact:
      return "exact";
    case Curve::four:
      return "4 terms";
    case Curve::three:
      return "3 terms";
    default:
      return "none";
  }
}

[[nodiscard]] inline const char* name_of(Texels texels) { return texels == Texels::roots ? "roots" : "bytes"; }

/// As the option --sampler has it.
[[nodiscard]] inline const char* name_of(SamplerKind kind) {
  switch (kind) {
    case SamplerKind::stratified:
      return "stratified";
    case SamplerKind::multi_jitter:
      return "multi-jitter";
    case SamplerKind::sobol:
      return "sobol";
    default:
      return "random";
  }
}

[[nodiscard]] inline std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}

/// What a way calculates with, such as: float-pack of avx2.
[[nodiscard]] inline std::string described_number(const Way& way) {
  return name_of(way.number) + (is_pack(way.number) ? std::string(" of ") + name_of(way.instructions) : "");
}

/// The way in words, such as: float-pack of avx2, degree 9.
[[nodiscard]] inline std::string described(const Way& way) { return described_number(way) + ", " + name_of_kernel(way.degree); }

/// How a way keeps texels and makes bytes of their light, such as: roots, 4 terms.
[[nodiscard]] inline std::string described_light(const Way& way) {
  return name_of(way.texels) + std::string(", ") + name_of(way.curve);
}

}  // namespace texmap::chapter_13
