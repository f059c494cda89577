#include "dem/search/edge_penetration.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace clast::dem_detail {
namespace {

/// Returns where the segment passes through the face, as a fraction of its length.
std::optional<double> through(const SurfaceFeatures& surface, const SurfaceFace& face,
                              const Vec3& start, const Vec3& end) {
  const Vec3& first_vertex = surface.vertices[face.vertices[0]];
  const double before = face.normal.dot(start - first_vertex),
               after = face.normal.dot(end - first_vertex);
  if ((before > 0.0) == (after > 0.0)) return std::nullopt;
  const double fraction = before / (before - after);
  if (distance_inside_face(surface, face, start + fraction * (end - start)) < 0.0)
    return std::nullopt;
  return fraction;
}

/// Largest depth of the midpoints between the ends of a segment and its intersections with faces.
double deepest_middle(const IndexedSurface& surface, const Vec3& start, const Vec3& end,
                      std::vector<double> shares) {
  shares.insert(shares.end(), {0.0, 1.0});
  std::sort(shares.begin(), shares.end());
  double deepest = 0.0;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    const Vec3 middle = start + 0.5 * (shares[i] + shares[i + 1]) * (end - start);
    const auto nearest = surface.nearest_point(middle, 2.0 * (end - start).norm());
    if (nearest) deepest = std::max(deepest, -nearest->distance);
  }
  return deepest;
}

}  // namespace

double edge_penetration_depth(const IndexedSurface& ground, const BlockSurface& block,
                              const Pose& ground_from_block) {
  const SurfaceFeatures& features = block.features;
  std::vector<Vec3> placed_vertices;
  for (const Vec3& vertex : features.vertices)
    placed_vertices.push_back(ground_from_block * vertex);
  const Pose block_from_ground = ground_from_block.inverse();
  std::map<std::uint32_t, std::vector<double>> of_block, of_ground;
  for (std::uint32_t f = 0; f < features.faces.size(); ++f) {
    const SurfaceFace& face = features.faces[f];
    Bounds box;
    for (const std::uint32_t v : face.vertices) box.include(placed_vertices[v]);
    for (const std::uint32_t g : ground.find_faces_near(box, 0.0)) {
      const SurfaceFace& other = ground.features.faces[g];
      for (const std::uint32_t e : face.edges) {
        const auto& ends = features.edges[e].vertices;
        if (const auto fraction = through(ground.features, other, placed_vertices[ends[0]],
                                          placed_vertices[ends[1]])) {
          of_block[e].push_back(*fraction);
        }
      }
      for (const std::uint32_t e : other.edges) {
        const auto& ends = ground.features.edges[e].vertices;
        if (const auto fraction =
                through(features, face, block_from_ground * ground.features.vertices[ends[0]],
                        block_from_ground * ground.features.vertices[ends[1]])) {
          of_ground[e].push_back(*fraction);
        }
      }
    }
  }
  double deepest = 0.0;
  for (const auto& [e, shares] : of_block) {
    const auto& ends = features.edges[e].vertices;
    deepest = std::max(deepest, deepest_middle(ground, placed_vertices[ends[0]],
                                               placed_vertices[ends[1]], shares));
  }
  for (const auto& [e, shares] : of_ground) {
    const auto& ends = ground.features.edges[e].vertices;
    deepest = std::max(
        deepest, deepest_middle(block, block_from_ground * ground.features.vertices[ends[0]],
                                block_from_ground * ground.features.vertices[ends[1]], shares));
  }
  return deepest > 0.0 ? deepest + ground.radius + block.radius : 0.0;
}

}  // namespace clast::dem_detail
