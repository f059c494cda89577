#pragma once
/// Reading and writing of triangle meshes.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Reads OBJ, PLY, STL, OFF, GLB/glTF, 3DS and the asteroid table `.tab` ("v x y z" / "f i j k").
/// All meshes of a scene are merged, with their node transforms. Colours, normals and textures are
/// ignored. STL, OBJ, PLY, OFF and tab are read in double precision. Nothing is welded or repaired.
/// @throws InputError  if the file is missing, empty, of unknown format or without triangles, or if
///                     a coordinate is not finite
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads a mesh. If the file has no triangles, reads its vertices and skips non-finite ones.
TriangleMesh read_mesh_or_points(const std::filesystem::path& path);

/// Returns the readable formats as lower-case extensions with the dot.
const std::vector<std::string>& readable_mesh_extensions();

struct MeshWriteOptions {
  OverwritePolicy rules = {};
  /// Returns the text of "<path>.origin.txt" for the `origin` (m) subtracted from the coordinates.
  /// If the text is empty, no file is written. The default text states how to add the origin.
  std::function<std::string(const Vec3& origin)> describe_origin = {};
};

/// Prefix of the line with the three coordinates in "<path>.origin.txt".
inline constexpr const char* kOriginLinePrefix = "origin ";

/// Writes a mesh atomically and without axis conversion. The extension selects the format: .stl
/// (binary), .obj, .ply (binary), .glb or .vtp. OBJ, PLY and VTP keep all bits of doubles. STL and
/// GLB store floats. A mesh that is too far from the origin for floats is shifted by whole metres.
/// The shift is written to "<path>.origin.txt"; an outdated file of this name is removed.
/// @return the subtracted origin, m, usually zero
/// @throws InputError  if the extension is unknown or the disk is full; or as `OutputFile`
/// @throws GeometryError  if the mesh has no triangles
Vec3 write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshWriteOptions& output = {});

/// Checks that a mesh and its "<path>.origin.txt" can be written.
void check_mesh_output(const std::filesystem::path& path, const OverwritePolicy& rules);

}  // namespace clast
