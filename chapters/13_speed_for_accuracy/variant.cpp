// The variants of a picture.
#include "variant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texmap::chapter_13 {
namespace {

/// The numbers that differ in what they make of light; packs of the widest instructions alone.
std::vector<Variant> numbers_of_light(Instructions widest) {
  const Instructions wide = usable_instructions(widest).back();
  return {{NumberKind::double_},
          {NumberKind::float_},
          {NumberKind::double_pack, wide},
          {NumberKind::float_pack, wide}};
}

}  // namespace

View<> Globe::view(int width, int height, double east, double up) const {
  const double to_radians = std::numbers::pi / 180;
  const double out = away * std::cos(up * to_radians);
  const Point eye{out * std::sin(east * to_radians), away * std::sin(up * to_radians),
                  out * std::cos(east * to_radians)};
  return view_of(Camera{.eye = eye, .target = sphere.center, .fov_y_degrees = 16}, width, height);
}

bool is_pack(NumberKind number) {
  return number == NumberKind::float_pack || number == NumberKind::double_pack;
}

std::vector<int> degrees_for(NumberKind number) {
  if (number == NumberKind::extended) return {0};
  if (number == NumberKind::double_ || number == NumberKind::double_pack) return {0, 23, 29, 35};
  return {0, 5, 7, 9, 11, 13, 15, 17};
}

std::vector<Instructions> usable_instructions([[maybe_unused]] Instructions widest) {
  std::vector<Instructions> usable = {Instructions::baseline};
#ifdef TEXMAP_WIDE_PACKS
  for (const Instructions wide : {Instructions::avx2, Instructions::avx512}) {
    if (machine_has(wide) && wide <= widest) usable.push_back(wide);
  }
#endif
  return usable;
}

std::vector<Trial> all_places(Instructions widest) {
  std::vector<Trial> trials;
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    for (const NumberKind number : {NumberKind::double_, NumberKind::float_, NumberKind::extended,
                                    NumberKind::float_pack, NumberKind::double_pack}) {
      for (const Instructions instructions :
           usable_instructions(is_pack(number) ? widest : Instructions::baseline)) {
        for (const int degree : degrees_for(number))
          trials.push_back({{number, instructions, degree, filter}});
      }
    }
  }
  return trials;
}

std::vector<Trial> all_curves(Instructions widest) {
  std::vector<Trial> trials;
  for (Variant variant : numbers_of_light(widest)) {
    for (const Curve curve : {Curve::formula, Curve::exact, Curve::four, Curve::three}) {
      variant.curve = curve;
      // Bytes and roots alternately: a picture leaves its texels in the caches for the next.
      for (const TexelFormat format : {TexelFormat::bytes, TexelFormat::roots}) {
        variant.format = format;
        const bool one_level = curve == Curve::exact || curve == Curve::four;
        if (format == TexelFormat::bytes || one_level) trials.push_back({variant});
      }
    }
  }
  return trials;
}

std::vector<Trial> all_texel_formats(Instructions widest) {
  std::vector<Trial> trials;
  for (Variant variant : numbers_of_light(widest)) {
    variant.curve = Curve::exact;
    for (const TexelFormat format : {TexelFormat::bytes, TexelFormat::roots}) {
      variant.format = format;
      trials.push_back({variant});
    }
  }
  return trials;
}

const Trial* find_trial(const std::vector<Trial>& trials, const Variant& variant) {
  const auto found = std::find_if(trials.begin(), trials.end(),
                                  [&](const Trial& trial) { return trial.variant == variant; });
  return found == trials.end() ? nullptr : &*found;
}

const char* name_of(NumberKind number) {
  return std::array{"float", "double", "extended", "float-pack", "double-pack", "interval"}
      [static_cast<std::size_t>(number)];
}
const char* name_of(Instructions instructions) {
  return std::array{"baseline", "avx2", "avx512"}[static_cast<std::size_t>(instructions)];
}
const char* name_of(SamplerKind kind) {
  return std::array{"random", "stratified", "multi-jitter",
                    "sobol"}[static_cast<std::size_t>(kind)];
}
const char* name_of(Filter filter) { return filter == Filter::nearest ? "nearest" : "bilinear"; }
const char* name_of(Curve curve) {
  return std::array{"none", "power", "exact", "4 terms",
                    "3 terms"}[static_cast<std::size_t>(curve)];
}
const char* name_of(TexelFormat format) { return format == TexelFormat::roots ? "roots" : "bytes"; }
std::string name_of_kernel(int degree) {
  return degree == 0 ? "reference" : "degree " + std::to_string(degree);
}

std::string described_number(const Variant& variant) {
  const std::string number = name_of(variant.number);
  return is_pack(variant.number) ? number + " of " + name_of(variant.instructions) : number;
}
std::string described(const Variant& variant) {
  return described_number(variant) + ", " + name_of_kernel(variant.degree);
}
std::string described_light(const Variant& variant) {
  return name_of(variant.format) + std::string(", ") + name_of(variant.curve);
}

}  // namespace texmap::chapter_13
