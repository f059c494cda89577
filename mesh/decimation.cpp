#include "mesh/decimation.hpp"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cmath>
#include <utility>
#include <vector>

#include "mesh/detail/cgal_mesh.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"

namespace clast {
namespace {

namespace Simplification = CGAL::Surface_mesh_simplification;

/// Share of the volume that drawing crossing triangles together may change.
constexpr double kVolumeKept = 1e-3;
/// Rounds of collapsing what crosses.
constexpr int kUntanglings = 20;

/// Edges of a closed mesh with `vertices` vertices: V - E + F = chi and 3 F = 2 E.
std::size_t edges_of(std::size_t vertices, long euler) {
  return static_cast<std::size_t>(3 * (static_cast<long>(vertices) - euler));
}

}  // namespace

TriangleMesh decimate_mesh(const TriangleMesh& mesh, std::size_t vertices) {
  if (mesh.vertices.size() <= vertices) return mesh;
  using Placement = Simplification::LindstromTurk_placement<mesh_detail::CgalMesh>;
  const std::size_t edges = edges_of(vertices, inspect_mesh(mesh).euler_characteristic);
  mesh_detail::CgalMesh surface = mesh_detail::to_cgal_mesh(mesh);
  Simplification::edge_collapse(
      surface, Simplification::Count_stop_predicate<mesh_detail::CgalMesh>(edges + 1),
      CGAL::parameters::get_cost(Simplification::LindstromTurk_cost<mesh_detail::CgalMesh>())
          .get_placement(Placement())
          .filter(Simplification::Bounded_normal_change_filter<>()));
  return mesh_detail::from_cgal_mesh(surface);
}

std::optional<TriangleMesh> untangle_self_intersections(TriangleMesh mesh) {
  const double volume = signed_volume(mesh);
  for (int round = 0; round < kUntanglings; ++round) {
    std::vector<std::uint32_t> crossing;
    for (const auto& pair : find_self_intersections(mesh)) {
      crossing.insert(crossing.end(), pair.begin(), pair.end());
    }
    if (crossing.empty()) {
      const double change = std::abs(signed_volume(mesh) - volume);
      return change <= kVolumeKept * volume ? std::optional(std::move(mesh)) : std::nullopt;
    }
    if (collapse_triangle_edges(mesh, crossing) == 0) break;
  }
  return std::nullopt;
}

}  // namespace clast
