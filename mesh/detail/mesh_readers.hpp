#pragma once
/// One reader per mesh format. Each takes the file's bytes and gives vertices and triangles as
/// they stand in the file; `read_mesh` checks what comes out.
#include <filesystem>
#include <optional>
#include <string_view>

#include "mesh/triangle_mesh.hpp"

namespace clast::mesh_detail {

/// Readers in double precision. "None" means a variant that only assimp knows.
/// @throws InputError  corrupt or truncated; the message has no file name
std::optional<TriangleMesh> read_stl(std::string_view content);
std::optional<TriangleMesh> read_obj(std::string_view content);
std::optional<TriangleMesh> read_ply(std::string_view content);
std::optional<TriangleMesh> read_off(std::string_view content);
std::optional<TriangleMesh> read_tab(std::string_view content);

/// Refuses glTF whose shapes need an extension, by its name: assimp reads such files as if they did
/// without, and gives other coordinates.
/// @param content  of a .gltf or .glb file
/// @throws InputError  the message has no file name
void check_gltf_extensions(std::string_view content);

/// Every mesh of a scene through assimp, in single precision, with the transforms of its nodes.
/// @throws InputError  assimp can't read it; the message has no file name
TriangleMesh read_with_assimp(const std::filesystem::path& path);

}  // namespace clast::mesh_detail
