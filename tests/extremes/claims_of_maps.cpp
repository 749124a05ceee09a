// Claims of chapters 08 to 10: sides of edges, footprints, wrapping, maps of the sphere.
#include <array>

#include "claims.hpp"
#include "math/circle.hpp"
#include "published/equal_area.hpp"
#include "scene/edge_function.hpp"
#include "texture/footprint.hpp"
#include "texture/projections.hpp"
#include "texture/transformed.hpp"
#include "texture/wrap.hpp"

namespace texmap::extremes {
namespace {

/// A direction, often 1e-12 to 0.1 radians from a pole or an axis, or on or near an edge of a face.
template <class T>
Vec3<T> any_direction(Dice& dice) {
  Vec3<long double> p = dice.direction();
  if (dice.once_in(3)) {
    const long double near = dice.power_of_ten(-12, -1);
    p = {p.x * near, static_cast<long double>(dice.sign()), p.z * near};
    if (dice.once_in(2)) p = {p.y, p.x, p.z};
  }
  if (dice.once_in(8)) p.z = dice.once_in(2) ? p.x : 0;
  if (dice.once_in(8))
    (dice.once_in(2) ? p.y : p.z) = p.x * (1 + dice.sign() * dice.power_of_ten(-20, -1));
  return number_cast<T>(p * (1 / std::sqrt(dot(p, p))));
}

/// The angle between a direction and where it comes back to, in texels of 4096 a turn.
template <class Real>
Measurement worst_round_trip(Projection projection) {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1, any_direction<T>,
      [projection](const Vec3<Real>& p) { return unproject(projection, project(projection, p)); },
      [](const Vec3<T>& back, const Vec3<T>& p) {
        const Vec3<Digits50> from = exactly(p);
        const Vec3<Digits50> to = exactly(back);
        const Digits50 sine = length(cross(from, to)) / (length(from) * length(to));
        const bool opposite = dot(from, to) < 0;
        return opposite ? 1e9 : static_cast<double>(sine * 4096 / (2 * circle<Digits50>()));
      });
}

/// The distance of a place on the equal-area map from the map's middle, in texels of 4096.
template <class T, class Map>
Measurement worst_middle(const Map& map) {
  return worst_over(1, [map](Dice& dice, Worst& worst) {
    const long double near = dice.power_of_ten(-6, -0.5L);
    const Vec3<long double> turn = dice.direction();
    const Vec3<T> p = number_cast<T>(Vec3<long double>{
        near * turn.x, std::sqrt(1 - near * near * (turn.x * turn.x + turn.z * turn.z)),
        near * turn.z});
    const Uv<T> uv = map(p);
    const Vec3<Digits50> q = exactly(p);
    const Digits50 size = length(q);
    const Digits50 exact = sqrt((q.x * q.x + q.z * q.z) / (size * (size + q.y)));
    const Digits50 got = abs(2 * Digits50(uv.u) - 1) + abs(2 * Digits50(uv.v) - 1);
    worst.see(static_cast<double>(abs(got - exact) * 2048), [&] { return described(p); });
  });
}

/// The derivatives of u and of v by column and row, and the texture's size.
template <class Real>
using Moving = std::array<Vec3<Real>, 2>;

template <class Real>
Footprint<Real> footprint(const Moving<Real>& by) {
  return footprint_of(Uv<Dual<Real>>{{Real(0.5), by[0].x, by[0].y}, {Real(0.5), by[1].x, by[1].y}},
                      by[0].z, by[1].z);
}

/// The longer side against the larger eigenvalue in 50 digits.
template <class Real>
Measurement worst_side() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        const int size = dice.within(-20, 10);
        const auto any = [&] {
          return std::ldexp(static_cast<T>(dice.uniform(-1, 1)), size - (dice.once_in(4) ? 20 : 0));
        };
        const auto texels = [&] { return static_cast<T>(dice.within(1, 8192)); };
        Moving<T> by;
        by[0] = {any(), any(), texels()};
        by[1] = {any(), any(), texels()};
        if (dice.once_in(4)) by[1] = {by[0].x * 2, by[0].y * 2, by[1].z};
        return by;
      },
      [](const Moving<Real>& by) { return footprint(by).longer; },
      [](const T& longer, const Moving<T>& by) {
        const Vec3<Digits50> u = exactly(by[0]);
        const Vec3<Digits50> v = exactly(by[1]);
        const Digits50 uu = (u.x * u.x + u.y * u.y) * u.z * u.z;
        const Digits50 vv = (v.x * v.x + v.y * v.y) * v.z * v.z;
        const Digits50 both = (u.x * v.x + u.y * v.y) * u.z * v.z;
        const Digits50 half = (uu - vv) / 2;
        return relative_off(longer,
                            Digits50(sqrt((uu + vv) / 2 + sqrt(half * half + both * both))));
      });
}

/// Sides that are no number from 0 to 2^25.
template <class Real>
Measurement sides_outside() {
  using T = Scalar<Real>;
  return count_lanes<Real>(
      1,
      [](Dice& dice) {
        const auto any = [&] { return dice.anything<T>(); };
        const auto texels = [&] { return static_cast<T>(1 << dice.below(15)); };
        return Moving<T>{Vec3<T>{any(), any(), texels()}, Vec3<T>{any(), any(), texels()}};
      },
      [](const Moving<Real>& by) {
        const Footprint<Real> f = footprint(by);
        const auto within = [](const Real& x) { return x >= Real(0) && x <= Real(0x1p25); };
        return !(within(f.longer) && within(f.shorter) &&
                 within(max(abs(f.along_u), abs(f.along_v))) && f.shorter <= f.longer);
      });
}

/// Wrapped texels outside the image.
template <class Real>
Measurement texels_outside() {
  using T = Scalar<Real>;
  return worst_over(4, [](Dice& dice, Worst& worst) {
    const int width = 2 * dice.within(1, 2048);
    const int height = dice.within(1, 4096);
    const Wrap wrap = std::array{Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border,
                                 Wrap::spherical}[static_cast<std::size_t>(dice.below(5))];
    const auto whole = [&](int n) {
      return static_cast<T>(dice.once_in(2) ? dice.within(-4, 4) * n + dice.within(-1, 1)
                                            : dice.within(-(1 << 22), 1 << 22));
    };
    see_lanes<Real>(
        worst,
        [&] {
          return Vec3<T>{whole(width), whole(height), T(0)};
        },
        [&](const Vec3<Real>& at) {
          const WrappedTexel<Real> texel = wrapped_texel(wrap, at.x, at.y, width, height);
          return Vec3<Real>{texel.column, texel.row, Real(0)};
        },
        [&](const Vec3<T>& texel, const Vec3<T>&) {
          return !(texel.x >= 0 && texel.x < static_cast<T>(width) && texel.y >= 0 &&
                   texel.y < static_cast<T>(height) && texel.x == std::floor(texel.x) &&
                   texel.y == std::floor(texel.y));
        },
        [&] { return "image " + described(width) + " by " + described(height); });
  });
}

/// Two corners as a ray sees them, often on one line with the ray.
template <class T>
std::array<Vec3<T>, 2> any_edge(Dice& dice) {
  const auto any = [&] { return static_cast<T>(dice.uniform(-1, 1)); };
  const Vec3<T> a{any(), any(), T(1)};
  Vec3<T> b{any(), any(), T(1)};
  const int kind = dice.below(6);
  if (kind == 0) b = {-a.x, -a.y, T(1)};
  if (kind == 1) {
    const T factor = static_cast<T>(dice.within(-3, 3));
    b = {a.x * factor, a.y * factor, T(1)};
  }
  if (kind == 2) b = {std::nextafter(a.x * T(3), T(9)), a.y * T(3), T(1)};
  if (kind == 3) b = {a.x, T(0), T(1)};
  return {a, b};
}

/// Edges whose side is not the exact one, or not exactly one of the two, or other from b to a.
template <class Real>
Measurement sides_wrong() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      4, any_edge<T>,
      [](const std::array<Vec3<Real>, 2>& edge) {
        const EdgeSide<Real> side = side_of_edge(edge[0], edge[1]);
        const EdgeSide<Real> back = side_of_edge(edge[1], edge[0]);
        const auto one = [](const Mask<Real>& is) { return select(is, Real(1), Real(0)); };
        return Vec3<Real>{one(side.left), one(side.right),
                          one(back.left) - one(side.right) + one(back.right) - one(side.left)};
      },
      [](const Vec3<T>& side, const std::array<Vec3<T>, 2>& edge) {
        const auto& [a, b] = edge;
        if (a.x == b.x && a.y == b.y) return false;  // no edge
        const Digits50 exact = Digits50(a.x) * b.y - Digits50(a.y) * b.x;
        const bool left = side.x == 1;
        const bool right = side.y == 1;
        return left == right || side.z != 0 || (exact > 0 && !left) || (exact < 0 && !right);
      });
}

/// A corner's place as a ray sees it, against that of the same parts in 50 digits.
template <class Real>
Measurement worst_seen() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        const auto any = [&](int power) {
          return scaled(number_cast<T>(dice.direction()), dice.within(-power, power));
        };
        return std::array<Vec3<T>, 3>{any(6), any(3), any(6)};  // origin, direction, corner
      },
      [](const std::array<Vec3<Real>, 3>& a) {
        const RaySpace<Real> space(Ray<Real>{a[0], a[1]});
        const Vec3<Real> seen = seen_along(space, a[2]);
        return std::tuple(seen, space.direction, space.renamed(a[0]), space.renamed(a[2]));
      },
      [](const auto& got, const std::array<Vec3<T>, 3>& a) {
        const auto& [seen, direction, origin, corner] = got;
        const Vec3<Digits50> d = exactly(direction);
        const Vec3<Digits50> p = exactly(corner) - exactly(origin);
        const Digits50 unit =
            roundoff<T>() * largest(a[1]) * (Digits50(largest(a[2])) + largest(a[0]));
        return std::max(units_off(seen.x, p.x * d.z - p.z * d.x, unit),
                        units_off(seen.y, p.y * d.z - p.z * d.y, unit));
      });
}

/// Cosine and sine of turns, in unit roundoffs of 1.
template <class Real>
Measurement worst_turn() {
  using T = Scalar<Real>;
  return worst_lanes<Real>(
      1,
      [](Dice& dice) {
        const long double eighths = dice.within(-80, 80) / 8.0L;
        return static_cast<T>(dice.once_in(2) ? dice.uniform(-10, 10)
                                              : eighths + 1e-6L * dice.uniform(-1, 1));
      },
      [](const Real& turns) {
        const OnCircle<Real> at = on_circle(turns);
        return Vec3<Real>{at.cosine, at.sine, Real(0)};
      },
      [](const Vec3<T>& got, const T& turns) {
        const Digits50 angle = Digits50(turns) * 2 * circle<Digits50>();
        return std::max(units_off(got.x, cos(angle), roundoff<T>()),
                        units_off(got.y, sin(angle), roundoff<T>()));
      });
}

/// Places of a transform, whose numbers count as exact.
template <class Real>
Measurement worst_transform() {
  using T = Scalar<Real>;
  return worst_over(1, [](Dice& dice, Worst& worst) {
    const auto upto = [&dice](double most) {
      return static_cast<double>(dice.uniform(-most, most));
    };
    const UvTransform transform{.scale = {upto(1000), upto(1000)},
                                .turn = on_circle(upto(1)),
                                .offset = {upto(10), upto(10)}};
    see_lanes<Real>(
        worst,
        [&] {
          return Uv<T>{static_cast<T>(upto(1)), static_cast<T>(upto(1))};
        },
        transform,
        [&](const Uv<T>& moved, const Uv<T>& uv) {
          const Digits50 u = Digits50(transform.scale.u) * uv.u;
          const Digits50 v = Digits50(transform.scale.v) * uv.v;
          const Digits50 c = transform.turn.cosine, s = transform.turn.sine;
          const auto off = [&](T got, const Digits50& turned, double offset) {
            return units_off(got, Digits50(turned + offset),
                             (abs(u) + abs(v) + std::abs(offset)) * roundoff<T>());
          };
          return std::max(off(moved.u, Digits50(u * c - v * s), transform.offset.u),
                          off(moved.v, Digits50(u * s + v * c), transform.offset.v));
        },
        [&] { return "scale " + described(transform.scale); });
  });
}

}  // namespace

Family claims_of_maps() {
  Family family{"Maps, footprints, edges",
                "Texels are those of a map of 4096 texels a turn. Exact: angles between vectors, "
                "eigenvalues and signs in 50 digits."};
  for_each_number([&]<class Real>() {
    const Bound texels{by_number<Real>(0.001, 2e-12, 1e-15), "texel"};
    for (const auto& [name, projection] : {std::pair("equirect", Projection::equirect),
                                           {"cube", Projection::cube},
                                           {"equi-angular", Projection::equi_angular},
                                           {"octahedral", Projection::octahedral},
                                           {"equal-area", Projection::equal_area}}) {
      family.add<Real>(std::string("unproject(project), ") + name,
                       "directions, 1e-12 rad from the axes and farther, edges of faces", texels,
                       worst_round_trip<Real>(projection));
    }
    family.add<Real>("on_circle", "-10 to 10 turns", {2, "u"}, worst_turn<Real>());
    family.add<Real>("footprint_of, longer side",
                     "derivatives of 1e-12 to 1e3 of either sign, the largest above 1e-7, textures "
                     "of 1 to 8192 texels",
                     {6, "u"}, worst_side<Real>());
    family.add<Real>("footprint_of, range", "anything the type can hold, infinities and NaN too",
                     {0, "sides outside 0 to 2^25 texels"}, sides_outside<Real>());
    family.add<Real>("wrapped_texel", "whole numbers to 2^22, images to 4096 texels, every wrap",
                     {0, "texels outside"}, texels_outside<Real>());
    family.add<Real>("UvTransform", "u and v from -1 to 1, scales to 1000, offsets to 10, any turn",
                     {6, "u of scaled u + scaled v + offset, in sizes"}, worst_transform<Real>());
    family.add<Real>("seen_along", "origins and corners of 0.01 to 100, any direction",
                     {6, "u of direction (corner + origin), in largest parts"}, worst_seen<Real>());
    family.add<Real>("side_of_edge", "corners on one line with the ray, or a rounding off it, too",
                     {0, "wrong, or other seen from b to a"}, sides_wrong<Real>());
  });
  for_each<float, double>([&]<class T>() {
    const char* domain = "1e-6 to 0.3 rad from the pole";
    const Bound texels{by_number<T>(0.001, 2e-12, 0.), "texel"};
    family.add<T>("uv_equal_area, near the pole", domain, texels,
                  worst_middle<T>([](const Vec3<T>& p) { return uv_equal_area(p); }));
    family.add_broken<T>(
        "equal area by 1 - y", domain, texels,
        worst_middle<T>([](const Vec3<T>& p) { return published::uv_equal_area(p); }));
  });
  return family;
}

}  // namespace texmap::extremes
