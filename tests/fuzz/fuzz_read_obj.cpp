// Any bytes as a mesh file: the reader loads or refuses them, and what loads can be drawn.
#include "engine/fast/box_search.hpp"
#include "engine/files/read_obj.hpp"
#include "fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using texmap::test::claim;
  return texmap::test::loads_or_refuses([&] {
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
    const texmap::Ray<double> ray{{0.3, 0.2, 4}, {0, 0, -1}};
    const auto with_tree = first_hit(texmap::with_boxes(read.mesh), ray);
    const auto without = first_hit(read.mesh, ray);
    claim(with_tree.met == without.met && with_tree.triangle == without.triangle,
          "the tree meets what the list meets");
  });
}
