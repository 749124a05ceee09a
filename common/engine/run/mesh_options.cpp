// The options of chapters with a mesh.
#include "engine/run/mesh_options.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "engine/files/load_image.hpp"
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

constexpr std::size_t most_texels = std::size_t{1} << 27;  // of all pictures of a mesh

Rgb8 nearest_bytes(const Rgb& color) {
  const auto byte = [](double c) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.0, 1.0)));
  };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

// A list of what messages name: about 500 bytes at most, and nothing that steers a terminal.
void add_to(std::string& list, const std::string& word) {
  constexpr std::size_t longest = 500;
  if (list.size() > longest) return;
  if (!list.empty()) list += ", ";
  for (const char c : word.substr(0, longest))
    list += static_cast<unsigned char>(c) < ' ' ? '?' : c;
  if (list.size() > longest) list += ", ...";
}

// The materials of a file: from its .mtl files, which it names one by one or in a row.
std::map<std::string, Material> known_materials(const ObjFile& file,
                                                const std::filesystem::path& path,
                                                std::string& problems) {
  std::map<std::string, Material> known;
  std::size_t tried = 0;
  for (const std::string& names : file.libraries) {
    std::istringstream words(names);
    std::vector<std::string> each{std::istream_iterator<std::string>(words), {}};
    std::error_code error;
    if (std::filesystem::exists(beside(path, names), error)) each = {names};
    for (const std::string& name : each) {
      if (++tried > max_mesh_libraries) return known;
      try {
        known.merge(load_mtl(beside(path, name)));
      } catch (const FileError& fault) {
        add_to(problems, fault.what());
      }
    }
  }
  return known;
}

// The picture with base + gain * c for each channel c, as a material says.
void change_channels(Image& image, const Material& material) {
  if (material.base == 0 && material.gain == 1) return;
  for (Rgb8& pixel : image.pixels) {
    const auto changed = [&](std::uint8_t c) { return material.base + material.gain * c / 255; };
    pixel = nearest_bytes({changed(pixel.r), changed(pixel.g), changed(pixel.b)});
  }
}

// The textures of a file's materials, pictures or, where they have none, colors. Scales and moves
// (u, v) as they say, and clamps pictures where the user leaves it to them; notes what is missing.
Materials<published::LookUpTexture> textures_of(ObjFile& file, const std::filesystem::path& path,
                                                const UvOptions& options, bool may_clamp) {
  std::string problems, missing, left_out, changed;
  const std::map<std::string, Material> known = known_materials(file, path, problems);
  Materials<published::LookUpTexture> made;
  const auto add = [&](const Image& image, bool clamped = false) {
    made.textures.push_back(options.read({image}));
    if (clamped && may_clamp) made.textures.back().wrapped.wrap = Wrap::clamp;
    return static_cast<int>(made.textures.size()) - 1;
  };
  struct Look {
    bool is_plain = false;
    int picture = -1, color = -1;  // of `made`; -1: the chapter's picture; not made yet
    Material material{};
  };
  std::vector<Look> looks(1);  // of triangles without a material; then the file's
  std::map<std::tuple<std::string, bool, double, double>, int> pictures;
  std::size_t texels = 0;
  for (const std::string& name : file.material_names) {
    Look& look = looks.emplace_back();
    const auto found = known.find(name);
    if (found != known.end()) look.material = found->second;
    const Material& material = look.material;
    look.is_plain = found != known.end() && material.picture.empty();
    if (!material.left_out.empty()) add_to(left_out, material.left_out + " of " + name);
    try {
      if (found == known.end())
        throw FileError(problems.empty() ? "no .mtl file describes them" : problems);
      if (look.is_plain) continue;
      const auto [picture, is_new] = pictures.try_emplace(
          {material.picture, material.clamped, material.base, material.gain}, -1);
      if (is_new) {
        std::string note;
        Image image = load_image(path_of(material.picture), &note);
        if (!note.empty()) add_to(changed, material.picture + " " + note);
        texels += image.pixels.size();
        if (texels > most_texels) throw FileError("all pictures together are too large");
        change_channels(image, material);
        picture->second = add(image, material.clamped);
      }
      look.picture = picture->second;
    } catch (const FileError& fault) {
      if (problems.find(fault.what()) == problems.npos) add_to(problems, fault.what());
    }
    if (look.picture < 0) add_to(missing, "'" + name + "'");
  }
  for (std::size_t i = 0; i < file.mapping.corners.size(); ++i) {
    auto& corners = file.mapping.corners[i];
    Look& look =
        looks[file.materials.empty() ? 0 : static_cast<std::size_t>(file.materials[i] + 1)];
    const bool is_plain = look.is_plain || std::isnan(corners[0].u);
    if (is_plain && look.color < 0)
      look.color = add(Image(1, 1, nearest_bytes(look.material.color)));
    made.of_triangle.push_back(is_plain ? look.color : look.picture);
    if (look.picture < 0) continue;
    const Material& material = look.material;
    for (Uv<double>& uv : corners) {
      uv = {uv.u * material.scale.u + material.offset.u,
            uv.v * material.scale.v + material.offset.v};
    }
  }
  if (made.textures.empty()) made.of_triangle.clear();
  if (!missing.empty()) {
    file.notes.push_back("the chapter's picture is in place of the materials " + missing + ": " +
                         problems);
  }
  if (!changed.empty()) file.notes.push_back(changed);
  if (!left_out.empty()) file.notes.push_back("left out the options of map_Kd: " + left_out);
  return made;
}

/// With boxes, if it has many triangles.
BoxedMesh boxed(Mesh mesh) {
  if (mesh.triangles.size() <= most_in_a_list) return {std::move(mesh), {}, {}};
  return with_boxes(std::move(mesh));
}

}  // namespace

void MeshOptions::declare(Offer& offer) {
  CommandLine& line = offer.line;
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the mesh about its axis by this angle");
  line.choice(
      "--weights", weights, "signed|heron|picture",
      "how to compute the weights of a triangle's corners: from signed areas, as in the article "
      "from the lengths of the sides, or from areas in the picture, which perspective makes wrong");
  line.text("--mesh", "FILE", file,
            "draw this mesh, an OBJ file with texture coordinates, instead of the crate: with the "
            "pictures and colors of its .mtl file, unless --texture is given, and repeated, or "
            "clamped where that file says so, unless --wrap is given");
  line.choice("--normals", normals, "smooth|flat",
              "how to shade a mesh that has normals: by their mix, or by each triangle's own");
  uv.declare(offer);
}

MeshScene MeshOptions::load(const Chosen& chosen, const Camera& seen_by) {
  camera = seen_by;
  const RotationY rotation = rotation_y(degrees);
  Materials<published::LookUpTexture> materials;
  ObjFile scene;
  if (file.empty()) {
    static_cast<TexturedMesh&>(scene) = crate();
  } else {
    scene = load_obj(path_of(file));
    const bool is_free = !chosen.was_given("--wrap");
    if (is_free) uv.look_up = published::LookUp{Wrap::repeat};
    if (chosen.was_given("--texture")) {  // it replaces all
      scene.material_names.clear();
      scene.materials.clear();
    }
    materials = textures_of(scene, path_of(file), uv, is_free);
    fit_to_crate(scene.mesh);
  }
  for (const std::string& note : scene.notes) chosen.note(file + ": " + note + "\n");
  if (normals == MeshShading::flat) scene.normals.triangles.clear();
  for (Point& p : scene.mesh.points) p = rotation(p);
  for (Vec3d& normal : scene.normals.points) normal = rotation(normal);
  constexpr double reach = 9;
  add_floor(scene, reach);
  if (!materials.of_triangle.empty())
    materials.of_triangle.resize(scene.mesh.triangles.size(), -1);  // the floor has the picture
  if (!scene.normals.triangles.empty()) scene.normals.triangles.resize(scene.mesh.triangles.size());
  return {boxed(std::move(scene.mesh)), std::move(scene.mapping), std::move(scene.normals),
          std::move(materials)};
}

void MeshOptions::place(MeshScene& scene, const Camera& seen_by, double scale, const Vec3d& moved) {
  camera = seen_by;
  for (Point& p : scene.mesh.points) p = p * scale + moved;
  scene.mesh = boxed(std::move(scene.mesh));
}

}  // namespace texmap
