// An object of a scene: a shape and its paint.
#pragma once
#include <utility>
#include <variant>

#include "sphere.hpp"

namespace texmap {

/// A sphere and what covers it. `Paint` is callable with a Hit and gives a Color.
template <class Paint>
struct Painted {
  Sphere sphere;
  Paint paint;
};

/// An object made ready for the number that a picture is drawn with; its paint is looked at where it is.
template <class Real, class Paint>
struct PaintedIn {
  SphereIn<Real> sphere;
  const Paint& paint;
};

/// One of several kinds of paint, for lists of objects that are painted differently.
template <class... Paints>
struct AnyOf : std::variant<Paints...> {
  using std::variant<Paints...>::variant;

  /// The color that the paint in use gives for a hit. Which one that is, is asked once for all lanes of a pack together.
  ///
  /// @param hit  in the domain of every one of the paints, which all give the same type of color
  /// Errors: those of the paint.
  template <class Real>
  [[nodiscard]] auto operator()(const Hit<Real>& hit) const {
    return std::visit([&hit](const auto& paint) { return paint(hit); }, static_cast<const std::variant<Paints...>&>(*this));
  }
};

}  // namespace texmap
