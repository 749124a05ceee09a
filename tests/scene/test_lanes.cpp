// The law of packs for math, sampling, scene and texture: each lane computes what a plain number
// computes. A row a function; to add one, make what it needs of the numbers in `In`. Functions with
// an arc tangent, which packs round in their own way, tests/extremes searches with packs, too.
#include <doctest.h>

#include "math/srgb.hpp"
#include "number/kinds/pack2.hpp"
#include "published/look_up.hpp"
#include "sampling/sampled_numbers.hpp"
#include "scene/floor.hpp"
#include "scene/lens.hpp"
#include "scene/light.hpp"
#include "scene/paint.hpp"
#include "scene/path.hpp"
#include "scene/phong.hpp"
#include "scene/sky.hpp"
#include "support/lanes.hpp"
#include "support/made_pictures.hpp"
#include "support/mesh_rays.hpp"
#include "texture/bilinear.hpp"
#include "texture/filters.hpp"
#include "texture/floor_mapping.hpp"
#include "texture/marble.hpp"
#include "texture/smooth_texture.hpp"
#include "texture/solid_checkerboard.hpp"
#include "texture/uv_inverse.hpp"

namespace texmap::test {
namespace {

#define PACKS Pack<float>, Pack<double>, Pack2<Pack<float>>, Pack2<Pack<double>>

/// What a function's arguments are made of: numbers from -1 to 1, many of them eighths.
template <class Real>
using In = std::array<Real, 15>;

template <class Many>
In<Many> any_numbers(Dice& dice) {
  In<Many> in;
  for (Many& x : in)
    x = from_lanes<Many>([&](std::size_t) {
      return static_cast<Scalar<Many>>(dice.once_in(2) ? dice.within(-8, 8) / 8.0
                                                       : dice.between(-1, 1));
    });
  return in;
}
template <class Real>
Vec3<Real> vector(const In<Real>& x, std::size_t first, double reach = 1) {
  return Vec3<Real>{x[first], x[first + 1], x[first + 2]} * Real(reach);
}
template <class Real>
Vec3<Real> unit(const In<Real>& x, std::size_t first) {
  return normalize(vector(x, first) + Vec3<Real>{Real(0), Real(0), Real(0x1p-20)});
}
template <class Real>
Real number_of(const Mask<Real>& mask) {
  return select(mask, Real(1), Real(0));
}

const std::vector<Painted<Solid>> spheres = {{{{0, 0, -5}, 1}, {{0.5, 0.25, 1}}},
                                             {{{0, 0, 5}, 1}, {{0.25, 1, 0.5}}},
                                             {{{3, 0, 0}, 2}, {{0.75, 0.5, 0.25}}}};
const std::vector<Painted<Solid>> one_sphere = {spheres[0]};

/// Checks the law of a function of an In.
template <class Many, class Function>
void law(const std::string& what, const Function& function) {
  CAPTURE(what);
  Dice dice;
  for (int i = 0; i < 400; ++i) check_each_lane<Many>(function, any_numbers<Many>(dice));
}

TEST_CASE_TEMPLATE("math, sampling and scene compute lane by lane", Many, PACKS) {
  law<Many>("direction_rtiow", []<class Real>(const In<Real>& x) {
    return direction_rtiow(Uv<Real>{x[0] + x[1], abs(x[2])});
  });
  law<Many>("cosine_direction", []<class Real>(const In<Real>& x) {
    return cosine_direction(unit(x, 0), Point2<Real>{abs(x[3]), abs(x[4])});
  });
  law<Many>("Lens", []<class Real>(const In<Real>& x) {
    const Lens lens{.defocus_degrees = 3, .focus_distance = 8, .shift = 0.5};
    const View<> view = view_of({.eye = {0, 2, 8}, .target = {0, 0, 0}}, 31, 17);
    SampledNumbers<Real> random{{SamplerKind::sobol, 64}, 5};
    const PixelPlace<Real> at{x[0] * Real(31), x[1] * Real(17)};
    return lens.ray(number_cast<Real>(view), at, random);
  });
  law<Many>("Floor", []<class Real>(const In<Real>& x) {
    const Ray<Real> ray{vector(x, 0), vector(x, 3)};
    const Real distance = distance_to(Floor{0.25}, ray);
    const Mask<Real> met = distance < infinity<Real>();
    return std::tuple(distance, point_on(Floor{0.25}, ray, select(met, distance, Real(1))));
  });
  for (const SphereForm form : {SphereForm::plain, SphereForm::robust, SphereForm::hybrid}) {
    const Sphere<> sphere{{0.5, -0.25, 1}, 1.25, form};
    law<Many>("Sphere", [&]<class Real>(const In<Real>& x) {
      const Ray<Real> ray{vector(x, 0, 2), vector(x, 3)};
      const Real distance = distance_to(sphere, ray);
      const Mask<Real> met = distance < infinity<Real>();
      const Hit<Real> hit = hit_at(sphere, ray, select(met, distance, Real(1)));
      return std::tuple(distance, hit.normal, hit.point, hit.outside);
    });
  }
  law<Many>("crossing", []<class Real>(const In<Real>& x) {
    const RaySpace<Real> space(Ray<Real>{vector(x, 0), vector(x, 3)});
    const auto seen = [&](std::size_t first) { return seen_along(space, vector(x, first)); };
    const Crossing<Real> at = crossing(space, seen(6), seen(9), seen(12));
    return std::tuple(number_of<Real>(at.met), number_of<Real>(at.front),
                      select(at.met, at.a, Real(0)), select(at.met, at.distance, Real(0)));
  });
  const TexturedMesh ring = torus(12, 6);
  law<Many>("first_hit, MeshMapping", [&]<class Real>(const In<Real>& x) {
    const Vec3<Real> origin = vector(x, 0, 3), none{};
    const MeshHit<Real> hit = first_hit(ring.mesh, Ray<Real>{origin, vector(x, 3) - origin});
    return std::tuple(number_of<Real>(hit.met), select(hit.met, hit.point, none),
                      select(hit.met, hit.normal, none), ring.mapping(hit));
  });
  law<Many>("color_along", []<class Real>(const In<Real>& x) {
    return color_along(
        spheres, Ray<Real>{vector(x, 0, 4), vector(x, 3)},
        [](const auto& seen) { return gray(seen.direction.x); },
        [](const auto& object, const auto& hit) { return object.paint(hit); });
  });
  law<Many>("sample_light, lambert, highlight_of_the_slides", []<class Real>(const In<Real>& x) {
    const Vec3<Real> p = vector(x, 0, 5), normal = unit(x, 3);
    const LightSample<Real> sample =
        sample_light(PointLight{{0, 4, 0}}, spheres, Hit<Real>{normal, p, p});
    return std::tuple(
        sample.to_light, sample.cosine, lambert(Lambertian{}, sample),
        highlight_of_the_slides(PhongMaterial{{}, 1, 100}, sample, normal, unit(x, 6)));
  });
  for (const Rgb& above : {Rgb{1, 0.5, 0.25}, Rgb{0.5, 0.75, 1}}) {
    const GradientSky sky{.below = {1, 0.5, 0.25}, .above = above};
    for (const auto& scene : {one_sphere, spheres}) {
      law<Many>("light_along", [&]<class Real>(const In<Real>& x) {
        SampledNumbers<Real> random{{SamplerKind::random, 64}, 5};
        const Vec3<Real> direction{Real(1) + x[0] + x[1], x[2], Real(-1)};
        return light_along(scene, Ray<Real>{{}, direction}, sky, 8, random);
      });
    }
  }
}

TEST_CASE_TEMPLATE("textures and mappings compute lane by lane", Many, PACKS) {
  const auto texture_law = [](const auto& texture) {
    law<Many>("texture", [&]<class Real>(const In<Real>& x) {
      return texture(Uv<Real>{x[0] * Real(2.5), x[1] * Real(1.25)});
    });
  };
  for (const VAxis axis : {VAxis::up, VAxis::down}) {
    texture_law(ImageTexture{noise(3, 2, 1), axis, TexelRounding::floor});
    texture_law(ImageTexture{noise(3, 2, 1), axis, TexelRounding::lecture});
    texture_law(BilinearTexture{noise(33, 16, 1), axis, TexelLight::encoded});
    texture_law(BilinearTexture{noise(33, 16, 1), axis, TexelLight::linear});
    texture_law(SmoothTexture{light_noise(8, 4), axis});
  }
  texture_law(Checkerboard{{0.25, 0.5, 0.75}, {1, 0, 0.125}, 7});
  for (const auto formula :
       {published::TexelFormula::one_weekend_2020, published::TexelFormula::triangle_article})
    texture_law(published::LookUpTexture{{Wrap::repeat, {noise(8, 4, 1)}}, formula});
  for (const double reach : {3.0, 1e6, 1e12}) {
    law<Many>("SolidCheckerboard, FloorMapping", [=]<class Real>(const In<Real>& x) {
      const SolidCheckerboard board{{0, 0, 0}, {1, 1, 1}, 0.3};
      return std::tuple(board(vector(x, 0, reach)), FloorMapping{.size = 3}(vector(x, 3, reach)));
    });
  }
  law<Many>("Marble, gradient_noise", []<class Real>(const In<Real>& x) {
    return std::tuple(Marble{}(vector(x, 0, 5)), gradient_noise(vector(x, 3, 2000)));
  });
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp, Wrap::border, Wrap::spherical}) {
    law<Many>("wrapped_texel, wrapped_coordinate", [=]<class Real>(const In<Real>& x) {
      const auto texel = wrapped_texel(wrap, floor(x[0] * Real(90)), floor(x[1] * Real(90)),
                                       Real(1) + floor(abs(x[2]) * Real(30)),
                                       Real(1) + floor(abs(x[3]) * Real(30)));
      return std::tuple(texel.column, texel.row, number_of<Real>(texel.inside),
                        wrapped_coordinate(wrap, x[4] * Real(5)));
    });
  }
  law<Many>("texel_number of what may be NaN, srgb_encode", []<class Real>(const In<Real>& x) {
    return std::tuple(
        Real(texel_number(x[0] / floor(abs(x[1]) * Real(2)), 1000, TexelRounding::floor)),
        srgb_encode(x[2] * Real(1.1)));
  });
  law<Many>("footprint_of", []<class Real>(const In<Real>& x) {
    const auto footprint =
        footprint_of(Uv<Dual<Real>>{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}, Real(64), Real(32));
    return std::tuple(footprint.along_u, footprint.along_v, footprint.longer, footprint.shorter);
  });
  const Pyramid pyramid = pyramid_of(light_noise(40, 24));
  law<Many>("level_of, texel_light", [&]<class Real>(const In<Real>& x) {
    const Real inside = Real(0.99);
    const PyramidLevel<Real> level = level_of(pyramid, floor(abs(x[0]) * inside * Real(6)));
    return texel_light(pyramid, level, floor(abs(x[1]) * inside * level.width),
                       floor(abs(x[2]) * inside * level.height));
  });
  if constexpr (std::is_same_v<Many, Pack2<Pack<typename NumberTraits<Many>::Scalar>>>) {
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear,
                                Filter::anisotropic, Filter::ewa, Filter::stochastic}) {
      for (const Wrap wrap : {Wrap::repeat, Wrap::border, Wrap::spherical}) {
        const FilteredTexture texture{.pyramid = pyramid, .filter = filter, .wrap = wrap};
        Dice dice(6);
        for (int i = 0; i < 40; ++i)
          check_each_lane<Many>(
              [&]<class Real>(const In<Real>& x) {
                const Real size = square(square(x[6]));
                return texture.filtered(Uv<Dual<Real>>{{x[0] * Real(2), x[2] * size, x[3] * size},
                                                       {x[1] * Real(2), x[4] * size, x[5] * size}});
              },
              any_numbers<Many>(dice));
      }
    }
  }
}

}  // namespace
}  // namespace texmap::test
