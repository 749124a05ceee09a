// A point or a direction in space, and the operations on it.
#pragma once
#include "number/compensated.hpp"

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

/// A point and a direction of a scene. Scenes are written in double; see number_cast.
using Point = Vec3<double>;
using Vec3d = Vec3<double>;

/// A number as another kind of number, rounded once; infinite beyond the other's range.
template <class Real, class Other>
[[nodiscard]] Real number_cast(const Other& x) {
  return Real(x);
}
/// The same for each coordinate.
template <class Real, class Other>
[[nodiscard]] Vec3<Real> number_cast(const Vec3<Other>& p) {
  return {number_cast<Real>(p.x), number_cast<Real>(p.y), number_cast<Real>(p.z)};
}

/// Sum, difference and multiple, each coordinate rounded once.
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

/// The scalar product |a| |b| cos(angle).
template <class Real>
[[nodiscard]] Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The vector product, perpendicular to both (right-hand rule).
template <class Real>
[[nodiscard]] Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The length of `a`. Domain: its square is in range.
template <class Real>
[[nodiscard]] Real length(const Vec3<Real>& a) {
  return sqrt(dot(a, a));
}

/// The largest of |x|, |y| and |z|: a size that cannot overflow.
template <class Real>
[[nodiscard]] Real largest(const Vec3<Real>& a) {
  return max(abs(a.x), max(abs(a.y), abs(a.z)));
}

/// `a` with length 1; NaN for zero. Domain: as length.
template <class Real>
[[nodiscard]] Vec3<Real> normalize(const Vec3<Real>& a) {
  return a * (Real(1) / length(a));
}

/// dot(a, b) + rest with exact products.
template <class Real>
[[nodiscard]] Real precise_dot(const Vec3<Real>& a, const Vec3<Real>& b,
                               const Real& rest = Real(0)) {
  CompensatedSum<Real> sum;
  sum.add(rest);
  sum.add_product(a.x, b.x);
  sum.add_product(a.y, b.y);
  sum.add_product(a.z, b.z);
  return sum.value();
}

/// cross(a, b) with exact products.
template <class Real>
[[nodiscard]] Vec3<Real> precise_cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {
      difference_of_products(a.y, b.z, a.z, b.y),
      difference_of_products(a.z, b.x, a.x, b.z),
      difference_of_products(a.x, b.y, a.y, b.x),
  };
}

}  // namespace texmap
