// The law of packs for common/texture: each lane computes what a plain number computes. A row a
// function; they are called with any inputs, and with packs of both precisions.
#include <doctest.h>

#include "number/kinds/pack2.hpp"
#include "support/lanes.hpp"
#include "support/mesh_rays.hpp"
#include "texture/bilinear.hpp"
#include "texture/bump.hpp"
#include "texture/checkerboard.hpp"
#include "texture/encoded.hpp"
#include "texture/environment.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/normal_map.hpp"
#include "texture/projection_facts.hpp"
#include "texture/sky_moments.hpp"
#include "texture/sky_sampler.hpp"
#include "texture/smooth_texture.hpp"
#include "texture/solid_checkerboard.hpp"
#include "texture/waves.hpp"

namespace texmap::test {
namespace {

Image bytes(int width, int height) {
  Dice dice(1);
  Image image(width, height);
  for (Rgb8& texel : image.pixels)
    texel = {static_cast<std::uint8_t>(dice.below(256)), static_cast<std::uint8_t>(dice.below(256)),
             static_cast<std::uint8_t>(128 + dice.below(128))};
  return image;
}
LightImage light(int width, int height) {
  Dice dice(2);
  LightImage image(width, height);
  for (Color<float>& texel : image.pixels)
    texel = {static_cast<float>(dice.between(0, 1)), static_cast<float>(dice.between(0, 1)),
             dice.once_in(9) ? 50.0F : 0.0F};
  return image;
}

#define PACKS Pack<float>, Pack<double>, Pack2<Pack<float>>, Pack2<Pack<double>>

TEST_CASE_TEMPLATE("textures give in each lane the color of its own place", Many, PACKS) {
  Dice dice(3);
  const auto check = [&](const auto& texture) {
    for (int i = 0; i < 100; ++i)
      check_each_lane<Many>(
          [&]<class Real>(const Real& u, const Real& v) {
            return texture(Uv<Real>{u, v});
          },
          any_pack<Many>(dice, -2, 3), any_pack<Many>(dice, -0.25, 1.25));
  };
  for (const VAxis axis : {VAxis::up, VAxis::down}) {
    check(ImageTexture{bytes(3, 2), axis, TexelRounding::floor});
    check(ImageTexture{bytes(3, 2), axis, TexelRounding::lecture});
    check(BilinearTexture{bytes(33, 16), axis, TexelLight::encoded});
    check(BilinearTexture{bytes(33, 16), axis, TexelLight::linear});
    check(SmoothTexture{light(8, 4), axis});
  }
  check(Checkerboard{{0.25, 0.5, 0.75}, {1, 0, 0.125}, 7});
}

TEST_CASE_TEMPLATE("functions of numbers and points work lane by lane", Many, PACKS) {
  using T = Scalar<Many>;
  Dice dice(4);
  const auto numbers = [&](double low, double high) { return any_pack<Many>(dice, low, high); };
  const auto whole = [&](double low, double high) { return floor(numbers(low, high)); };
  const TexturedMesh ring = torus(12, 6);
  const Pyramid pyramid = pyramid_of(light(40, 24));
  const T nan = std::numeric_limits<T>::quiet_NaN();
  for (int i = 0; i < 200; ++i) {
    check_each_lane<Many>(
        []<class Real>(const Vec3<Real>& p) { return FloorMapping{.size = 3}(p); },
        any_vectors<Many>(dice, -50, 50));
    for (const double cell : {1.0, 0.3})
      check_each_lane<Many>(
          [&](const auto& p) {
            return SolidCheckerboard{{0, 0, 0}, {1, 1, 1}, cell}(p);
          },
          any_vectors<Many>(dice, i % 2 == 0 ? -3 : -1e12, 3));
    const Ray<Many> ray = aimed<Many>([&] { return point_within(dice, 3); },
                                      [&] { return point_on_edge(dice, ring.mesh); });
    check_each_lane<Many>([&](const auto& in) { return ring.mapping(first_hit(ring.mesh, in)); },
                          ray);
    for (const Wrap wrap : {Wrap::mirror, Wrap::repeat, Wrap::clamp})
      check_each_lane<Many>([wrap](const auto& x) { return wrapped_coordinate(wrap, x); },
                            numbers(-5, 5));
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border, Wrap::spherical})
      check_each_lane<Many>(
          [&]<class Real>(const Real& column, const Real& row, const Real& columns,
                          const Real& rows) {
            const auto texel = wrapped_texel(wrap, column, row, columns, rows);
            return std::tuple(texel.column, texel.row, select(texel.inside, Real(1), Real(0)));
          },
          whole(-90, 90), whole(-90, 90), whole(1, 30), whole(1, 30));
    for (const TexelRounding rounding : {TexelRounding::floor, TexelRounding::lecture})
      check_each_lane<Many>(
          [&]<class Real>(const Real& u) { return Real(texel_number(u, 1000, rounding)); },
          from_lanes<Many>([&](std::size_t) {
            return dice.once_in(4) ? nan : static_cast<T>(dice.between(-0.2, 1.2));
          }));
    const auto slope = [&] { return numbers(-2, 2); };
    check_each_lane<Many>(
        []<class Real>(const Real& a, const Real& b, const Real& c, const Real& d) {
          const auto footprint = footprint_of(Uv<Dual<Real>>{{Real(0.5), a, b}, {Real(0.5), c, d}},
                                              Real(64), Real(32));
          return std::tuple(footprint.along_u, footprint.along_v, footprint.longer,
                            footprint.shorter);
        },
        slope(), slope(), slope(), slope());
    check_each_lane<Many>(
        [&]<class Real>(const Real& number, const Real& across, const Real& down) {
          const PyramidLevel<Real> level = level_of(pyramid, floor(number));
          return texel_light(pyramid, level, floor(across * level.width),
                             floor(down * level.height));
        },
        numbers(0, 5.99), numbers(0, 0.99), numbers(0, 0.99));
    check_each_lane<Many>([](const auto& x) { return encoded(x); }, numbers(-0.1, 1.1));
  }
}

TEST_CASE_TEMPLATE("filters read in each lane its own footprint", Many, Pack2<Pack<float>>,
                   Pack2<Pack<double>>) {
  Dice dice(6);
  const auto any = [&](double low, double high) { return any_pack<Many>(dice, low, high); };
  const auto slope = [&] { return square(square(any(0, 0.9))) * any(-1, 1); };
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear,
                              Filter::anisotropic, Filter::ewa, Filter::stochastic}) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::border, Wrap::spherical}) {
      const FilteredTexture texture{
          .pyramid = pyramid_of(light(40, 24)), .filter = filter, .wrap = wrap};
      for (int i = 0; i < 40; ++i)
        check_each_lane<Many>(
            [&]<class Real>(const Real& u, const Real& v, const Real& a, const Real& b,
                            const Real& c, const Real& d) {
              return texture.filtered(Uv<Dual<Real>>{{u, a, b}, {v, c, d}});
            },
            any(-1, 2), any(-1, 2), slope(), slope(), slope(), slope());
    }
  }
}

/// The parts of a color, a place or a vector, as numbers that are compared.
template <class Real>
std::array<Real, 3> parts(const Vec3<Real>& p) {
  return {p.x, p.y, p.z};
}
template <class Real>
std::array<Real, 3> parts(const Color<Real>& c) {
  return {c.r, c.g, c.b};
}

TEST_CASE_TEMPLATE("what packs compute by their own arc tangent differs by its rounding alone",
                   Many, PACKS) {
  const double epsilon = static_cast<double>(std::numeric_limits<Scalar<Many>>::epsilon());
  const Environment sky(light(16, 8), TexelFilter::bilinear, 25);
  const SkyMoments moments(sky);
  const SkySampler sampler(sky);
  const NormalMap<RtiowMapping, BilinearTexture> map{.mapping = {}, .texture = {bytes(16, 8)}};
  const Bumps<SolidWaves> bumps{.height = {}, .relief = 0.1};
  Dice dice(7);
  /// The largest difference in a lane, in epsilons; differences of single texels go by their light.
  const auto check = [&](double most, const auto& function) {
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      Vec3<Many> p = any_vectors<Many>(dice, -1, 1);
      p = normalize(p);
      const auto many = parts(function(p));
      for (std::size_t k = 0; k < lanes<Many>; ++k) {
        const auto one = parts(function(lane_of(p, k)));
        for (std::size_t part = 0; part < 3; ++part)
          worst = std::max(worst, static_cast<double>(abs(lane(many[part], k) - one[part])));
      }
    }
    CHECK(worst <= most * epsilon);
  };
  for (const ProjectionFacts& facts : projections) {
    CAPTURE(facts.word);
    const Projection projection = facts.projection;
    check(8, [=]<class Real>(const Vec3<Real>& p) {
      const Uv<Real> uv = project(projection, p);
      return Vec3<Real>{uv.u, uv.v, Real(0)};
    });
    check(8, [=]<class Real>(const Vec3<Real>& p) {
      return unproject(projection, Uv<Real>{Real(0.5) + Real(0.49) * p.x, abs(p.y)});
    });
  }
  check(1e5, [&]<class Real>(const Vec3<Real>& p) { return sky(Ray<Real>{{}, p}); });
  check(1e3, [&](const auto& p) { return moments.reflected(p); });
  check(100, [&]<class Real>(const Vec3<Real>& p) {
    return sampler.direction(sky, Point2<Real>{abs(p.x), abs(p.y)},
                             Point2<Real>{abs(p.z), Real(0.3)});
  });
  check(100, [&]<class Real>(const Vec3<Real>& p) {
    return bumps(Hit<Real>{p, p, p, p}, Real(1));
  });
  check(1e5, [&]<class Real>(const Vec3<Real>& p) { return map(Hit<Real>{p, p, p, p}, Real(1)); });
}

}  // namespace
}  // namespace texmap::test
