// Rays at a sphere: from near and far, from inside, straight at it, grazing it and past it.
#pragma once
#include <cmath>

#include "references.hpp"

namespace texmap::extremes {

/// Which shots are drawn.
struct Shots {
  long double nearest = -6;  ///< power of ten of distance over radius, from
  long double farthest = 7;  ///< to
  int scale = 0;  ///< sizes are multiplied by powers of two up to this one and down to its inverse
  int direction = 0;  ///< and lengths of directions likewise
  bool around_surface =
      true;  ///< some start within 0.1 to 1e-7 of the surface, on either side, and some graze it
  bool centered = true;  ///< the sphere's center is the origin, else up to 1e7 radii away from it
};

template <class T>
struct Shot {
  Ray<T> ray;
  Vec3<T> center;
  T radius;

  /// The ray's origin as seen from the center.
  [[nodiscard]] Vec3<Digits50> from_center() const { return exactly(ray.origin) - exactly(center); }
  [[nodiscard]] ExactMeeting<Digits50> meeting() const {
    return exact_meeting(from_center(), exactly(ray.direction), Digits50(radius));
  }
};

/// What all lanes of a pack share.
struct Shared {
  double radius;  ///< before scaling
  Point center;   ///< likewise; floats, so that every number holds them
  int scale;      ///< powers of two
  int direction;
};

inline Shared draw_shared(Dice& dice, const Shots& shots) {
  const auto radius = static_cast<double>(
      static_cast<float>(dice.uniform(1, 2)));  // a float, so that every number holds it
  const Vec3<float> center =
      shots.centered ? Vec3<float>{} : rounded<float>(dice.direction() * dice.power_of_ten(-3, 7));
  return {radius, number_cast<double>(center), dice.within(-shots.scale, shots.scale),
          dice.within(-shots.direction, shots.direction)};
}

/// A ray along an axis that passes the center a few numbers more or less than one radius away: only
/// along an axis does a ray still graze after its coordinates are rounded.
template <class T>
Shot<T> draw_grazing_shot(Dice& dice, const Shots& shots, const Shared& shared) {
  T coordinates[3] = {static_cast<T>(shared.radius), 0,
                      static_cast<T>(shared.radius * dice.power_of_ten(0, shots.farthest))};
  for (int steps = dice.below(6); steps > 0; --steps) {
    coordinates[0] = std::nextafter(coordinates[0], static_cast<T>(dice.once_in(2) ? 0 : 4));
  }
  // The same circle of impacts, met off the axes.
  if (dice.once_in(2)) {
    const long double turn = dice.uniform(0, 6.283185307179586L);
    coordinates[1] = static_cast<T>(coordinates[0] * std::sin(turn));
    coordinates[0] = static_cast<T>(coordinates[0] * std::cos(turn));
  }
  T along[3] = {0, 0, -static_cast<T>(dice.uniform(1, 2))};
  const int axis = dice.below(3);
  const Vec3<T> origin{coordinates[axis], coordinates[(axis + 1) % 3], coordinates[(axis + 2) % 3]};
  const Vec3<T> direction{along[axis], along[(axis + 1) % 3], along[(axis + 2) % 3]};
  return {{scaled(origin, shared.scale), scaled(direction, shared.direction)},
          {},
          std::ldexp(static_cast<T>(shared.radius), shared.scale)};
}

template <class T>
Shot<T> draw_shot(Dice& dice, const Shots& shots, const Shared& shared) {
  if (shots.centered && shots.around_surface && dice.once_in(4))
    return draw_grazing_shot<T>(dice, shots, shared);
  const long double radius = shared.radius;
  // From near by, through the outermost tenth of the sphere: there errors are largest.
  const bool at_limb = shots.around_surface && dice.once_in(4);
  const long double ratio = at_limb ? dice.uniform(0.9L, 3)
                            : shots.around_surface && dice.once_in(4)
                                ? 1 + dice.sign() * dice.power_of_ten(-7, -1)
                                : dice.power_of_ten(shots.nearest, shots.farthest);
  const long double away = ratio * radius;
  const long double impact = radius * [&] {
    if (at_limb) return dice.uniform(0.9L, 0.99L);
    switch (dice.below(4)) {
      case 0:
        return 1 + dice.sign() * dice.power_of_ten(-1 - std::numeric_limits<T>::digits10, -0.5L);
      case 1: {  // as nearly grazing as one form or another can see at this distance
        const long double seen =
            std::pow(std::max(1.0L, ratio), static_cast<long double>(dice.below(3)));
        return 1 + dice.uniform(-3, 3) * static_cast<long double>(unit_roundoff<T>()) * seen;
      }
      default:
        return dice.uniform(0, 1.2L);
    }
  }();
  const Vec3<long double> out = dice.direction();
  Vec3<long double> direction = dice.direction();
  if (impact < away) {
    const long double sine = impact / away;
    const long double side = dice.once_in(8) ? 1 : -1;  // some look away
    direction = out * (side * std::sqrt(1 - sine * sine)) + dice.across(out) * sine;
  }
  direction = direction * dice.uniform(1, 2);
  const auto center = number_cast<long double>(shared.center);
  return {{scaled(rounded<T>(center + out * away), shared.scale),
           scaled(rounded<T>(direction), shared.direction)},
          scaled(rounded<T>(center), shared.scale),
          std::ldexp(static_cast<T>(radius), shared.scale)};
}

/// Whether the type holds the answer, and also the sphere's size over the length of the direction.
template <class T>
bool is_in_range(const Shot<T>& shot, const ExactMeeting<Digits50>& exact) {
  using Limits = std::numeric_limits<T>;
  const Digits50 size =
      (length(shot.from_center()) + Digits50(shot.radius)) / length(exactly(shot.ray.direction));
  return size < Digits50(Limits::max()) / 8 &&
         (!exact.meets || exact.distance > Digits50(Limits::min()));
}

}  // namespace texmap::extremes
