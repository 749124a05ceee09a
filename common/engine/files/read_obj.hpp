// Meshes from files in OBJ format (Wavefront).
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/file_error.hpp"
#include "math/color.hpp"
#include "scene/mesh_normals.hpp"
#include "texture/mesh_mapping.hpp"

namespace texmap {

inline constexpr std::size_t max_mesh_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_mesh_line = std::size_t{1} << 16;
inline constexpr std::size_t max_mesh_triangles = std::size_t{1} << 21;
inline constexpr std::size_t max_mesh_materials = 10000;
inline constexpr std::size_t max_mesh_libraries = 100;  // .mtl files; more are not looked for
inline constexpr double max_mesh_number = 1e30;

/// What an OBJ file says.
struct ObjFile : TexturedMesh {
  MeshNormals normals{{{{}}, {}}};          ///< no triangles where no face has normals
  std::vector<std::string> notes;           ///< what is not drawn as it says, a sentence each
  std::vector<std::string> material_names;  ///< of usemtl
  std::vector<int> materials;               ///< of each triangle, -1: none; empty: no usemtl
  std::vector<std::string> libraries;       ///< of mtllib, as written
};

/// The mesh that the text of an OBJ file describes. Reads v, vt, vn and f, usemtl and mtllib, with
/// polygons cut into triangles and negative indices; without vt u is NaN.
///
/// Errors: FileError `line N: why`, for what is no such line: never a part of a mesh.
/// Source: Wavefront, Advanced Visualizer manual, appendix B1 (1993).
[[nodiscard]] ObjFile read_obj(std::string_view text);

/// A material, as far as it is a color.
struct Material {
  Rgb color{0.8, 0.8, 0.8};              ///< Kd
  std::string picture{};                 ///< map_Kd, as written; empty: none
  Uv<double> scale{1, 1}, offset{0, 0};  ///< its options -s and -o
  bool clamped = false;                  ///< -clamp on: beyond 0 to 1 its edge goes on
  double base = 0, gain = 1;             ///< -mm: each channel is base + gain * its texel's
  std::string left_out{};                ///< its other options
};

/// The materials in the text of an .mtl file, by name. What is not understood is left out.
/// Errors: FileError `line N: why`, for lines that are too long or no text.
[[nodiscard]] std::map<std::string, Material> read_mtl(std::string_view text);

/// The materials of a file. The names of their pictures become paths, relative to that file.
/// Errors: FileError `cannot load materials 'F': why`; std::bad_alloc.
[[nodiscard]] std::map<std::string, Material> load_mtl(const std::filesystem::path& path);

/// The file that another one names. Some programs write folders of their own machine: where there
/// is no such file, it is looked for in the folder of the other one.
[[nodiscard]] std::filesystem::path beside(const std::filesystem::path& file, std::string name);

/// The mesh in a file of 1 byte to 64 MiB.
/// Errors: FileError `cannot load mesh 'F': why`; std::bad_alloc.
[[nodiscard]] ObjFile load_obj(const std::filesystem::path& path);

}  // namespace texmap
