// Paint: what covers a shape. To add one, write a struct that maps a Hit to a Color.
#pragma once
#include <variant>

#include "math/color.hpp"
#include "scene/sphere.hpp"

namespace texmap {

/// One color everywhere.
struct Solid {
  Rgb color;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>&) const {
    return number_cast<Real>(color);
  }
};

/// True if a const `Function` can be called with an `Argument`.
template <class Function, class Argument>
concept CallableWith = requires(const Function& function, const Argument& argument) {
  function(argument);
};

/// One of several kinds of paint, for a list of objects with different paints.
template <class... Paints>
struct AnyOf : std::variant<Paints...> {
  using std::variant<Paints...>::variant;

  /// The color of the paint that this object has.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    static_assert(
        (CallableWith<Paints, Hit<Real>> && ...),
        "a paint cannot be called with a hit in this number: is its operator() const, and "
        "a template over the number? A lesson with paints in double alone says so in "
        "`about`: .numbers = Numbers::only_double");
    return std::visit([&hit](const auto& paint) -> Color<Real> { return paint(hit); },
                      static_cast<const std::variant<Paints...>&>(*this));
  }
};

/// An object of a scene: a shape and its paint. Other shapes: scene/shapes.hpp.
template <class Paint, class Shape = Sphere<>>
struct Painted {
  Shape shape;
  Paint paint;
};

}  // namespace texmap
