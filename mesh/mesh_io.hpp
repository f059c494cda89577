#pragma once
/// Reading and writing of triangle meshes.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Reads OBJ, PLY, STL, OFF, GLB/glTF, 3DS (all meshes of the scene merged, with node transforms)
/// and the asteroid table `.tab` ("v x y z" / "f i j k"). Colours, normals and textures are
/// ignored. Vertices keep the precision of the file: ASCII coordinates are read as double for STL,
/// OBJ, PLY, OFF and tab. Nothing is welded or repaired.
/// @throws InputError  if the file is missing, empty, of unknown format, without triangles, or has
///                     non-finite coordinates (names the first such vertex)
TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads a mesh, or vertices of a file without triangles, of which non-finite ones are skipped.
TriangleMesh read_mesh_or_points(const std::filesystem::path& path);

/// Returns the readable formats as lower-case extensions with the dot.
const std::vector<std::string>& readable_mesh_extensions();

struct MeshWriteOptions {
  OverwritePolicy rules = {};
  /// Returns the text of "<path>.origin.txt" if `origin` (m, may be zero) was subtracted from the
  /// coordinates; an empty text means no such file. Default: coordinates = those in the file +
  /// origin.
  std::function<std::string(const Vec3& origin)> describe_origin = {};
};

/// Prefix of the line with the three coordinates in that text.
inline constexpr const char* kOriginLinePrefix = "origin ";

/// Writes a mesh by extension: .stl (binary), .obj, .ply (binary), .glb, .vtp, atomically and
/// without axis conversion. OBJ, PLY and VTP keep all bits of doubles. STL and GLB store floats: a
/// mesh too far from the origin for them is shifted by whole metres, stated in "<path>.origin.txt",
/// which follows the same rules as the mesh and is removed if outdated.
/// @return the subtracted origin, m, usually zero
/// @throws InputError  if the extension is unknown, as `OutputFile`, or if the disk is full
/// @throws GeometryError  if the mesh has no triangles
Vec3 write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshWriteOptions& output = {});

/// Checks the output of a mesh and of its "<path>.origin.txt".
void check_mesh_output(const std::filesystem::path& path, const OverwritePolicy& rules);

}  // namespace clast
