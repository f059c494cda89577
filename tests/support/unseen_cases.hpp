#pragma once
/// Closed bodies, real and made, and ways to hide a part of them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "mesh/sub_mesh.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/non_manifold_split.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/simplify.hpp"
#include "reconstruct/underside/underside.hpp"
#include "samples/rock_shapes.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {

struct NamedBody {
  std::string name;
  TriangleMesh mesh;
};

/// The hull of random points on an ellipsoid, with the triangles of a ball.
inline TriangleMesh rough_hull(const Vec3& half_axes, std::uint64_t corners, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (std::uint64_t i = 0; i < corners; ++i) {
    points.push_back(random.unit_vector().cwiseProduct(half_axes));
  }
  const TriangleMesh hull = convex_hull(points);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : hull.vertices) middle += p / static_cast<double>(hull.vertices.size());
  TriangleMesh mesh = geodesic_sphere(16);
  for (Vec3& vertex : mesh.vertices) {
    const Vec3 way = vertex.cwiseProduct(half_axes).normalized();
    double reach = 1e300;
    for (const auto& [a, b, c] : hull.triangles) {
      const Vec3 &p = hull.vertices[a], &q = hull.vertices[b], &r = hull.vertices[c];
      const Vec3 normal = (q - p).cross(r - p);
      if (normal.dot(way) > 0.0) reach = std::min(reach, normal.dot(p - middle) / normal.dot(way));
    }
    vertex = middle + reach * way;
  }
  return mesh;
}

/// Rocks from platy to long: waves with deep hollows, sharp hulls, worn facets, joint blocks, some
/// of them notched.
inline std::vector<NamedBody> made_bodies(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<NamedBody> bodies;
  for (int i = 0; i < count; ++i) {
    Vec3 half(0.5, 0.5 * random.uniform(0.4, 1.0), 0.0);
    half.z() = half.y() * random.uniform(0.35, 1.0);
    const std::uint64_t own = random.next_bits();
    if (i % 4 == 0) {
      bodies.push_back({"waves", rock_mesh(14, half, own, random.uniform(0.03, 0.25))});
    } else if (i % 4 == 1) {
      bodies.push_back({"hull", rough_hull(half, 10 + random.uniform_index(30), own)});
    } else {
      RockRecipe recipe;
      recipe.lengths = 2.0 * half;
      recipe.joint_faces = i % 4 == 3 ? 6 : 0;
      recipe.facets = 12 + static_cast<int>(random.uniform_index(24));
      recipe.sharpness = random.uniform(10.0, 40.0);
      recipe.notch = random.uniform_index(4) == 0 ? random.uniform(0.05, 0.35) : 0.0;
      recipe.roughness = random.uniform(0.0, 0.03);
      recipe.frequency = 14;
      recipe.seed = own;
      bodies.push_back({i % 4 == 3 ? "joints" : "facets", rock(recipe)});
    }
  }
  return bodies;
}

/// Every closed mesh of the test data as a block of about a metre, simplified to `vertices` where
/// it has more than twice as many.
inline std::vector<NamedBody> real_bodies(std::size_t vertices) {
  std::vector<NamedBody> bodies;
  for (const char* file :
       {"meshes/chrono_curiosity_rock1.obj", "meshes/chrono_offroad_rock4.obj",
        "meshes/eesd_S02.stl", "meshes/eesd_stone01.stl", "meshes/eesd_stone14.stl",
        "meshes/eesd_stone15.stl", "meshes/eesd_stone18.stl", "meshes/eesd_test_stone.stl",
        "meshes/eros007790.tab", "meshes/ibois_stone_0.ply", "meshes/rockable_rock.stl",
        "meshes/ryugu_test.obj", "authume/blocks/SP1A.stl", "authume/blocks/SP2A.stl",
        "authume/blocks/SP2B.stl", "authume/blocks/SP3A.stl"}) {
    TriangleMesh mesh = read_scan(test_data(file)).mesh;
    if (mesh.vertices.size() > 2 * vertices) {
      mesh = simplify_mesh(mesh, {.target_vertices = vertices});
    }
    const double size = std::sqrt(surface_area(mesh)) / 1.5;
    bodies.push_back({std::filesystem::path(file).filename().string(), scaled(mesh, 1.0 / size)});
  }
  return bodies;
}

/// A body in some pose, and what was seen of it.
struct UnseenCase {
  std::string kind;
  TriangleMesh whole, open;
  std::optional<Plane> ground;
  double missing = 0.0;  ///< share of the whole area
};

/// Ways to hide a part.
inline const std::vector<std::string>& hiding_kinds() {
  static const std::vector<std::string> kKinds = {"plane",   "side",     "patch",
                                                  "patches", "overhang", "buried"};
  return kKinds;
}

/// Hides a part of `body` in a random pose:
/// - plane: what is below 5 to 60 % of the height, with an even rim and no ground;
/// - side: what faces one way in that half; patch: a ball's worth of triangles; patches: 2 to 4;
/// - overhang: as side, with the ground known, up to 4 % of the height in it;
/// - buried: what is below a known ground, 5 to 22 % of the height.
/// None where nothing is left in one piece.
inline std::optional<UnseenCase> hidden(const TriangleMesh& body, const std::string& kind,
                                        Random& random) {
  UnseenCase found{.kind = kind, .whole = {}, .open = {}, .ground = {}};
  found.whole = transformed(body, Pose{Vec3::Zero(), random.rotation()});
  const TriangleMesh& mesh = found.whole;
  const Bounds box = bounds(mesh);
  const double height = box.high.z() - box.low.z(), size = std::sqrt(surface_area(mesh));
  const auto level = [&](double share) { return box.low.z() + share * height; };
  const auto middle = [&](const TriangleMesh::Triangle& t) -> Vec3 {
    return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
  };
  if (kind == "plane" || kind == "buried") {
    const double cut =
        level(kind == "plane" ? random.uniform(0.05, 0.6) : random.uniform(0.05, 0.22));
    found.open = above_level(mesh, cut);
    if (kind == "buried") found.ground = Plane{Vec3::UnitZ(), cut};
    if (reconstruct_detail::connected_components(found.open).size() != 1) return std::nullopt;
  } else {
    std::vector<bool> keep(mesh.triangles.size(), true);
    double lowest = -1e300;
    if (kind == "overhang") {
      lowest = level(random.uniform(0.0, 0.04));
      found.ground = Plane{Vec3::UnitZ(), lowest};
    }
    const bool balls = kind == "patch" || kind == "patches";
    const std::uint64_t count = kind == "patch"     ? 1
                                : kind == "patches" ? 2 + random.uniform_index(3)
                                                    : 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const Vec3 at = mesh.vertices[random.uniform_index(mesh.vertices.size())];
      const double radius = size * random.uniform(0.05, count == 1 ? 0.35 : 0.2);
      for (std::size_t t = 0; t < keep.size(); ++t) {
        if ((middle(mesh.triangles[t]) - at).norm() < radius) keep[t] = false;
      }
    }
    const double steepest = random.uniform(0.2, 0.95);
    for (std::size_t t = 0; !balls && t < keep.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
      const double z = middle(mesh.triangles[t]).z();
      const bool faces_down = (q - p).cross(r - p).normalized().z() < -steepest;
      keep[t] = z > lowest && !(faces_down && z < level(0.5));
    }
    if (std::find(keep.begin(), keep.end(), false) == keep.end()) return std::nullopt;
    found.open =
        reconstruct_detail::connected_components(extract_triangles(mesh, keep)).front().mesh;
    reconstruct_detail::split_non_manifold_vertices(found.open);
  }
  found.missing = 1.0 - surface_area(found.open) / surface_area(mesh);
  return found;
}

}  // namespace clast
