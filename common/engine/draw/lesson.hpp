// What a lesson says about itself, and its hooks.
#pragma once
#include <functional>
#include <vector>

namespace texmap {

class Chosen;
class Session;
struct Offer;
template <class Real>
struct Ray;
template <class Real>
struct Surface;

/// The numbers that a lesson's code compiles for.
enum class Numbers {
  all,           ///< single numbers, packs and intervals: templates without `if` on a number
  no_intervals,  ///< the same with sin, cos, pow, copysign, ldexp or a hash: not with intervals
  single,        ///< float, double and long double: templates with `if` and `int`
  only_double,   ///< double: code without templates
};

/// A set of objects of a scene, by their index, below 32.
struct ObjectSet {
  unsigned bits = 0;

  constexpr ObjectSet() = default;
  constexpr ObjectSet(std::initializer_list<int> indices) {
    for (const int index : indices) bits |= 1U << index;
  }
  [[nodiscard]] constexpr bool contains(int index) const {
    return index < 32 && (bits >> index & 1U) != 0;
  }
};

/// Columns and rows of a picture, in pixels.
struct Size {
  int width, height;
};

/// What a lesson says about itself; a misspelt name does not compile.
struct About {
  const char* idea;                ///< in one line, for --help
  ObjectSet changed_objects = {};  ///< those that look different from the chapter before
  Size size = {800, 600};          ///< of its picture
  const char* size_note = "";      ///< for --help: when the size is another one
  Numbers numbers = Numbers::all;  ///< that its code can be run with
};

/// The groups of options that a lesson offers, in this order.
struct Groups {
  std::vector<const void*> members;  ///< where they are: in the lesson
  std::function<void(Offer&)> declare;
  template <class... Group>
  Groups(Group&&... groups)
      : members{&groups...}, declare([&](Offer& offer) { (groups.declare(offer), ...); }) {
    static_assert((std::is_lvalue_reference_v<Group> && ...),
                  "`options` names groups that are members of the lesson");
  }
};

/// The base of a lesson. Write `override` behind each hook: a misspelt one does not compile.
struct LessonHooks {
  virtual ~LessonHooks() = default;
  virtual Groups options() { return {}; }         ///< what its user may choose
  virtual void build(Chosen& /*chosen*/) {}       ///< makes it so, such as by loading a texture
  virtual void draw_all(Session& /*session*/) {}  ///< draws and saves, in place of run_chapter
  /// What a ray meets first, for --show; without it, the object of `objects`.
  [[nodiscard]] virtual Surface<double> first_surface(const Ray<double>& ray) const;
};

}  // namespace texmap
