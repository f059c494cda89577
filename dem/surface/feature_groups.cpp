#include "dem/surface/feature_groups.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/disjoint_sets.hpp"

namespace clast::dem_detail {
namespace {

std::vector<std::uint32_t> planes(const SurfaceFeatures& block) {
  DisjointSets joined(block.faces.size());
  for (const SurfaceEdge& edge : block.edges) {
    if (edge.kind == EdgeKind::kFlat) joined.join(edge.faces[0], edge.faces[1]);
  }
  std::vector<std::uint32_t> names;
  for (std::uint32_t f = 0; f < block.faces.size(); ++f) names.push_back(joined.find(f));
  return names;
}

std::vector<std::uint32_t> lines(const SurfaceFeatures& block) {
  DisjointSets joined(block.edges.size());
  for (std::uint32_t v = 0; v < block.vertices.size(); ++v) {
    std::vector<std::uint32_t> sharp;
    for (const std::uint32_t e : block.edges_at(v)) {
      if (block.edges[e].kind != EdgeKind::kFlat) sharp.push_back(e);
    }
    if (sharp.size() == 2 && are_collinear(block.edge_direction_from(sharp[0], v),
                                           block.edge_direction_from(sharp[1], v))) {
      joined.join(sharp[0], sharp[1]);
    }
  }
  std::vector<std::uint32_t> names;
  for (std::uint32_t e = 0; e < block.edges.size(); ++e) {
    names.push_back(static_cast<std::uint32_t>(block.faces.size()) + joined.find(e));
  }
  return names;
}

}  // namespace

FeatureGroups find_feature_groups(const SurfaceFeatures& block) {
  FeatureGroups made;
  made.group_of_face = planes(block);
  made.group_of_edge = lines(block);
  std::vector<std::array<std::uint32_t, 2>> found;  // vertex, group
  for (std::uint32_t f = 0; f < block.faces.size(); ++f) {
    for (const std::uint32_t v : block.faces[f].vertices) {
      found.push_back({v, made.group_of_face[f]});
    }
  }
  for (std::uint32_t e = 0; e < block.edges.size(); ++e) {
    if (!block.edges[e].is_convex()) continue;
    for (const std::uint32_t v : block.edges[e].vertices) {
      found.push_back({v, made.group_of_edge[e]});
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  made.offsets.assign(block.vertices.size() + 1, 0);
  for (const auto& [vertex, group] : found) {
    ++made.offsets[vertex + 1];
    made.groups_of_vertices.push_back(group);
  }
  std::partial_sum(made.offsets.begin(), made.offsets.end(), made.offsets.begin());
  return made;
}

}  // namespace clast::dem_detail
