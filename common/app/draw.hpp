// One lesson, many numbers: draws the same code with the number the user asks for.
#pragma once
#include <stdexcept>

#include "number.hpp"
#include "paired.hpp"
#include "render.hpp"
#include "sureness.hpp"

namespace texmap {

/// The numbers a picture can be drawn with.
enum class Number {
  float_,       ///< 24 significant bits
  double_,      ///< 53
  extended,     ///< long double: 64 on x86
  float_pack,   ///< several floats at once
  double_pack,  ///< several doubles at once
  interval,     ///< two doubles with the true number between them: draws how sure each pixel is, not the picture
};

/// The fastest number that draws, in every chapter, the very picture that double draws (tests/packs): packs of double where
/// there are packs.
#ifdef TEXMAP_HAVE_PACKS
inline constexpr Number default_number = Number::double_pack;
#else
inline constexpr Number default_number = Number::double_;
#endif

#ifdef TEXMAP_HAVE_PACKS
/// The picture of a lesson, drawn with packs made of the instructions that the file is compiled for: two at a time, which takes
/// 0.7 to 0.8 of the time of one at a time.
///
/// @param number  float_pack or double_pack
template <class Arch, class Lesson>
[[nodiscard]] Image draw_packs(const Lesson& lesson, const View& view, Number number, const RenderSettings& settings) {
  return number == Number::float_pack ? render<Paired<Pack<float, Arch>>>(lesson, view, settings)
                                      : render<Paired<Pack<double, Arch>>>(lesson, view, settings);
}

/// The same with other instructions: add_chapter adds a file for each set, compiled for it, in which this function is defined
/// (wide_packs.hpp) and which the main file calls only on machines that have them.
template <Instructions instructions, class Lesson>
[[nodiscard]] Image draw_wide_packs(const Lesson& lesson, const View& view, Number number, const RenderSettings& settings);
#endif

/// The picture of a lesson, drawn with `number`.
/// Errors: std::runtime_error for packs where the program was built without them.
template <class Lesson>
[[nodiscard]] Image draw(const Lesson& lesson, const View& view, Number number, const RenderSettings& settings) {
  switch (number) {
    case Number::float_:
      return render<float>(lesson, view, settings);
    case Number::extended:
      return render<long double>(lesson, view, settings);
    case Number::interval:
      if constexpr (requires { lesson.gathering; }) {
        throw std::runtime_error("--number interval bounds one ray a pixel; this chapter's pictures are a matter of chance");
      } else {
        return render_sureness(lesson, view, settings);
      }
    case Number::float_pack:
    case Number::double_pack:
#ifdef TEXMAP_HAVE_PACKS
#ifdef TEXMAP_WIDE_PACKS
      if (settings.instructions == Instructions::avx512) {
        return draw_wide_packs<Instructions::avx512>(lesson, view, number, settings);
      }
      if (settings.instructions == Instructions::avx2)
        return draw_wide_packs<Instructions::avx2>(lesson, view, number, settings);
#endif
      return draw_packs<xsimd::default_arch>(lesson, view, number, settings);
#else
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
