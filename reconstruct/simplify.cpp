#include "reconstruct/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/decimation.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/crossing_repair.hpp"

namespace clast {

namespace {

/// Targets tried in turn, as multiples of the one asked for, when a simplified mesh crosses itself.
constexpr double kFewer[] = {1.0, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5};
/// Tunnels of a porous scan need vertices to stay open: with so many times as many the surface may
/// be sound, or become so by closing a tunnel, and can be simplified from there. Closing one takes
/// vertices, for which fewer than asked for leave room.
constexpr double kRefilledAt[] = {1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 0.8, 0.6, 0.45};
constexpr double kMost = 4.0;
/// Maximum ratio of the vertices after and before intersections are cut out and refilled.
constexpr double kMaxRefill = 2.0;
/// Maximum relative volume change by that; the body is later scaled to the scan's volume.
constexpr double kRefillVolume = 0.01;
/// Triangles at one vertex of a surface that is simplified within seconds.
constexpr std::uint32_t kMaxAround = 500;

/// The last way: what still crosses is cut out and filled anew, which closes a tunnel that is too
/// narrow for the number of vertices. None where that doesn't help, or changes more than a sliver.
std::optional<TriangleMesh> refilled(const TriangleMesh& mesh, const Vec3& origin) {
  const std::vector<std::uint32_t> component = triangle_components(mesh);
  if (*std::max_element(component.begin(), component.end()) > 0) return std::nullopt;
  const TriangleMesh start = reconstruct_detail::snapped_to_grid(mesh, origin);
  std::optional<TriangleMesh> freed =
      reconstruct_detail::repair_self_intersections_locally(start, origin);
  if (!freed || static_cast<double>(freed->vertices.size()) >
                    kMaxRefill * static_cast<double>(mesh.vertices.size())) {
    return std::nullopt;
  }
  const double volume = signed_volume(start);
  if (std::abs(signed_volume(*freed) - volume) > kRefillVolume * volume) return std::nullopt;
  return freed;
}

/// The cost of collapsing the edges of a fan grows with the third power of its triangles.
void refuse_wide_fan(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> around(mesh.vertices.size(), 0);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++around[v];
  }
  const auto most = std::max_element(around.begin(), around.end());
  if (*most <= kMaxAround) return;
  throw GeometryError(
      std::to_string(*most) + " triangles meet at one vertex, near " +
      format_point(mesh.vertices[static_cast<std::size_t>(most - around.begin())]) +
      ": simplifying such a fan takes hours; remesh the surface with triangles of even "
      "size first (isotropic remeshing), or request " +
      std::to_string(mesh.vertices.size()) + " vertices, which keeps all of them");
}

}  // namespace

void SimplifyOptions::check() const {
  if (target_vertices < 4) {
    throw InputError("target_vertices = " + std::to_string(target_vertices) +
                     ": a block needs at least 4");
  }
}

TriangleMesh simplify_mesh(const TriangleMesh& mesh, const SimplifyOptions& options) {
  options.check();
  const MeshReport report = inspect_mesh(mesh);
  if (!report.is_closed() || !report.is_oriented() || report.pinched_vertices > 0) {
    throw GeometryError("only a closed surface can be simplified; this one has " +
                        report.summary());
  }
  if (mesh.vertices.size() <= options.target_vertices) return mesh;
  refuse_wide_fan(mesh);

  // About the middle of the block, or map coordinates would cost digits.
  const Bounds box = bounds(mesh);
  const Vec3 origin = 0.5 * (box.low + box.high);
  TriangleMesh centred = mesh;
  for (Vec3& vertex : centred.vertices) vertex -= origin;

  const auto moved = [&](TriangleMesh surface, const Vec3& by) {
    for (Vec3& vertex : surface.vertices) vertex += by;
    return surface;
  };
  const std::size_t most = options.target_vertices;
  const auto times = [&](double multiple) {
    return std::max<std::size_t>(4, static_cast<std::size_t>(multiple * static_cast<double>(most)));
  };
  /// A sound surface of no more vertices than asked for, from one about the middle.
  const auto lighter = [&](const TriangleMesh& from,
                           double multiple) -> std::optional<TriangleMesh> {
    std::optional<TriangleMesh> sound =
        untangle_self_intersections(moved(decimate_mesh(from, times(multiple)), origin));
    if (!sound || sound->vertices.size() > most) return std::nullopt;
    return sound;
  };
  const auto lightest = [&](const TriangleMesh& from) -> std::optional<TriangleMesh> {
    for (const double multiple : kFewer) {
      if (std::optional<TriangleMesh> found = lighter(from, multiple)) return found;
    }
    return std::nullopt;
  };
  if (std::optional<TriangleMesh> found = lighter(centred, 1.0)) return std::move(*found);
  const TriangleMesh finer = decimate_mesh(centred, times(kMost));
  if (std::optional<TriangleMesh> found = lightest(finer)) return std::move(*found);
  TriangleMesh first;
  std::optional<std::size_t> fewest;
  for (const double multiple : kRefilledAt) {
    const TriangleMesh tried = decimate_mesh(finer, times(multiple));
    if (first.triangles.empty()) first = moved(tried, origin);
    std::optional<TriangleMesh> sound = untangle_self_intersections(moved(tried, origin));
    if (!sound) {
      sound = refilled(tried, origin);
      if (sound) sound = moved(std::move(*sound), origin);
      if (sound && !find_self_intersections(*sound).empty()) sound.reset();
    }
    if (!sound) continue;
    if (sound->vertices.size() <= most) return std::move(*sound);
    fewest = std::min(fewest.value_or(sound->vertices.size()), sound->vertices.size());
    if (std::optional<TriangleMesh> found = lightest(moved(*sound, -origin))) {
      return std::move(*found);
    }
  }
  const auto crossings = find_self_intersections(first);
  const auto input_crossings = find_self_intersections(mesh);
  std::string message = "simplified to " + std::to_string(options.target_vertices) +
                        " vertices the surface intersects itself";
  if (!crossings.empty()) {
    message += " near " + format_point(first.vertices[first.triangles[crossings[0][0]][0]]);
  }
  message += input_crossings.empty()
                 ? fewest ? "; request " + std::to_string(*fewest) +
                                " vertices, the fewest found without self-intersections"
                          : "; request more vertices"
                 : "; the scan also intersects itself, at " +
                       std::to_string(input_crossings.size()) +
                       " pairs of triangles, the first near " +
                       format_point(mesh.vertices[mesh.triangles[input_crossings[0][0]][0]]) +
                       ": repair it there, or request more vertices";
  throw GeometryError(message);
}

}  // namespace clast
