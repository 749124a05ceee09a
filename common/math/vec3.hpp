// A point or a direction in space: three numbers and the operations the course needs on them.
#pragma once
#include <type_traits>

#include "compensated.hpp"

namespace texmap {

/// Three coordinates in a right-handed world: x to the right, y up, z towards the reader.
template <class Real>
struct Vec3 {
  Real x{}, y{}, z{};

  /// `yes` where the mask is true, else `no`.
  [[nodiscard]] friend Vec3 select(const Mask<Real>& mask, const Vec3& yes, const Vec3& no) {
    return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
  }
};

/// A point or direction of a scene. Scenes are written in double; `number_cast` turns them into the number a picture is drawn
/// with.
using Point = Vec3<double>;

/// A number as another kind of number, rounded once; as it is, if it is of that kind. Errors: none; beyond the other's range it
/// is infinite.
template <class Real, class Number>
[[nodiscard]] Real number_cast(const Number& x) {
  if constexpr (std::is_same_v<Real, Number>) {
    return x;
  } else {
    return Real(x);
  }
}
/// The same for each coordinate.
template <class Real, class Number>
[[nodiscard]] Vec3<Real> number_cast(const Vec3<Number>& p) {
  return {number_cast<Real>(p.x), number_cast<Real>(p.y), number_cast<Real>(p.z)};
}

/// Sum, difference and multiple, coordinate by coordinate.
///
/// Domain: any coordinates. Bound: each is rounded once, so that it is within 1 unit roundoff of itself; a multiple only as
/// long as it stays in the range of normal numbers. Errors: none; beyond the range a coordinate is infinite.
template <class Real>
[[nodiscard]] Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[nodiscard]] Vec3<Real> operator-(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// The opposite way, without an error.
template <class Real>
[[nodiscard]] Vec3<Real> operator-(const Vec3<Real>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class Real>
[[nodiscard]] Vec3<Real> operator*(const Vec3<Real>& a, const Real& s) {
  return {a.x * s, a.y * s, a.z * s};
}

/// The scalar product: |a| |b| times the cosine of the angle between them, within 3 unit roundoffs of |a| |b|.
template <class Real>
[[nodiscard]] Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The vector product: at a right angle to both, by the right-hand rule; within 2 unit roundoffs of |a| |b|.
template <class Real>
[[nodiscard]] Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The length of `a`, within 2 unit roundoffs of itself. Its square must stay in the number's range: about 1e-150 to 1e150 in
/// double.
template <class Real>
[[nodiscard]] Real length(const Vec3<Real>& a) {
  return sqrt(dot(a, a));
}

/// The largest of |x|, |y| and |z|: a size that cannot overflow.
template <class Real>
[[nodiscard]] Real largest(const Vec3<Real>& a) {
  return larger(abs(a.x), larger(abs(a.y), abs(a.z)));
}

/// `a` made one unit long, within 4 unit roundoffs; domain as `length`. The zero vector has no direction: it gives NaN.
template <class Real>
[[nodiscard]] Vec3<Real> normalize(const Vec3<Real>& a) {
  return a * (Real(1) / length(a));
}

/// dot(a, b) + rest, rounded about once: what cancels between the products is kept. Within 2 unit roundoffs of itself while the
/// result is above 16 unit roundoffs of |a| |b|. Domain: as two_product.
template <class Real>
[[nodiscard]] Real precise_dot(const Vec3<Real>& a, const Vec3<Real>& b, const Real& rest = Real(0)) {
  CompensatedSum<Real> sum;
  sum.add(rest);
  sum.add_product(a.x, b.x);
  sum.add_product(a.y, b.y);
  sum.add_product(a.z, b.z);
  return sum.value();
}

/// cross(a, b), each coordinate within 2 unit roundoffs of itself, however nearly parallel the two are. Domain: as two_product.
template <class Real>
[[nodiscard]] Vec3<Real> precise_cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {
      difference_of_products(a.y, b.z, a.z, b.y),
      difference_of_products(a.z, b.x, a.x, b.z),
      difference_of_products(a.x, b.y, a.y, b.x),
  };
}

}  // namespace texmap
