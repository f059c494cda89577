#include "samples/deposit/separation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/parallel.hpp"
#include "mesh/triangle_tree.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

constexpr int kMaxRounds = 80;
constexpr double kRelaxation = 0.6;  // share of an overlap that one round removes

/// Planes normal . p = support around a surface. Points outside one of them are outside the block.
struct SupportPlane {
  Vec3 normal;
  double support;
};

/// A block prepared for queries in its body frame.
struct Obstacle {
  std::unique_ptr<TriangleTree> tree;
  std::vector<SupportPlane> planes;
  double radius = 0.0;  ///< of the sphere about the origin, m
};

Obstacle make_obstacle(const VirtualBlock& block) {
  Obstacle obstacle;
  obstacle.tree = std::make_unique<TriangleTree>(block.surface);
  const TriangleMesh hull = convex_hull(block.core.shape.vertices);
  for (const TriangleMesh::Triangle& triangle : hull.triangles) {
    const Vec3& a = hull.vertices[triangle[0]];
    const Vec3 normal =
        (hull.vertices[triangle[1]] - a).cross(hull.vertices[triangle[2]] - a).normalized();
    double support = -1e300;
    for (const Vec3& vertex : block.surface.vertices) {
      support = std::max(support, normal.dot(vertex));
    }
    obstacle.planes.push_back({normal, support});
  }
  for (const Vec3& vertex : block.surface.vertices) {
    obstacle.radius = std::max(obstacle.radius, vertex.norm());
  }
  return obstacle;
}

/// Overlap of the vertices of one block with another block.
struct Overlap {
  double depth = 0.0;        ///< of the deepest vertex, m
  Vec3 push = Vec3::Zero();  ///< mean direction out of the other block, weighted by depth
};

Overlap find_overlap(const VirtualBlock& block, const Pose& pose, const Obstacle& other,
                     const Pose& other_pose) {
  const Pose other_from_body = other_pose.inverse() * pose;
  const Mat3 rotation = other_from_body.rotation.toRotationMatrix();
  Overlap overlap;
  std::uint32_t hint = 0;
  for (const Vec3& vertex : block.surface.vertices) {
    const Vec3 point = rotation * vertex + other_from_body.translation;
    if (point.squaredNorm() > other.radius * other.radius) continue;
    const bool outside = std::any_of(
        other.planes.begin(), other.planes.end(),
        [&](const SupportPlane& plane) { return plane.normal.dot(point) > plane.support; });
    if (outside) continue;
    const TriangleTree::SignedClosest closest = other.tree->signed_closest_point(point, hint);
    hint = closest.triangle;
    if (closest.distance >= 0.0) continue;
    overlap.depth = std::max(overlap.depth, -closest.distance);
    overlap.push -= closest.distance * closest.outward;
  }
  overlap.push = other_pose.rotation * overlap.push;
  return overlap;
}

struct Pair {
  std::size_t a, b;
  Overlap overlap = {};  ///< `push` moves a away from b
};

}  // namespace

double separate_surfaces(std::span<const VirtualBlock> blocks, std::vector<Pose>& poses,
                         double allowed, unsigned threads) {
  std::vector<Obstacle> obstacles(blocks.size());
  parallel_for(blocks.size(), threads,
               [&](std::size_t i) { obstacles[i] = make_obstacle(blocks[i]); });
  double largest = 0.0;
  for (int round = 0; round < kMaxRounds; ++round) {
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < blocks.size(); ++a) {
      for (std::size_t b = a + 1; b < blocks.size(); ++b) {
        const double apart = (poses[a].translation - poses[b].translation).norm();
        if (apart < obstacles[a].radius + obstacles[b].radius) pairs.push_back({a, b});
      }
    }
    parallel_for(pairs.size(), threads, [&](std::size_t i) {
      Pair& pair = pairs[i];
      const auto& [a, b, unused] = pair;
      pair.overlap = find_overlap(blocks[a], poses[a], obstacles[b], poses[b]);
      const Overlap back = find_overlap(blocks[b], poses[b], obstacles[a], poses[a]);
      pair.overlap.depth = std::max(pair.overlap.depth, back.depth);
      pair.overlap.push -= back.push;
    });
    largest = 0.0;
    std::vector<Vec3> moves(blocks.size(), Vec3::Zero());
    for (const Pair& pair : pairs) {
      largest = std::max(largest, pair.overlap.depth);
      if (pair.overlap.depth <= 0.5 * allowed) continue;
      const Vec3 push = kRelaxation * pair.overlap.depth * pair.overlap.push.normalized();
      // The lighter block moves.
      const double share = blocks[pair.b].volume / (blocks[pair.a].volume + blocks[pair.b].volume);
      moves[pair.a] += share * push;
      moves[pair.b] -= (1.0 - share) * push;
    }
    if (largest <= allowed) break;
    for (std::size_t i = 0; i < blocks.size(); ++i) poses[i].translation += moves[i];
  }
  return largest;
}

}  // namespace clast
