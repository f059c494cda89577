#pragma once
/// Ways in which survey meshes are broken, done to a sound one at random places.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "tests/terrain/ground_samples.hpp"

namespace clast {

inline Vec3 compute_posterior_medians(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
}

/// The triangles that `wanted` chooses by their centroid, with vertices of their own.
template <class Wanted>
TriangleMesh part_of(const TriangleMesh& mesh, const Wanted& wanted) {
  TriangleMesh part;
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0xffffffffu);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!wanted(compute_posterior_medians(mesh, t))) continue;
    TriangleMesh::Triangle triangle = mesh.triangles[t];
    for (std::uint32_t& corner : triangle) {
      if (number[corner] == 0xffffffffu) {
        number[corner] = static_cast<std::uint32_t>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[corner]);
      }
      corner = number[corner];
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

/// Cuts along x = `at` and moves the right-hand part by up to `gap`.
inline TriangleMesh cracked(const TriangleMesh& mesh, double at, double gap, Random& random) {
  const TriangleMesh left = part_of(mesh, [&](const Vec3& p) { return p.x() < at; });
  TriangleMesh right = part_of(mesh, [&](const Vec3& p) { return p.x() >= at; });
  const Vec3 shift = gap * random.uniform(0.2, 1.0) * random.unit_vector();
  for (Vec3& v : right.vertices) v += shift;
  return merged(left, right);
}

/// Cuts along x = `at`, and gives the right-hand part vertices of its own along the cut, in the
/// middle of the sides and off them by up to `gap`.
inline TriangleMesh with_t_junctions(const TriangleMesh& mesh, double at, double gap,
                                     Random& random) {
  const TriangleMesh left = part_of(mesh, [&](const Vec3& p) { return p.x() < at; });
  TriangleMesh right = part_of(mesh, [&](const Vec3& p) { return p.x() >= at; });
  const std::size_t count = right.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    const TriangleMesh::Triangle corners = right.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = right.vertices[corners[k]], b = right.vertices[corners[(k + 1) % 3]];
      if (std::abs(a.x() - at) > 1e-9 || std::abs(b.x() - at) > 1e-9) continue;
      const auto middle = static_cast<std::uint32_t>(right.vertices.size());
      right.vertices.push_back((a + b) / 2.0 + gap * random.uniform() * random.unit_vector());
      right.triangles[t] = {corners[k], middle, corners[(k + 2) % 3]};
      right.triangles.push_back({middle, corners[(k + 1) % 3], corners[(k + 2) % 3]});
      break;
    }
  }
  return merged(left, right);
}

inline TriangleMesh flipped(TriangleMesh mesh, double share, Random& random) {
  for (TriangleMesh::Triangle& t : mesh.triangles) {
    if (random.uniform() < share) std::swap(t[0], t[1]);
  }
  return mesh;
}

/// Triangles divided at a point a tenth of a millimetre from one of their corners, none of them
/// at a cut.
inline TriangleMesh with_slivers(TriangleMesh mesh, int count, const std::vector<double>& cuts,
                                 Random& random) {
  for (int i = 0; i < count;) {
    const std::size_t t = random.uniform_index(mesh.triangles.size());
    if (std::any_of(cuts.begin(), cuts.end(), [&](double at) {
          return std::abs(compute_posterior_medians(mesh, t).x() - at) < 1.5;
        })) {
      continue;
    }
    ++i;
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 inwards = (compute_posterior_medians(mesh, t) - mesh.vertices[a]).normalized();
    const auto point = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(mesh.vertices[a] + 1e-4 * inwards);
    mesh.triangles[t] = {a, b, point};
    mesh.triangles.push_back({b, c, point});
    mesh.triangles.push_back({c, a, point});
  }
  return mesh;
}

/// Without the triangles within `radius` of some inner places, which lie apart.
inline TriangleMesh with_holes(const TriangleMesh& mesh, int count, double radius, Random& random) {
  const Bounds box = bounds(mesh);
  std::vector<Vec2> places;
  while (places.size() < static_cast<std::size_t>(count)) {
    const Vec2 place(random.uniform(box.low.x() + 3.0, box.high.x() - 3.0),
                     random.uniform(box.low.y() + 3.0, box.high.y() - 3.0));
    const bool apart = std::all_of(places.begin(), places.end(), [&](const Vec2& other) {
      return (other - place).norm() > 4.0 * radius + 1.0;
    });
    if (apart) places.push_back(place);
  }
  return part_of(mesh, [&](const Vec3& p) {
    return std::none_of(places.begin(), places.end(),
                        [&](const Vec2& place) { return (p.head<2>() - place).norm() < radius; });
  });
}

/// Single inner vertices moved up or down by 5 to 15 m, none of them at a cut.
inline TriangleMesh with_spikes(TriangleMesh mesh, int count, const std::vector<double>& cuts,
                                Random& random) {
  const Bounds box = bounds(mesh);
  for (int i = 0; i < count;) {
    Vec3& v = mesh.vertices[random.uniform_index(mesh.vertices.size())];
    const Vec2 plan = v.head<2>();
    if ((plan.array() < box.low.head<2>().array() + 3.0).any() ||
        (plan.array() > box.high.head<2>().array() - 3.0).any() ||
        std::any_of(cuts.begin(), cuts.end(),
                    [&](double at) { return std::abs(plan.x() - at) < 0.5; })) {
      continue;
    }
    ++i;
    v.z() += (random.uniform_index(2) == 0 ? 1.0 : -1.0) * random.uniform(5.0, 15.0);
  }
  return mesh;
}

/// Groups of `size` vertices that edges join, each moved up or down by 5 to 15 m, in `count` places
/// anywhere, on borders and cuts too.
inline TriangleMesh with_spike_groups(TriangleMesh mesh, int count, std::size_t size,
                                      Random& random) {
  for (int i = 0; i < count; ++i) {
    std::vector<std::uint32_t> group = {
        static_cast<std::uint32_t>(random.uniform_index(mesh.vertices.size()))};
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      const bool beside = std::find(t.begin(), t.end(), group[0]) != t.end();
      for (const std::uint32_t v : t) {
        if (beside && group.size() < size &&
            std::find(group.begin(), group.end(), v) == group.end()) {
          group.push_back(v);
        }
      }
    }
    for (const std::uint32_t v : group) {
      mesh.vertices[v].z() +=
          (random.uniform_index(2) == 0 ? 1.0 : -1.0) * random.uniform(5.0, 15.0);
    }
  }
  return mesh;
}

/// One of the vertices at x = `at`, moved up or down by 5 to 15 m; of one tile only at a cut.
inline TriangleMesh with_a_spike_at(TriangleMesh mesh, double at, Random& random) {
  std::vector<std::size_t> there;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (std::abs(mesh.vertices[v].x() - at) < 0.05) there.push_back(v);
  }
  mesh.vertices[there[random.uniform_index(there.size())]].z() +=
      (random.uniform_index(2) == 0 ? 1.0 : -1.0) * random.uniform(5.0, 15.0);
  return mesh;
}

/// Flaps of one to three triangles that stand on an edge between two triangles of the ground.
inline TriangleMesh with_fins(TriangleMesh mesh, int count, Random& random) {
  const std::size_t ground = mesh.triangles.size();
  for (int i = 0; i < count;) {
    const TriangleMesh::Triangle base = mesh.triangles[random.uniform_index(ground)];
    std::uint32_t a = base[0], b = base[1];
    const auto at_edge = std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                                       [&](const TriangleMesh::Triangle& t) {
                                         return std::find(t.begin(), t.end(), a) != t.end() &&
                                                std::find(t.begin(), t.end(), b) != t.end();
                                       });
    if (at_edge != 2) continue;
    ++i;
    for (std::size_t k = random.uniform_index(3) + 1; k > 0; --k) {
      const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2.0 +
                              Vec3(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.8));
      mesh.triangles.push_back({a, b, tip});
      a = tip;
    }
  }
  return mesh;
}

/// The part right of x = `at` a second time, `offset` higher.
inline TriangleMesh with_a_tile_twice(const TriangleMesh& mesh, double at, double offset) {
  TriangleMesh tile = part_of(mesh, [&](const Vec3& p) { return p.x() >= at; });
  for (Vec3& v : tile.vertices) v.z() += offset;
  return merged(mesh, tile);
}

}  // namespace clast
