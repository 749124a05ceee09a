// The options of chapters with a mesh: --degrees, --weights, --mesh, --normals, and UvOptions'.
#pragma once
#include <string>

#include "engine/draw/kinds.hpp"
#include "engine/draw/lesson.hpp"
#include "engine/fast/box_tree.hpp"
#include "engine/run/uv_options.hpp"
#include "published/mesh_weights.hpp"
#include "scene/mesh_normals.hpp"
#include "texture/material_paint.hpp"
#include "texture/mesh_mapping.hpp"

namespace texmap {

class Chosen;
struct Offer;

/// Where the weights of a triangle's corners come from.
enum class WeightsFormula {
  signed_areas,  ///< of the ray and the edges
  heron,         ///< the triangle article: areas from side lengths
  picture,       ///< of the picture, without perspective
};

/// How a mesh is shaded whose corners have normals.
enum class MeshShading {
  smooth,  ///< by the mix of the corners' normals
  flat,    ///< by the triangles' own
};

/// A mesh, with boxes if it is large, and what its corners and its file's materials say.
struct MeshScene {
  BoxedMesh mesh;
  MeshMapping mapping;
  MeshNormals normal;
  Materials<published::LookUpTexture> materials;
};

/// The user's choices of a mesh and of what its corners' (u, v) mean.
struct MeshOptions {
  double degrees = -25;  ///< turn of the mesh about +y
  WeightsFormula weights = WeightsFormula::signed_areas;
  MeshShading normals = MeshShading::smooth;
  std::string file;  ///< in OBJ format; empty for the crate
  UvOptions uv{.look_up = {{Wrap::mirror}}};

  void declare(Offer& offer);
  /// The crate or the file's mesh, as large and turned, on a floor; says what it left out. With a
  /// file the picture is repeated, unless the user chose. Weights of the picture are this camera's.
  /// Errors: FileError with the file and the line.
  [[nodiscard]] MeshScene load(const Chosen& chosen, const Camera& seen_by);
  /// The scene `scale` times as large and then moved, as this camera sees it.
  void place(MeshScene& scene, const Camera& seen_by, double scale, const Vec3d& moved);

  /// The hit with the weights of the chosen formula.
  template <class Real>
  [[nodiscard]] MeshHit<Real> weighted(const Mesh& mesh, const MeshHit<Real>& hit) const {
    if (weights == WeightsFormula::heron) return published::weighted_by_heron(mesh, hit);
    if (weights == WeightsFormula::picture)
      return published::weighted_in_picture(mesh, hit, camera);
    return hit;
  }

 private:
  Camera camera;
};

/// The base of a lesson with a mesh.
struct MeshLesson : LessonHooks, HasMesh {};

}  // namespace texmap
