#include "shapes/mesh_io.hpp"

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text_file.hpp"
#include "shapes/detail/mesh_readers.hpp"
#include "shapes/detail/mesh_writers.hpp"

namespace clast {

namespace {

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

TriangleMesh read_by_format(const std::filesystem::path& path, const std::string& extension,
                            const std::string& content) {
  std::optional<TriangleMesh> mesh;
  if (extension == ".stl") mesh = detail::read_stl(content);
  if (extension == ".obj") mesh = detail::read_obj(content);
  if (extension == ".ply") mesh = detail::read_ply(content);
  if (extension == ".off") mesh = detail::read_off(content);
  if (extension == ".tab") mesh = detail::read_tab(content);
  return mesh ? std::move(*mesh) : detail::read_with_assimp(path);
}

void check_usable(const TriangleMesh& mesh, bool points_will_do) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].allFinite()) continue;
    throw InputError("vertex " + std::to_string(v + 1) + " of " +
                     std::to_string(mesh.vertices.size()) + " is " + place(mesh.vertices[v]) +
                     ", not a finite point; clean the file in the program that wrote it");
  }
  if (!mesh.triangles.empty()) return;
  if (points_will_do && !mesh.vertices.empty()) return;
  if (mesh.vertices.empty()) throw InputError("holds no vertices and no triangles");
  throw InputError("is a point cloud with " + std::to_string(mesh.vertices.size()) +
                   " points and no faces; make a closed surface of it first, for example by "
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

TriangleMesh read_any(const std::filesystem::path& path, bool points_will_do) {
  const std::string content = read_text_file(path);
  const std::string extension = extension_of(path);
  const std::vector<std::string>& known = readable_mesh_extensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    throw InputError(path.string() + ": meshes are read from " + listed(known) +
                     " files; convert this one first");
  }
  if (content.empty()) throw InputError(path.string() + ": the file is empty");
  try {
    TriangleMesh mesh = read_by_format(path, extension, content);
    // Cameras write a point that has no place as one that is not finite.
    if (points_will_do && mesh.triangles.empty()) {
      std::erase_if(mesh.vertices, [](const Vec3& v) { return !v.allFinite(); });
    }
    check_usable(mesh, points_will_do);
    return mesh;
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace

const std::vector<std::string>& readable_mesh_extensions() {
  static const std::vector<std::string> kExtensions = {".3ds", ".glb", ".gltf", ".obj",
                                                       ".off", ".ply", ".stl",  ".tab"};
  return kExtensions;
}

TriangleMesh read_mesh(const std::filesystem::path& path) { return read_any(path, false); }

TriangleMesh read_mesh_or_points(const std::filesystem::path& path) { return read_any(path, true); }

Vec3 write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  const std::string extension = extension_of(path);
  if (mesh.triangles.empty()) throw GeometryError(path.string() + ": a mesh without triangles");
  const bool floats = extension == ".stl" || extension == ".glb";
  const Vec3 origin = floats ? origin_for_floats(mesh) : Vec3(Vec3::Zero());
  if (!origin.isZero(0.0)) {
    TriangleMesh local = mesh;
    for (Vec3& vertex : local.vertices) vertex -= origin;
    write_mesh(path, local);
    write_text_file(path.string() + ".origin.txt",
                    "coordinates = coordinates here + origin, m\norigin " + place(origin) + "\n");
    return origin;
  }
  std::string content;
  if (extension == ".stl") {
    content = detail::stl_content(mesh);
  } else if (extension == ".obj") {
    content = detail::obj_content(mesh);
  } else if (extension == ".ply") {
    content = detail::ply_content(mesh);
  } else if (extension == ".glb") {
    content = detail::glb_content(mesh);
  } else if (extension == ".vtp") {
    content = detail::vtp_content(mesh);
  } else {
    throw InputError(path.string() + ": meshes are written as .stl, .obj, .ply, .glb or .vtp");
  }
  write_text_file(path, content);
  return origin;
}

}  // namespace clast
