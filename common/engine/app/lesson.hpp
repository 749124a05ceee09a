// What a lesson says about itself, and its hooks.
#pragma once
#include <array>
#include <initializer_list>

namespace texmap {

class CommandLine;
class Session;

/// The numbers that a lesson's code compiles for.
enum class Numbers {
  all,           ///< single numbers, packs and intervals: templates without `if` on a number
  no_intervals,  ///< the same with sin, cos, pow or ldexp, which intervals do not have
  single,        ///< float, double and long double: templates with `if` and `int`
  only_double,   ///< double: code without templates
};

/// A set of objects of a scene, by their index.
struct ObjectSet {
  unsigned bits = 0;

  constexpr ObjectSet() = default;
  constexpr ObjectSet(std::initializer_list<int> indices) {
    for (const int index : indices) bits |= 1U << index;
  }
  [[nodiscard]] constexpr bool contains(int index) const { return (bits >> index & 1U) != 0; }
};

/// Columns and rows of a picture, in pixels.
struct Size {
  int width, height;
};

/// What a lesson says about itself; a misspelt name does not compile.
struct About {
  const char* idea;                      ///< in one line, for --help
  ObjectSet changed_objects = {};        ///< those that look different from the chapter before
  Size size = {800, 600};                ///< of its picture
  const char* size_note = "";            ///< for --help: when the size is another one
  Numbers numbers = Numbers::all;        ///< that its code can be run with
  std::array<const char*, 4> without{};  ///< options of all chapters that it does not offer
};

/// Offers the options of some groups, in this order.
template <class... Group>
void offer(CommandLine& line, Group&... groups) {
  (groups.declare(line), ...);
}

/// The base of a lesson. Write `override` behind each hook: a misspelt one does not compile.
struct LessonHooks {
  virtual ~LessonHooks() = default;
  virtual void options(CommandLine& /*line*/) {}  ///< declares options
  virtual void prepare(Session& /*session*/) {}   ///< after the options, such as loading a texture
  virtual void draw_all(Session& /*session*/) {}  ///< draws and saves, in place of run_chapter
};

}  // namespace texmap
