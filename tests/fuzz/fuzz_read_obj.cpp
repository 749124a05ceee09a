// Any bytes as a mesh file: the reader loads or refuses them, and what loads can be drawn.
#include <cmath>
#include <new>
#include <string>
#include <string_view>

#include "engine/mesh/box_tree.hpp"
#include "engine/mesh/read_obj.hpp"
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using texmap::test::claim;
  try {
    texmap::TexturedMesh read = texmap::read_obj({reinterpret_cast<const char*>(data), size});
    claim(!read.mesh.triangles.empty(), "a mesh has triangles");
    claim(read.mapping.corners.size() == read.mesh.triangles.size(), "each has (u, v)");
    for (const auto& triangle : read.mesh.triangles) {
      for (const int corner : triangle)
        claim(corner >= 0 && static_cast<std::size_t>(corner) < read.mesh.points.size(),
              "indices are inside");
    }
    for (const texmap::Point& p : read.mesh.points)
      claim(largest(p) <= texmap::max_mesh_number, "points are finite and not too large");
    const texmap::Mesh list = read.mesh;
    build_box_tree(read.mesh);
    const texmap::Ray<double> ray{{0.3, 0.2, 4}, {0, 0, -1}};
    const auto with_tree = first_hit(read.mesh, ray);
    const auto without = first_hit(list, ray);
    claim(with_tree.met == without.met && with_tree.triangle == without.triangle,
          "the tree meets what the list meets");
  } catch (const texmap::FileError& error) {
    const std::string_view why = error.what();
    claim(!why.empty() && why.size() < 200, "a refusal says why, in short");
    for (const char c : why) claim(c >= ' ' && c <= '~', "a terminal can show it");
  } catch (const std::bad_alloc&) {
    // A mesh may be too large for this machine.
  }
  return 0;
}
