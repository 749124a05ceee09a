// One lesson, many numbers: draws the same code with the number the user asks for.
#pragma once
#include <stdexcept>

#include "number.hpp"
#include "pack.hpp"
#include "render.hpp"

namespace texmap {

/// The numbers a picture can be drawn with.
enum class Number {
  float_,       ///< 24 significant bits
  double_,      ///< 53
  extended,     ///< long double: 64 on x86
  float_pack,   ///< several floats at once
  double_pack,  ///< several doubles at once
};

/// The picture of a lesson, drawn with `number`.
/// Errors: std::runtime_error for packs where the program was built without them.
template <class Lesson>
[[nodiscard]] Image draw(const Lesson& lesson, const View& view, Number number, const RenderSettings& settings) {
  switch (number) {
    case Number::float_:
      return render<float>(lesson, view, settings);
    case Number::extended:
      return render<long double>(lesson, view, settings);
#ifdef TEXMAP_HAVE_PACKS
    case Number::float_pack:
      return render<Pack<float>>(lesson, view, settings);
    case Number::double_pack:
      return render<Pack<double>>(lesson, view, settings);
#else
    case Number::float_pack:
    case Number::double_pack:
      throw std::runtime_error(
          "packs of numbers need the library xsimd, which was not there when this program was built: install libxsimd-dev "
          "(Debian, Ubuntu), xsimd-devel (Fedora) or xsimd (Arch, Homebrew, vcpkg) and build again");
#endif
    case Number::double_:
      break;
  }
  return render<double>(lesson, view, settings);
}

}  // namespace texmap
