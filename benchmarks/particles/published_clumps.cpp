#include "benchmarks/particles/published_clumps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "mesh/surface_samples.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

namespace {

constexpr int kDivisions = 100;  // of the length of the body
constexpr std::size_t kSurfacePoints = 8000;

struct Node {
  Vec3 point;
  double depth;  ///< distance from the surface, m
};

/// Points of a grid inside the body, in the frame of a box.
std::vector<Node> inner_nodes(const ParticleBody& body, const TriangleTree& tree,
                              const Mat3& body_from_box) {
  TriangleMesh turned = body.mesh;
  for (Vec3& vertex : turned.vertices) vertex = body_from_box.transpose() * vertex;
  const Bounds box = bounds(turned);
  const double step = body.length / kDivisions;
  std::vector<Node> nodes;
  std::uint32_t hint = 0;
  for (double x = box.low.x() + 0.5 * step; x < box.high.x(); x += step) {
    for (double y = box.low.y() + 0.5 * step; y < box.high.y(); y += step) {
      for (double z = box.low.z() + 0.5 * step; z < box.high.z(); z += step) {
        const Vec3 point = body_from_box * Vec3(x, y, z);
        const TriangleTree::SignedClosest found = tree.signed_closest_point(point, hint);
        hint = found.triangle;
        if (found.distance < 0.0) nodes.push_back({point, -found.distance});
      }
    }
  }
  return nodes;
}

/// Largest ball inside the body that touches it at a point with outward normal `normal`.
Ball tangent_ball(const TriangleTree& tree, const Vec3& contact, const Vec3& normal,
                  double largest) {
  double low = 0.0, high = largest;
  for (int i = 0; i < 40; ++i) {
    const double radius = 0.5 * (low + high);
    const double free = std::sqrt(tree.closest_point(contact - radius * normal).squared_distance);
    (free >= radius * (1.0 - 1e-4) ? low : high) = radius;
  }
  return {contact - low * normal, low};
}

}  // namespace

std::vector<Ball> favier_clump(const ParticleBody& body, const TriangleTree& tree,
                               std::size_t count) {
  const OrientedBox box = smallest_box(body.mesh.vertices);
  const std::vector<Node> nodes = inner_nodes(body, tree, box.axes);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& vertex : body.mesh.vertices) {
    const double place = box.axes.col(0).dot(vertex);
    low = std::min(low, place), high = std::max(high, place);
  }
  std::vector<Ball> balls(count);
  for (const Node& node : nodes) {
    const double place = (box.axes.col(0).dot(node.point) - low) / (high - low);
    const auto station = std::min(count - 1, static_cast<std::size_t>(place * count));
    if (node.depth > balls[station].radius) balls[station] = {node.point, node.depth};
  }
  std::erase_if(balls, [](const Ball& ball) { return ball.radius == 0.0; });
  return balls;
}

std::vector<Ball> ferellec_mcdowell_clump(const ParticleBody& body, const TriangleTree& tree,
                                          double smallest_radius, double covering,
                                          std::uint64_t seed) {
  std::vector<Vec3> open = sample_surface(body.mesh, kSurfacePoints);
  Random random(seed);
  std::vector<Ball> balls;
  while (!open.empty()) {
    const std::size_t chosen = random.uniform_index(open.size());
    const Vec3 contact = open[chosen];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(chosen));
    const Vec3 normal = tree.face_normal(tree.closest_point(contact).triangle);
    const Ball ball = tangent_ball(tree, contact, normal, 0.5 * body.length);
    if (ball.radius < smallest_radius) continue;
    balls.push_back(ball);
    std::erase_if(open, [&](const Vec3& point) {
      return std::abs((point - ball.centre).norm() - ball.radius) <= covering;
    });
  }
  return balls;
}

std::vector<Ball> ferellec_mcdowell_clump(const ParticleBody& body, const TriangleTree& tree,
                                          double smallest_radius, std::size_t count,
                                          std::uint64_t seed) {
  double low = 0.0, high = 0.5 * body.length;
  std::vector<Ball> best;
  for (int i = 0; i < 12; ++i) {
    const double covering = 0.5 * (low + high);
    std::vector<Ball> balls = ferellec_mcdowell_clump(body, tree, smallest_radius, covering, seed);
    const bool fits = balls.size() <= count;
    (fits ? high : low) = covering;
    if (fits && balls.size() >= best.size()) best = std::move(balls);
  }
  return best;
}

std::vector<Ball> euclidean_distance_clump(const ParticleBody& body, const TriangleTree& tree,
                                           std::size_t count, double overlap) {
  std::vector<Node> nodes = inner_nodes(body, tree, Mat3::Identity());
  std::vector<Ball> balls;
  while (balls.size() < count) {
    const auto deepest = std::max_element(
        nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.depth < b.depth; });
    if (deepest == nodes.end() || deepest->depth <= 0.0) break;
    const Ball ball = {deepest->point, deepest->depth};
    balls.push_back(ball);
    for (Node& node : nodes) {
      const double gap = (node.point - ball.centre).norm() - (1.0 - overlap) * ball.radius;
      node.depth = std::min(node.depth, gap);
    }
  }
  return balls;
}

}  // namespace clast
