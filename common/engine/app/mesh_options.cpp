// The options of chapters with a mesh: --degrees, --wrap, --weights, --mesh.
#include "engine/app/mesh_options.hpp"

#include "engine/app/command_line.hpp"
#include "texture/crate.hpp"

namespace texmap {

void MeshOptions::declare(CommandLine& line) {
  line.decimal("--degrees", degrees, -1e300, 1e300, "turn of the mesh about its axis, any angle");
  line.choice<Wrap>(
      "--wrap", wrap,
      {{"mirror", Wrap::mirror}, {"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}},
      "what the texture shows beyond its edges, as on the floor");
  line.choice<WeightsFormula>("--weights", weights,
                              {{"signed", WeightsFormula::signed_areas},
                               {"heron", WeightsFormula::heron}},
                              "the weights of a triangle's corners: signed areas, or the "
                              "article's areas from side lengths");
}

TexturedMesh MeshOptions::load() const {
  constexpr double reach = 9;
  TexturedMesh scene = crate(rotation_y(degrees));
  add_floor(scene, reach);
  return scene;
}

}  // namespace texmap
