#pragma once
/// Triangle meshes from and to files.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Reads OBJ, PLY, STL, OFF, GLB/glTF, 3DS (all meshes of the scene merged, node transforms
/// applied) and the asteroid table `.tab` ("v x y z" / "f i j k"). Colours, normals and textures
/// are ignored. Vertices keep the precision the file has: ascii coordinates are read as double
/// for STL, OBJ, PLY, OFF and tab. Nothing is welded or repaired.
/// @throws InputError  missing, empty, of unknown format, without triangles, or with coordinates
///                     that are not finite (the message names the first such vertex)
TriangleMesh read_mesh(const std::filesystem::path& path);

/// The same, but a file with vertices and no triangles is fine too; of these, the ones that are not
/// finite are left out.
TriangleMesh read_mesh_or_points(const std::filesystem::path& path);

/// Formats that `read_mesh` knows, as lower-case extensions with the dot.
const std::vector<std::string>& readable_mesh_extensions();

/// How a mesh file is written.
struct MeshWriteOptions {
  OverwritePolicy rules = {};
  /// What "<path>.origin.txt" says where `origin`, m, was subtracted from the coordinates, zero
  /// included; nothing: there is no such file. Without: coordinates = those in the file + origin.
  std::function<std::string(const Vec3& origin)> describe_origin = {};
};

/// Begins the line of a text for `MeshWriteOptions::describe_origin` that has the three coordinates.
inline constexpr const char* kOriginLinePrefix = "origin ";

/// Writes by extension: .stl (binary), .obj, .ply (binary), .glb, .vtp. Written through a
/// temporary file; coordinates as they are, whatever a format says about its up axis. OBJ, PLY and
/// VTP keep every bit of a double. STL and GLB hold floats: a mesh too far from the origin for them
/// is written less an origin of whole metres near it, which "<path>.origin.txt" states. That file
/// is subject to the same rules as the mesh; one that a former mesh left is removed with it.
/// @return what was taken off the coordinates, m; zero nearly always
/// @throws InputError     unknown extension, as `OutputFile`, or the disk is full
/// @throws GeometryError  the mesh has no triangles
Vec3 write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshWriteOptions& output = {});

/// `check_output_target` for a mesh and the "<path>.origin.txt" that may be written with it.
void check_mesh_output(const std::filesystem::path& path, const OverwritePolicy& rules);

}  // namespace clast
