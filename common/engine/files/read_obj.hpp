// Meshes from files in OBJ format (Wavefront).
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/files/file_error.hpp"
#include "texture/mesh_mapping.hpp"

namespace texmap {

inline constexpr std::size_t max_mesh_bytes = std::size_t{64} << 20;
inline constexpr std::size_t max_mesh_line = std::size_t{1} << 16;
inline constexpr std::size_t max_mesh_triangles = std::size_t{1} << 21;
inline constexpr double max_mesh_number = 1e30;

/// What an OBJ file says.
struct ObjFile : TexturedMesh {
  std::vector<std::string> notes;  ///< what is not drawn as the file says, a sentence each
};

/// The mesh that the text of an OBJ file describes. Reads v, vt and f, with polygons cut into
/// triangles and negative indices; without vt u is NaN. Ignores normals, groups and materials.
///
/// Errors: FileError `line N: why`, for what is no such line: never a part of a mesh.
/// Source: Wavefront, Advanced Visualizer manual, appendix B1 (1993).
[[nodiscard]] ObjFile read_obj(std::string_view text);

/// The mesh in a file of 1 byte to 64 MiB.
/// Errors: FileError `cannot load mesh 'F': why`; std::bad_alloc.
[[nodiscard]] ObjFile load_obj(const std::filesystem::path& path);

}  // namespace texmap
