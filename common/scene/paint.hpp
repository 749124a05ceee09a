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

/// True if a const `Function` can be called with an `Argument` and returns a `Result`.
template <class Function, class Argument, class Result>
concept Gives = std::is_same_v<std::invoke_result_t<const Function&, const Argument&>, Result>;

/// One of several kinds of paint, for a list of objects with different paints.
template <class... Paints>
struct AnyOf : std::variant<Paints...> {
  using std::variant<Paints...>::variant;

  /// The color of the paint that this object has.
  template <class Real>
  [[nodiscard]] Color<Real> operator()(const Hit<Real>& hit) const {
    static_assert((Gives<Paints, Hit<Real>, Color<Real>> && ...),
                  "a paint cannot be called with a hit in this number, or returns no Color<Real>: "
                  "is its operator() const, and a template over the number? With double alone, say "
                  "in `about`: .numbers = Numbers::only_double");
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
