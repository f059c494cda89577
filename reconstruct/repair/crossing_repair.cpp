#include "reconstruct/repair/crossing_repair.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/detail/crossings.hpp"
#include "reconstruct/repair/detail/wrap.hpp"
#include "reconstruct/repair/holes.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Share of the diagonal by which vertices that lie on one another are moved apart.
constexpr double kPartedBy = 1e-6;
/// Rings of triangles around crossings that are cut out at most.
constexpr int kCutRings = 5;
/// Relative change of the volume by a wrap, whose own bias is a few per cent, that is scaled back.
constexpr double kWrapVolume = 0.08;
/// And by a coarse wrap, tried first: around a tangle the fine one costs seconds and is refused.
constexpr double kCoarseWrapVolume = 0.5;

/// The strategies, each from the surface that the one before left.
class CrossingRepair {
 public:
  CrossingRepair(TriangleMesh mesh, const Vec3& origin)
      : mesh_(std::move(mesh)), origin_(origin), volume_(std::abs(signed_volume(mesh_))) {}

  std::optional<TriangleMesh> locally() {
    if (auto free = by_parting()) return free;
    if (auto free = by_smoothing()) return free;
    return by_cutting();
  }

  std::optional<IntersectionFreeSurface> by_wrapping() const {
    const TriangleMesh coarse = wrap_surface(mesh_, kCoarseWrap);
    const double coarse_ratio = std::abs(signed_volume(coarse)) / volume_;
    if (!(std::abs(coarse_ratio - 1.0) <= kCoarseWrapVolume)) return std::nullopt;
    std::optional<TriangleMesh> sound = if_sound(wrap_surface(mesh_, kFineWrap), kWrapVolume);
    if (!sound) return std::nullopt;
    const double ratio = signed_volume(*sound) / volume_;
    const Bounds box = bounds(*sound);
    const Vec3 middle = 0.5 * (box.low + box.high);
    for (Vec3& v : sound->vertices) v = middle + (v - middle) / std::cbrt(ratio);
    sound = if_sound(std::move(*sound), kMaxIntersectionVolumeChange);
    if (!sound) return std::nullopt;
    return IntersectionFreeSurface{std::move(*sound), ratio - 1.0};
  }

 private:
  /// `mesh` when it is what is wanted, and its volume is about that of the surface.
  std::optional<TriangleMesh> if_sound(TriangleMesh mesh, double change) const {
    mesh = snapped_to_grid(std::move(mesh), origin_);
    const MeshReport report = inspect_mesh(mesh);
    if (!report.is_closed() || !report.is_oriented() || report.pinched_vertices > 0 ||
        report.components != 1) {
      return std::nullopt;
    }
    const double ratio = std::abs(signed_volume(mesh)) / volume_;
    if (!(std::abs(ratio - 1.0) <= change) || !find_self_intersections(mesh).empty()) {
      return std::nullopt;
    }
    return mesh;
  }

  /// Separates touching sheets by a small distance, on an outward copy if necessary. The vertices
  /// stay separated for the next methods.
  std::optional<TriangleMesh> by_parting() {
    const bool inward = signed_volume(mesh_) < 0.0;
    if (inward) flip_orientation(mesh_);
    separate_touching_vertices(mesh_, kPartedBy * bounds(mesh_).diagonal());
    if (inward) flip_orientation(mesh_);
    return if_sound(mesh_, kMaxIntersectionVolumeChange);
  }

  std::optional<TriangleMesh> by_smoothing() const {
    TriangleMesh trial = mesh_;
    if (!replace_intersecting_triangles(trial)) return std::nullopt;
    return if_sound(std::move(trial), kMaxIntersectionVolumeChange);
  }

  /// Cuts the crossing triangles out with more and more rings around them, and fills anew.
  std::optional<TriangleMesh> by_cutting() const {
    TriangleMesh trial = mesh_;
    for (int rings = 0; rings < kCutRings; ++rings) {
      std::vector<bool> near(trial.vertices.size(), false);
      for (const auto& pair : find_self_intersections(trial)) {
        for (const std::uint32_t t : pair) {
          for (const std::uint32_t v : trial.triangles[t]) near[v] = true;
        }
      }
      const auto touched = [&](const TriangleMesh::Triangle& t) {
        return near[t[0]] || near[t[1]] || near[t[2]];
      };
      for (int ring = 0; ring < rings; ++ring) {
        std::vector<bool> wider = near;
        for (const TriangleMesh::Triangle& t : trial.triangles) {
          if (touched(t)) wider[t[0]] = wider[t[1]] = wider[t[2]] = true;
        }
        near = std::move(wider);
      }
      std::erase_if(trial.triangles, touched);
      if (trial.triangles.empty()) return std::nullopt;
      trial = std::move(connected_components(trial).front().mesh);
      split_non_manifold_vertices(trial);
      fill_holes_with_fans(trial, kMaxFanEdges);
      if (inspect_mesh(trial).boundary_edges > 0) fill_holes(trial);
      if (!inspect_mesh(trial).is_closed()) return std::nullopt;
      if (auto sound = if_sound(trial, kMaxIntersectionVolumeChange)) return sound;
    }
    return std::nullopt;
  }

  TriangleMesh mesh_;
  const Vec3 origin_;
  const double volume_;
};

}  // namespace

TriangleMesh snapped_to_grid(TriangleMesh mesh, const Vec3& origin) {
  for (Vec3& v : mesh.vertices) {
    const Vec3 there = v + origin;
    v = there - origin;
  }
  return mesh;
}

std::optional<TriangleMesh> repair_self_intersections_locally(const TriangleMesh& mesh,
                                                              const Vec3& origin) {
  return CrossingRepair(mesh, origin).locally();
}

std::optional<IntersectionFreeSurface> repair_self_intersections(const TriangleMesh& mesh,
                                                                 const Vec3& origin) {
  CrossingRepair repair(mesh, origin);
  if (auto free = repair.locally()) return IntersectionFreeSurface{std::move(*free), {}};
  return repair.by_wrapping();
}

}  // namespace clast::reconstruct_detail
