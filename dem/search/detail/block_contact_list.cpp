// Candidate list of two blocks: features that may touch within displacements up to the margin.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "dem/search/block_narrow_phase.hpp"
#include "dem/surface/ghost_edges.hpp"
#include "dem/surface/trim.hpp"

namespace clast::dem_detail {

/// Edge or face of the block that lies low enough to touch, in the frame of the ground.
struct TransformedSide {
  std::uint32_t index;  ///< of BlockParts::sides
  bool is_face;
  Vec3 centre;
  double radius;
  double lowest;      ///< smallest coordinate of its vertices along the direction, m
  double beyond;      ///< its `depth_beyond_plane`, m
  EdgeNormalArc arc;  ///< out of the ground, with slack for rotation; for a face, twice its normal
  Vec3 direction;     ///< direction of an edge
};

namespace {

/// Number of directions that are tried for a list.
constexpr int kTries = 6;
/// Tolerance for rounding at the limits of the list, m.
constexpr double kListRounding = 1e-9;

/// Features of one part between the planes, as ranges in the lists of `ListScratch`.
struct PartBetween {
  Vec3 centre;
  double radius;
  std::size_t first_edge, end_edge;      ///< of the ground
  std::size_t first_corner, end_corner;  ///< likewise
};

/// Temporary data for making a list, kept to save allocations. Shared by the pairs of a thread.
struct ListScratch {
  std::vector<double> ground_heights, block_heights;  ///< of the vertices along the direction, m
  std::vector<PartBetween> ground_parts;
  std::vector<std::uint32_t> edges, ground_vertices;  ///< of the ground: sides and vertices
  std::vector<TransformedSide> sides;                 ///< of one part of the block

  double lowest_of_block(std::span<const std::uint32_t> vertices) const {
    double height = 1e300;
    for (const std::uint32_t v : vertices) height = std::min(height, block_heights[v]);
    return height;
  }
};
ListScratch& list_scratch() {
  thread_local ListScratch of_thread;
  return of_thread;
}

/// Returns the farthest vertex along a direction.
std::uint32_t farthest(const SurfaceFeatures& surface, const Vec3& direction) {
  std::uint32_t best = 0;
  double height = -1e300;
  for (std::uint32_t v = 0; v < surface.vertices.size(); ++v) {
    const double h = direction.dot(surface.vertices[v]);
    if (h > height) {
      height = h;
      best = v;
    }
  }
  return best;
}

bool within(const Vec3& separation, double distance) {
  return separation.squaredNorm() <= distance * distance;
}

}  // namespace

double BlockNarrowPhase::improve_separating_direction() {
  Vec3 direction = direction_.isZero() ? tests_.position() : direction_;
  direction = direction.norm() > 0.0 ? direction.normalized() : Vec3(Vec3::UnitZ());
  double widest = -1e300;
  for (int i = 0; i < kTries; ++i) {
    const Vec3& of_ground = ground_.features.vertices[farthest(ground_.features, direction)];
    const Vec3 of_block = tests_.in_ground_frame(block_.features.vertices[farthest(
        block_.features, -(tests_.rotation().transpose() * direction))]);
    const Vec3 between = of_block - of_ground;
    const double gap = direction.dot(between);
    if (gap > widest) {
      widest = gap;
      direction_ = direction;
    }
    const double distance = between.norm();
    if (gap > listing_distance() || !(distance > 0.0)) break;
    // If the bodies are apart, the direction between the nearest vertices is better. Otherwise the
    // direction is reflected about it (Chung and Wang 1996).
    const Vec3 axis = between / distance;
    direction = gap > 0.0 ? axis : (direction - 2.0 * direction.dot(axis) * axis).normalized();
  }
  return widest;
}

void BlockNarrowPhase::build_candidate_list() {
  vertices_.clear();
  faces_.clear();
  pairs_.clear();
  max_listed_depth_ = contact_distance();
  const double gap = improve_separating_direction();
  if (gap > listing_distance()) {
    list_valid_until_ = displacement_ + gap - max_listed_depth_;
  } else {
    list_valid_until_ = displacement_ + margin_;
    collect_features();
  }
  shrink_capacity(vertices_, faces_, pairs_);
}

void BlockNarrowPhase::collect_features() {
  ListScratch& s = list_scratch();
  const Vec3 in_block = tests_.rotation().transpose() * direction_;
  const double offset = direction_.dot(tests_.position());
  s.ground_heights.clear();
  s.block_heights.clear();
  for (const Vec3& vertex : ground_.features.vertices) {
    s.ground_heights.push_back(direction_.dot(vertex));
  }
  for (const Vec3& vertex : block_.features.vertices) {
    s.block_heights.push_back(in_block.dot(vertex) + offset);
  }
  low_ = *std::min_element(s.block_heights.begin(), s.block_heights.end());
  high_ = *std::max_element(s.ground_heights.begin(), s.ground_heights.end());
  collect_ground_features();
  const double room = listing_distance() + kListRounding;
  for (const BlockPart& part : block_.parts.parts) {
    if (in_block.dot(part.centre) + offset - part.radius > high_ + room) continue;
    collect_vertices(part);
    collect_sides(part);
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const CandidatePair& a, const CandidatePair& b) {
    return std::tuple(a.side, a.kind, a.ground_feature) <
           std::tuple(b.side, b.kind, b.ground_feature);
  });
}

void BlockNarrowPhase::collect_ground_features() {
  ListScratch& s = list_scratch();
  const double room = listing_distance() + kListRounding;
  s.ground_parts.clear();
  s.edges.clear();
  s.ground_vertices.clear();
  for (const BlockPart& part : ground_.parts.parts) {
    if (direction_.dot(part.centre) + part.radius < low_ - room) continue;
    PartBetween between{part.centre, part.radius, s.edges.size(), 0, s.ground_vertices.size(), 0};
    for (std::uint32_t i = part.first_side; i < part.end_side; ++i) {
      const BlockSide& side = ground_.parts.sides[i];
      if (side.is_face) continue;
      const auto [a, b] = ground_.features.edges[side.feature].vertices;
      if (std::max(s.ground_heights[a], s.ground_heights[b]) >=
          low_ - depth_beyond_plane(ground_.edge_normal_arcs[side.feature])) {
        s.edges.push_back(i);
      }
    }
    for (std::uint32_t i = part.first_vertex; i < part.end_vertex; ++i) {
      const std::uint32_t v = ground_.parts.vertices[i];
      if (s.ground_heights[v] >= low_ - room) s.ground_vertices.push_back(v);
    }
    between.end_edge = s.edges.size();
    between.end_corner = s.ground_vertices.size();
    s.ground_parts.push_back(between);
  }
}

void BlockNarrowPhase::collect_vertices(const BlockPart& part) {
  const double listed = tests_.reach() + margin_ + kListRounding;
  for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
    const std::uint32_t vertex = block_.parts.vertices[v];
    if (list_scratch().block_heights[vertex] > high_ + listed) continue;
    const Vec3 centre = tests_.in_ground_frame(block_.features.vertices[vertex]);
    const Vec3 in_box = centre.cwiseMax(ground_.extent.low).cwiseMin(ground_.extent.high);
    if (within(centre - in_box, listed)) collect_vertex(vertex, centre, listed);
  }
}

void BlockNarrowPhase::collect_vertex(std::uint32_t vertex, const Vec3& centre, double listed) {
  // A vertex inside the ground is at most as deep as its distance below the highest ground point.
  const double deepest = high_ - list_scratch().block_heights[vertex] + kListRounding;
  const std::optional<NearestPoint> nearest =
      ground_.nearest_point(centre, std::max(listed, deepest), near_face_);
  if (!nearest) return;
  near_face_ = nearest->face;
  if (nearest->distance > listed) return;
  collect_near_faces(centre, std::max(std::abs(nearest->distance), tests_.reach()) + 2.0 * margin_ +
                                 kListRounding);
  vertices_.push_back(
      {.vertex = vertex, .near_face = 0, .end_face = static_cast<std::uint32_t>(faces_.size())});
}

void BlockNarrowPhase::collect_near_faces(const Vec3& centre, double reach) {
  const PlanGrid& grid = ground_.grid;
  const PlanGrid::CellRange cells = grid.cell_range(centre.x() - reach, centre.x() + reach,
                                                    centre.y() - reach, centre.y() + reach);
  const auto first = static_cast<std::ptrdiff_t>(faces_.size());
  for (int row = cells.first_row; row <= cells.last_row; ++row) {
    for (int column = cells.first_column; column <= cells.last_column; ++column) {
      const PlanGrid::Cell cell = grid.cell(column, row);
      if (cell.low > centre.z() + reach || cell.high < centre.z() - reach) continue;
      for (const std::uint32_t index : cell.faces) {
        const LocalFaces::Face& face = ground_.local_faces[index];
        if (std::abs(face.normal.dot(centre) - face.offset) <= reach &&
            within(centre - face.centre, reach + face.radius)) {
          faces_.push_back(index);
        }
      }
    }
  }
  // A face can be in several cells.
  std::sort(faces_.begin() + first, faces_.end());
  faces_.erase(std::unique(faces_.begin() + first, faces_.end()), faces_.end());
}

void BlockNarrowPhase::collect_sides(const BlockPart& part) {
  ListScratch& s = list_scratch();
  transform_sides(part);
  if (s.sides.empty()) return;
  const double room = listing_distance() + kListRounding;
  const Vec3 centre = tests_.in_ground_frame(part.centre);
  for (const PartBetween& other : s.ground_parts) {
    if (!within(centre - other.centre, part.radius + other.radius + room)) continue;
    const auto edges =
        std::span(s.edges).subspan(other.first_edge, other.end_edge - other.first_edge);
    const auto ground_vertices =
        std::span(s.ground_vertices)
            .subspan(other.first_corner, other.end_corner - other.first_corner);
    for (const TransformedSide& side : s.sides) {
      if (!within(side.centre - other.centre, side.radius + other.radius + room)) continue;
      if (side.is_face) {
        collect_face_pairs(side, ground_vertices);
      } else {
        collect_edge_pairs(side, edges, ground_vertices);
      }
    }
  }
}

void BlockNarrowPhase::transform_sides(const BlockPart& part) {
  ListScratch& s = list_scratch();
  s.sides.clear();
  for (std::uint32_t i = part.first_side; i < part.end_side; ++i) {
    const BlockSide& of_body = block_.parts.sides[i];
    const std::uint32_t feature = of_body.feature;
    const double lowest = of_body.is_face
                              ? s.lowest_of_block(block_.features.faces[feature].vertices)
                              : s.lowest_of_block(block_.features.edges[feature].vertices);
    if (lowest > high_ + listing_distance() + kListRounding) continue;
    TransformedSide side{
        i,  of_body.is_face, tests_.in_ground_frame(of_body.centre), of_body.radius, lowest, 0.0,
        {}, Vec3::Zero()};
    if (side.is_face) {
      side.arc.first = side.arc.second = block_.features.faces[feature].normal;
    } else {
      side.arc = block_.edge_normal_arcs[feature];
      side.direction = tests_.rotation() * block_.features.edges[feature].direction;
    }
    side.arc.first = tests_.rotation() * -side.arc.first;
    side.arc.second = tests_.rotation() * -side.arc.second;
    side.arc.slack += turn_;
    side.beyond = depth_beyond_plane(side.arc);
    if (lowest <= high_ + side.beyond) s.sides.push_back(side);
  }
}

void BlockNarrowPhase::collect_face_pairs(const TransformedSide& side,
                                          std::span<const std::uint32_t> ground_vertices) {
  const ListScratch& s = list_scratch();
  const double room = listing_distance() + kListRounding;
  for (const std::uint32_t ground_vertex : ground_vertices) {
    if (s.ground_heights[ground_vertex] < low_ - side.beyond ||
        !within(side.centre - ground_.features.vertices[ground_vertex], side.radius + room) ||
        !can_vertex_normal_oppose(ground_vertex, side.arc)) {
      continue;
    }
    std::optional<ContactPoint> contact;
    const FeatureSeparation separation =
        tests_.test_face_vertex(block_.parts.sides[side.index].feature, ground_vertex, contact);
    add_candidate_pair(ContactKind::kFaceVertex, side.index, ground_vertex, separation,
                       contact.has_value());
  }
}

void BlockNarrowPhase::collect_edge_pairs(const TransformedSide& side,
                                          std::span<const std::uint32_t> edges,
                                          std::span<const std::uint32_t> ground_vertices) {
  const ListScratch& s = list_scratch();
  const std::uint32_t feature = block_.parts.sides[side.index].feature;
  const double room = listing_distance() + kListRounding;
  std::optional<ContactPoint> contact;
  for (const std::uint32_t i : edges) {
    const BlockSide& other = ground_.parts.sides[i];
    if (!within(side.centre - other.centre, side.radius + other.radius + room) ||
        !can_edge_normals_oppose(ground_.edge_normal_arcs[other.feature],
                                 ground_.features.edges[other.feature].direction, side.arc,
                                 side.direction)) {
      continue;
    }
    contact.reset();
    const FeatureSeparation separation = tests_.test_edge_edge(feature, other.feature, contact);
    add_candidate_pair(ContactKind::kEdgeEdge, side.index, other.feature, separation,
                       contact.has_value());
  }
  const double within_reach = tests_.reach() + margin_ + kListRounding;
  if (!(tests_.reach() > 0.0) || side.lowest > high_ + within_reach) return;
  for (const std::uint32_t ground_vertex : ground_vertices) {
    if (s.ground_heights[ground_vertex] < low_ - within_reach ||
        !within(side.centre - ground_.features.vertices[ground_vertex],
                side.radius + within_reach) ||
        !can_vertex_normal_oppose(ground_vertex, side.arc)) {
      continue;
    }
    contact.reset();
    const FeatureSeparation separation = tests_.test_edge_vertex(feature, ground_vertex, contact);
    add_candidate_pair(ContactKind::kEdgeVertex, side.index, ground_vertex, separation,
                       contact.has_value());
  }
}

void BlockNarrowPhase::add_candidate_pair(ContactKind kind, std::uint32_t side,
                                          std::uint32_t of_ground,
                                          const FeatureSeparation& separation, bool touches) {
  if (!within(separation.separation, listing_distance() + kListRounding)) return;
  pairs_.push_back({kind, side, of_ground, separated_until(separation, touches)});
}

double BlockNarrowPhase::depth_beyond_plane(double along, double slack) const {
  const double farthest = listing_distance() + kListRounding;
  if (along < 0.0) return farthest;
  // A block feature that penetrates the ground along such a normal is below the ground feature.
  return std::min(farthest, tests_.reach() + margin_ + kListRounding + slack * max_listed_depth_);
}

bool BlockNarrowPhase::can_edge_normals_oppose(const EdgeNormalArc& of_ground,
                                               const Vec3& ground_direction,
                                               const EdgeNormalArc& arc,
                                               const Vec3& direction) const {
  if (of_ground.is_unbounded || arc.is_unbounded) return true;
  const double room = of_ground.slack + arc.slack + kListRounding;
  // The common normal is perpendicular to both edges. An arc on one side of the plane perpendicular
  // to the other edge does not contain it.
  const auto crosses = [&](const EdgeNormalArc& one, const Vec3& pole) {
    const double first = pole.dot(one.first), second = pole.dot(one.second);
    return std::min(first, second) <= room && std::max(first, second) >= -room;
  };
  return crosses(arc, ground_direction) && crosses(of_ground, direction);
}

bool BlockNarrowPhase::can_vertex_normal_oppose(std::uint32_t ground_vertex,
                                                const EdgeNormalArc& arc) const {
  if (arc.is_unbounded) return true;
  const double room = ground_.cone_slacks[ground_vertex] + arc.slack + kListRounding;
  const std::span<const std::uint32_t> edges = ground_.features.edges_at(ground_vertex);
  // If a ray rises along both ends of the arc, it rises along all directions between them.
  return std::none_of(edges.begin(), edges.end(), [&](std::uint32_t edge) {
    const Vec3 edge_direction_from = ground_.features.edge_direction_from(edge, ground_vertex);
    return edge_direction_from.dot(arc.first) > room && edge_direction_from.dot(arc.second) > room;
  });
}

}  // namespace clast::dem_detail
