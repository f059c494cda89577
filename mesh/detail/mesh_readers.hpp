#pragma once
/// Readers of mesh formats. They return vertices and triangles as stored; `read_mesh` checks them.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::mesh_detail {

/// Reads a mesh in double precision; empty for format variants that only assimp can read.
/// @throws InputError  if the file is corrupt or truncated; the message does not name the file
std::optional<TriangleMesh> read_stl_mesh(std::string_view content);
std::optional<TriangleMesh> read_obj_mesh(std::string_view content);
std::optional<TriangleMesh> read_ply_mesh(std::string_view content);
/// Reads named properties of the vertices; a column for each name, in the order of `names`.
/// @throws InputError  as `read_ply_mesh`, or if there is no such property
std::vector<std::vector<double>> read_ply_vertex_values(std::string_view content,
                                                        const std::vector<std::string>& names);
std::optional<TriangleMesh> read_off_mesh(std::string_view content);
std::optional<TriangleMesh> read_tab_mesh(std::string_view content);

/// Refuses glTF files whose geometry needs an extension, which assimp ignores without an error.
/// @param content  content of a .gltf or .glb file
/// @throws InputError  if there is such an extension; the message names it but not the file
void check_gltf_extensions(std::string_view content);

/// Reads all meshes of a scene with assimp in single precision. Node transforms are applied.
/// @throws InputError  if assimp cannot read the file; the message does not name it
TriangleMesh read_with_assimp(const std::filesystem::path& path);

}  // namespace clast::mesh_detail
