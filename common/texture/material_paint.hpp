// A texture for each material of a mesh.
#pragma once
#include <vector>

#include "number/compiler.hpp"
#include "scene/mesh.hpp"
#include "texture/mapped.hpp"

namespace texmap {

/// The textures of a mesh's materials.
template <class Texture>
struct Materials {
  std::vector<Texture> textures;
  std::vector<int> of_triangle;  ///< -1: the paint's own texture; empty: for all triangles
};

/// A paint whose texture depends on the triangle.
template <class Mapping, class Texture>
struct MaterialPaint : Mapped<Mapping, Texture> {
  Materials<Texture> materials;

  template <class Real>
  [[nodiscard]] Color<Real> operator()(const MeshHit<Real>& hit) const {
    const Uv<Real> uv = this->mapping(hit);
    return materials.of_triangle.empty() ? this->texture(uv) : of_materials(uv, hit.triangle);
  }

 private:
  template <class Real>
  [[nodiscard]] TEXMAP_NOINLINE Color<Real> of_materials(const Uv<Real>& uv,
                                                         const Real& triangle) const {
    const auto number_at = [&](int number, int) {
      return std::array{materials.of_triangle[static_cast<std::size_t>(number)], 0, 0};
    };
    const Real number = look_up(number_at, triangle, Real(0))[0];
    Color<Real> color = gray(Real(0));
    for (int i = -1; i < static_cast<int>(materials.textures.size()); ++i) {
      const Mask<Real> here = number == Real(i);
      if (!any(here)) continue;
      const Texture& of_material =
          i < 0 ? this->texture : materials.textures[static_cast<std::size_t>(i)];
      color = select(here, of_material(uv), color);
    }
    return color;
  }
};

}  // namespace texmap
