#include "mesh/mesh_io.hpp"

#include <algorithm>
#include <optional>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "mesh/detail/mesh_readers.hpp"
#include "mesh/detail/mesh_writers.hpp"

namespace clast {

namespace {

/// Names of `detect_file_kind`.
constexpr const char* kOriginKind = "origin of coordinates";

bool contains_advice(const std::string& reason) {
  return reason.find("export it") != std::string::npos ||
         reason.find("save it") != std::string::npos;
}

TriangleMesh read_mesh_by_format(const std::filesystem::path& path, const std::string& extension,
                                 const std::string& content) {
  try {
    std::optional<TriangleMesh> mesh;
    if (extension == ".stl") mesh = mesh_detail::read_stl_mesh(content);
    if (extension == ".obj") mesh = mesh_detail::read_obj_mesh(content);
    if (extension == ".ply") mesh = mesh_detail::read_ply_mesh(content);
    if (extension == ".off") mesh = mesh_detail::read_off_mesh(content);
    if (extension == ".tab") mesh = mesh_detail::read_tab_mesh(content);
    if (extension == ".gltf" || extension == ".glb") mesh_detail::check_gltf_extensions(content);
    return mesh ? std::move(*mesh) : mesh_detail::read_with_assimp(path);
  } catch (const InputError& error) {
    const std::string reason = error.what();
    if (contains_advice(reason)) throw;
    throw InputError(reason + "; copy it again, or export it anew from the program that wrote it");
  }
}

void check_usable(const TriangleMesh& mesh, bool points_will_do) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].allFinite()) continue;
    throw InputError("vertex " + std::to_string(v + 1) + " of " +
                     std::to_string(mesh.vertices.size()) + " is " +
                     format_point(mesh.vertices[v]) +
                     ", not a finite point; correct the file in the program that wrote it");
  }
  if (!mesh.triangles.empty()) return;
  if (points_will_do && !mesh.vertices.empty()) return;
  if (mesh.vertices.empty()) {
    throw InputError("holds no vertices and no triangles; export it again");
  }
  throw InputError("is a point cloud with " + std::to_string(mesh.vertices.size()) +
                   " points and no faces; make a closed surface from it first, for example by "
                   "Poisson reconstruction in CloudCompare or MeshLab");
}

/// Floats are good to this share of the coordinate.
constexpr double kFloatDigits = 6e-8;
/// Rounding of a mesh, as a share of its diagonal, that does no harm yet.
constexpr double kHarmless = 1e-5;

/// Whole metres near a mesh that floats would spoil where it is; zero for all others.
Vec3 origin_for_floats(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const double farthest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  if (kFloatDigits * farthest <= kHarmless * box.diagonal()) return Vec3::Zero();
  return (0.5 * (box.low + box.high)).array().round();
}

bool holds_floats(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".stl" || extension == ".glb";
}

std::filesystem::path origin_file(std::filesystem::path mesh) { return mesh += ".origin.txt"; }

/// The same as for the mesh, of its own kind.
OverwritePolicy origin_rules(OverwritePolicy rules) {
  rules.kind = kOriginKind;
  return rules;
}

std::string describe_origin(const Vec3& origin) {
  if (origin.isZero(0.0)) return "";
  return "coordinates = coordinates here + origin, m\n" +
         (kOriginLinePrefix + format_point(origin)) + "\n";
}

std::string mesh_content(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".stl") return mesh_detail::encode_stl(mesh);
  if (extension == ".obj") return mesh_detail::encode_obj(mesh);
  if (extension == ".ply") return mesh_detail::encode_ply(mesh);
  if (extension == ".glb") return mesh_detail::encode_glb(mesh);
  if (extension == ".vtp") return mesh_detail::encode_vtp(mesh);
  throw InputError(path.string() +
                   ": meshes are written as .stl, .obj, .ply, .glb or .vtp; name one of these");
}

/// Commits a mesh and what its origin file says; nothing: a former mesh's file, which would be
/// wrong now, is removed.
void commit_with_origin(OutputFile& mesh, const std::filesystem::path& path,
                        const std::string& text, const OverwritePolicy& rules) {
  if (text.empty()) {
    check_output_target(origin_file(path), rules);
    mesh.commit();
    std::error_code none;
    std::filesystem::remove(resolve_link(origin_file(path)), none);
    return;
  }
  OutputFile origin(origin_file(path), rules);
  origin.write(text);
  mesh.commit();
  origin.commit();
}

TriangleMesh read_any(const std::filesystem::path& path, bool points_will_do) {
  const std::string content = read_text_file(path);
  const std::string extension = lower_case_extension(path);
  const std::vector<std::string>& known = readable_mesh_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw InputError(path.string() + ": meshes are read from " + comma_separated(known) +
                     " files; convert this one first");
  }
  if (content.empty()) {
    throw InputError(path.string() + ": the file is empty; copy or export it again");
  }
  return with_error_context(path.string(), [&] {
    TriangleMesh mesh = read_mesh_by_format(path, extension, content);
    // Cameras write a point that has no place as one that is not finite.
    if (points_will_do && mesh.triangles.empty()) {
      std::erase_if(mesh.vertices, [](const Vec3& v) { return !v.allFinite(); });
    }
    check_usable(mesh, points_will_do);
    return mesh;
  });
}

}  // namespace

const std::vector<std::string>& readable_mesh_extensions() {
  static const std::vector<std::string> kExtensions = {".3ds", ".glb", ".gltf", ".obj",
                                                       ".off", ".ply", ".stl",  ".tab"};
  return kExtensions;
}

TriangleMesh read_mesh(const std::filesystem::path& path) { return read_any(path, false); }

TriangleMesh read_mesh_or_points(const std::filesystem::path& path) { return read_any(path, true); }

void check_mesh_output(const std::filesystem::path& path, const OverwritePolicy& rules) {
  if (holds_floats(path)) check_output_target(origin_file(path), origin_rules(rules));
  check_output_target(path, rules);
}

Vec3 write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                const MeshWriteOptions& output) {
  if (mesh.triangles.empty()) {
    throw GeometryError(path.string() + ": the mesh to write has no triangles");
  }
  OutputFile file(path, output.rules);
  if (!holds_floats(path)) {
    file.write(mesh_content(path, mesh));
    file.commit();
    return Vec3::Zero();
  }
  const Vec3 origin = origin_for_floats(mesh);
  TriangleMesh local = mesh;
  for (Vec3& vertex : local.vertices) vertex -= origin;
  file.write(mesh_content(path, local));
  commit_with_origin(
      file, path, output.describe_origin ? output.describe_origin(origin) : describe_origin(origin),
      origin_rules(output.rules));
  return origin;
}

}  // namespace clast
