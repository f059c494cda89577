#include "dem/surface/block_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "mesh/triangle_mesh.hpp"

namespace clast::dem_detail {
namespace {

/// Parts per square root of the vertex count.
constexpr double kPartsPerRoot = 1.4;
/// Smallest number of features of a part; smaller parts cost more than they save.
constexpr std::size_t kMinPartFeatures = 16;

/// Member of a part: a vertex (radius 0) or a side.
struct Item {
  BlockSide side;
  bool is_vertex = false;
};

std::vector<Item> items_of(const SurfaceFeatures& block) {
  std::vector<Item> items;
  for (std::uint32_t v = 0; v < block.vertices.size(); ++v) {
    if (block.is_pointed_vertex[v]) items.push_back({{v, false, block.vertices[v], 0.0}, true});
  }
  for (std::uint32_t e = 0; e < block.edges.size(); ++e) {
    const SurfaceEdge& edge = block.edges[e];
    if (!edge.is_convex()) continue;
    const auto [a, b] = edge.vertices;
    const Vec3 middle = 0.5 * (block.vertices[a] + block.vertices[b]);
    items.push_back({{e, false, middle, (block.vertices[a] - middle).norm()}, false});
  }
  for (std::uint32_t f = 0; f < block.faces.size(); ++f) {
    const auto [a, b, c] = block.faces[f].vertices;
    const Vec3 middle = (block.vertices[a] + block.vertices[b] + block.vertices[c]) / 3.0;
    const double radius = std::sqrt(std::max({(block.vertices[a] - middle).squaredNorm(),
                                              (block.vertices[b] - middle).squaredNorm(),
                                              (block.vertices[c] - middle).squaredNorm()}));
    items.push_back({{f, true, middle, radius}, false});
  }
  return items;
}

void add_vertex_groups(BlockParts& made, BlockPart& part, const SurfaceFeatures& block) {
  part.first_group = static_cast<std::uint32_t>(made.vertex_groups.size());
  for (std::uint32_t first = part.first_vertex; first < part.end_vertex; first += 4) {
    VertexGroup group;
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      const std::uint32_t v = std::min(first + lane, part.end_vertex - 1);
      const Vec3& vertex = block.vertices[made.vertices[v]];
      group.x[lane] = vertex.x();
      group.y[lane] = vertex.y();
      group.z[lane] = vertex.z();
    }
    made.vertex_groups.push_back(group);
  }
  part.end_group = static_cast<std::uint32_t>(made.vertex_groups.size());
}

void add_part(BlockParts& made, const std::vector<Item>& items, std::span<std::uint32_t> members) {
  std::sort(members.begin(), members.end());
  BlockPart part;
  part.first_vertex = static_cast<std::uint32_t>(made.vertices.size());
  part.first_side = static_cast<std::uint32_t>(made.sides.size());
  Bounds box;
  for (const std::uint32_t i : members) {
    const BlockSide& side = items[i].side;
    box.include(side.centre);
    if (items[i].is_vertex) {
      made.vertices.push_back(side.feature);
    } else {
      made.sides.push_back(side);
    }
  }
  part.centre = 0.5 * (box.low + box.high);
  part.arm = part.centre.norm();
  for (const std::uint32_t i : members) {
    const BlockSide& side = items[i].side;
    part.radius = std::max(part.radius, (side.centre - part.centre).norm() + side.radius);
  }
  part.end_vertex = static_cast<std::uint32_t>(made.vertices.size());
  part.end_side = static_cast<std::uint32_t>(made.sides.size());
  made.parts.push_back(part);
}

void cut(BlockParts& made, const std::vector<Item>& items, std::span<std::uint32_t> members,
         std::size_t largest) {
  if (members.size() <= largest) return add_part(made, items, members);
  Bounds box;
  for (const std::uint32_t i : members) box.include(items[i].side.centre);
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const std::size_t half = members.size() / 2;
  std::nth_element(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half),
                   members.end(), [&](std::uint32_t i, std::uint32_t j) {
                     const double a = items[i].side.centre[axis], b = items[j].side.centre[axis];
                     return a < b || (a == b && i < j);
                   });
  cut(made, items, members.first(half), largest);
  cut(made, items, members.subspan(half), largest);
}

}  // namespace

BlockParts partition_block(const SurfaceFeatures& block) {
  const std::vector<Item> items = items_of(block);
  std::vector<std::uint32_t> members(items.size());
  std::iota(members.begin(), members.end(), 0u);
  const double parts = kPartsPerRoot * std::sqrt(static_cast<double>(block.vertices.size()));
  const auto part_count = static_cast<std::size_t>(static_cast<double>(items.size()) / parts);
  BlockParts made;
  if (!items.empty()) cut(made, items, members, std::max(kMinPartFeatures, part_count));
  for (BlockPart& part : made.parts) add_vertex_groups(made, part, block);
  return made;
}

}  // namespace clast::dem_detail
