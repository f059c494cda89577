#include "tests/app/reliability/odd_cases.hpp"

#include <limits>
#include <utility>

#include "tests/app/reliability/right_answer.hpp"
#include "tests/support/cloud_sample.hpp"
#include "tests/support/field_scene.hpp"
#include "tests/support/odd_bodies.hpp"

namespace clast::reliability {

namespace {

/// A scan of something else than one rock: right only where it is said what it is.
DamagedScan of_odd(TriangleMesh scanned, const TriangleMesh& closed, const std::string& said,
                   Random& random) {
  const Pose turn{Vec3::Zero(), random.rotation()};
  return {transformed(std::move(scanned), turn), {{truth_of(closed), {}, {said}}}};
}

/// Moved along x until it is within `gap` of the other.
TriangleMesh moved_to_touch(TriangleMesh mesh, const TriangleMesh& other, double gap) {
  const TriangleTree tree(other);
  for (int step = 0; step < 200; ++step) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : mesh.vertices) {
      nearest = std::min(nearest, tree.closest_point(vertex).squared_distance);
    }
    nearest = std::sqrt(nearest);
    if (nearest < gap) break;
    for (Vec3& vertex : mesh.vertices) vertex.x() -= nearest;
  }
  return mesh;
}

/// @param size  of the neighbour, against the block
DamagedScan cloud_with_neighbour(const Body& body, double size, Random& random) {
  const std::uint64_t seed = random.next_bits();
  const FieldGround ground(random.uniform(0.0, 0.1), 0.003, 6, 1.5, seed);
  const TriangleMesh standing = buried_at(body.mesh, 0.0, 0.0, 0.05, ground);
  const Pose turn{Vec3::Zero(), random.rotation()};
  TriangleMesh neighbour =
      buried_at(transformed(scaled(body.mesh, size), turn), 1.3, 0.0, 0.05, ground);
  neighbour = moved_to_touch(std::move(neighbour), standing, 0.005);
  const FieldCounts counts{.per_block = 8000, .ground = 16000, .noise = 0.001, .half = 2.0};
  TriangleMesh cloud;
  cloud.vertices = field_scene({standing, neighbour}, ground, counts, seed + 1).points;
  return of(body, std::move(cloud), cloud_tolerance(8000, counts.noise));
}

/// @param missing  height above the ground, against L, within which nothing was scanned
DamagedScan cloud_without_base(const Body& body, double missing, Random& random) {
  const std::uint64_t seed = random.next_bits();
  const FieldGround ground(random.uniform(0.0, 0.1), 0.003, 0, 1.5, seed);
  const TriangleMesh standing = buried_at(body.mesh, 0.0, 0.0, random.uniform(0.3, 0.5), ground);
  const FieldCounts counts{.per_block = 8000, .ground = 16000, .noise = 0.001, .half = 1.5};
  const FieldScene scene = field_scene({standing}, ground, counts, seed + 1);
  TriangleMesh cloud;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Vec3& p = scene.points[i];
    if (scene.owner[i] < 0 || p.z() > ground.at(p.x(), p.y()) + missing) {
      cloud.vertices.push_back(p);
    }
  }
  return of(body, std::move(cloud), cloud_tolerance(8000, counts.noise));
}

/// @param shift  of one half against the other, against L
DamagedScan cloud_in_strips(const Body& body, double shift, Random& random) {
  const Vec3 across = random.unit_vector(), by = shift * random.unit_vector();
  TriangleMesh cloud;
  for (const Vec3& p : sampled_cloud(body.mesh, {.points = 12000, .noise = 0.001}, random)) {
    const double side = across.dot(p);
    if (side > -0.1) cloud.vertices.push_back(p);
    if (side < 0.1) cloud.vertices.push_back(p + by);
  }
  TriangleMesh moved = body.mesh;
  for (Vec3& v : moved.vertices) {
    if (across.dot(v) < 0.0) v += by;
  }
  return of(body, std::move(cloud), at_least_usual(effect(body.truth, truth_of(moved)), 2.0));
}

}  // namespace

std::vector<Kind> odd_kinds() {
  constexpr std::size_t kOnce = 1000;
  return {
      {"a neighbour that touches",
       "% of its size",
       {35.0, 60.0, 90.0},
       [](const Body& body, double amount, Random& random) {
         return cloud_with_neighbour(body, kPercent * amount, random);
       },
       3},
      {"base not scanned",
       "% of L above the ground",
       {0.0, 4.0, 10.0},
       [](const Body& body, double amount, Random& random) {
         return cloud_without_base(body, kPercent * amount, random);
       },
       3},
      {"strips that do not fit",
       "% of L between them",
       {0.5, 1.5, 3.0},
       [](const Body& body, double amount, Random& random) {
         return cloud_in_strips(body, kPercent * amount, random);
       },
       3},
      {"wall of a tunnel not seen",
       "degrees of the wall",
       {80.0, 100.0, 120.0, 150.0},
       [](const Body&, double amount, Random& random) {
         const double thick = random.uniform(0.1, 0.2);
         return of_odd(torus_without_inner_wall(0.3, thick, 0.5 * amount),
                       torus_without_inner_wall(0.3, thick, 0.0), "tunnel", random);
       },
       kOnce},
      {"a shell",
       "% of the radius thick",
       {1.0, 3.0, 6.0},
       [](const Body&, double amount, Random& random) {
         const TriangleMesh shell = cup(random.uniform(-0.9, 0.2), kPercent * amount);
         return of_odd(shell, shell, "shell", random);
       },
       kOnce},
      {"closed with its ground",
       "% of the side high",
       {1.0, 4.0, 12.0},
       [](const Body&, double amount, Random& random) {
         const TriangleMesh block = slab(3.0, 3.0 * kPercent * amount, random.uniform(0.3, 0.8),
                                         0.004, random.next_bits());
         return of_odd(block, block, "ground", random);
       },
       kOnce},
      {"bodies that a bridge joins",
       "% of the radius wide",
       {8.0, 20.0, 40.0},
       [](const Body&, double amount, Random& random) {
         const double second = random.uniform(0.5, 1.0);
         const TriangleMesh both =
             two_balls(second, (1.0 + second) * random.uniform(0.85, 1.1), kPercent * amount);
         return of_odd(both, both, "two bodies", random);
       },
       kOnce},
  };
}

}  // namespace clast::reliability
