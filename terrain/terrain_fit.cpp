#include "terrain/terrain_fit.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/raw_surface.hpp"

namespace clast {
namespace {

constexpr double kLongEdges = 3.0;    // of the largest block: what is rougher is not in the survey
constexpr double kShortEdges = 0.05;  // of the smallest block

/// Ends of the border edges, on the map.
std::vector<std::pair<Vec2, Vec2>> border_edges(const Terrain& terrain) {
  const TriangleMesh& mesh = terrain.surface;
  const TriangleNeighbours links = triangle_neighbours(mesh);
  std::vector<std::pair<Vec2, Vec2>> edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!links.is_border_side(t, k)) continue;
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      edges.emplace_back(terrain.frame.to_map(mesh.vertices[a]).head<2>(),
                         terrain.frame.to_map(mesh.vertices[b]).head<2>());
    }
  }
  return edges;
}

double distance_to(std::span<const std::pair<Vec2, Vec2>> edges, const Vec2& place) {
  double nearest = 1e300;
  for (const auto& [a, b] : edges) {
    const double length = (b - a).squaredNorm();
    const double share = length > 0.0 ? std::clamp((place - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (a + share * (b - a) - place).norm());
  }
  return nearest;
}

}  // namespace

double border_distance(const Terrain& terrain, const Vec2& place) {
  return distance_to(border_edges(terrain), place);
}

void check_positions_over_terrain(const Terrain& terrain, std::span<const Vec3> positions,
                                  const std::string& name) {
  const TriangleMesh& mesh = terrain.surface;
  const terrain_detail::PlanIndex index(terrain_detail::plan_boxes(mesh));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec2 at = terrain.frame.to_local(positions[i]).head<2>();
    const std::span<const std::uint32_t> near = index.boxes_near(at);
    if (std::any_of(near.begin(), near.end(), [&](std::uint32_t t) {
          return terrain_detail::height_on_triangle(mesh, t, at).has_value();
        })) {
      continue;
    }
    const Bounds box = bounds(mesh);
    const Vec3 low = terrain.frame.to_map(box.low), high = terrain.frame.to_map(box.high);
    const bool in_box = (at.array() >= box.low.head<2>().array()).all() &&
                        (at.array() <= box.high.head<2>().array()).all();
    throw InputError(name + ": release point " + std::to_string(i + 1) + " at " +
                     format_map_point(positions[i]) +
                     (in_box ? " is over a hole or outside the ground" : " is off the ground") +
                     ", which lies in x " + format_significant(low.x(), 9) + " to " +
                     format_significant(high.x(), 9) + ", y " + format_significant(low.y(), 9) +
                     " to " + format_significant(high.y(), 9) +
                     " (map, z up); move the point, or check its map system and up axis");
  }
}

void check_positions_near_terrain(const Terrain& terrain, std::span<const Vec2> positions,
                                  const std::string& name) {
  const Bounds box = bounds(terrain.surface);
  const Vec2 low = terrain.frame.to_map(box.low).head<2>();
  const Vec2 high = terrain.frame.to_map(box.high).head<2>();
  const double reach = (high - low).maxCoeff();
  for (const Vec2& place : positions) {
    if ((place.array() > low.array() - reach).all() &&
        (place.array() < high.array() + reach).all()) {
      continue;
    }
    throw InputError(name + " at " + format_map_point({place.x(), place.y(), 0.0}) +
                     " is far off the ground, whose lowest x and y are at " +
                     format_map_point({low.x(), low.y(), 0.0}) +
                     "; convert both to one map system");
  }
}

std::optional<std::string> border_warning(const Terrain& terrain, std::span<const Vec3> positions,
                                          double distance) {
  const std::vector<std::pair<Vec2, Vec2>> edges = border_edges(terrain);
  std::size_t near = 0;
  double nearest = distance;
  Vec3 nearest_at = Vec3::Zero();
  for (const Vec3& place : positions) {
    const double to_border = distance_to(edges, place.head<2>());
    if (to_border >= distance) continue;
    ++near;
    if (to_border >= nearest) continue;
    nearest = to_border;
    nearest_at = place;
  }
  if (near == 0) return std::nullopt;
  return std::to_string(near) + " of " + std::to_string(positions.size()) +
         " release points are nearer than " + format_significant(distance, 4) +
         " m to the border of the ground, the nearest, " + format_significant(nearest, 3) +
         " m, at " + format_map_point(nearest_at) +
         "; blocks may leave the survey there, so extend it";
}

std::optional<std::string> edge_length_warning(const Terrain& terrain, double smallest,
                                               double largest) {
  const double edge = median_edge_length(terrain.surface);
  const auto text = [&](const std::string& what, double block, const std::string& advice) {
    return "the edges of the ground, " + format_significant(edge, 3) + " m (median), are " + what +
           " than the blocks, " + format_significant(block, 3) + " m; " + advice;
  };
  if (edge > kLongEdges * largest) {
    return text("much longer", largest,
                "the simulated ground is smoother than the real one: survey it at higher "
                "resolution, or represent its roughness by friction");
  }
  if (edge < kShortEdges * smallest) {
    return text("much shorter", smallest,
                "runs take unnecessarily long: use a coarser resolution or a tolerance");
  }
  return std::nullopt;
}

}  // namespace clast
