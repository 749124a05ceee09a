// The options of chapters with a mesh.
#include "engine/run/mesh_options.hpp"

#include <algorithm>
#include <utility>

#include "engine/files/read_obj.hpp"
#include "engine/files/system.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"
#include "math/rotation.hpp"
#include "texture/crate.hpp"

namespace texmap {
namespace {

constexpr std::size_t most_in_a_list = 16;  // triangles; a tree is slower for so few

// Moves a mesh to where the crate is: as large as it, in the middle, on the floor. Points that no
// triangle has do not count.
void fit_to_crate(Mesh& mesh) {
  Point low = mesh.corner(0, 0);
  Point high = low;
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      const Point& p = mesh.points[static_cast<std::size_t>(corner)];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  const double size = largest(high - low);
  const double scale = size > 1e-300 ? 2 / size : 1;  // 2 / size must be finite
  const Point foot{(low.x + high.x) / 2, low.y, (low.z + high.z) / 2};
  for (Point& p : mesh.points) p = (p - foot) * scale + Point{0, -1, 0};
}

}  // namespace

void MeshOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the mesh about its axis by this angle");
  line.choice(
      "--weights", weights, "signed|heron",
      "how to compute the weights of a triangle's corners: from signed areas, or as in the article "
      "from the lengths of the sides");
  line.text("--mesh", "FILE", file,
            "draw this mesh, an OBJ file with texture coordinates, instead of the crate");
  uv.declare(offer);
}

MeshScene MeshOptions::load(const Chosen& chosen) const {
  const RotationY rotation = rotation_y(degrees);
  ObjFile scene = file.empty() ? ObjFile{crate(), {}} : load_obj(path_of(file));
  for (const std::string& note : scene.notes) chosen.say(file + ": " + note + "\n");
  if (!file.empty()) fit_to_crate(scene.mesh);
  for (Point& p : scene.mesh.points) p = rotation(p);
  constexpr double reach = 9;
  add_floor(scene, reach);
  const bool is_small = scene.mesh.triangles.size() <= most_in_a_list;
  return {is_small ? BoxedMesh{std::move(scene.mesh), {}, {}} : with_boxes(std::move(scene.mesh)),
          std::move(scene.mapping)};
}

}  // namespace texmap
