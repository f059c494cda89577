#include "samples/dirty_scans.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "samples/rock_shapes.hpp"

namespace clast {
namespace {

/// Keeps the triangles that `keep` says, and the vertices they use.
template <class Keep>
TriangleMesh kept(const TriangleMesh& mesh, const Keep& keep) {
  TriangleMesh result;
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0xffffffffu);
  for (TriangleMesh::Triangle triangle : mesh.triangles) {
    if (!keep(triangle)) continue;
    for (std::uint32_t& corner : triangle) {
      if (number[corner] == 0xffffffffu) {
        number[corner] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[corner]);
      }
      corner = number[corner];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

/// Part above the ground: triangles with all corners above the lowest `share` of the height.
TriangleMesh above_ground(const TriangleMesh& mesh, double share) {
  const Bounds box = bounds(mesh);
  const double level = box.low.z() + share * (box.high.z() - box.low.z());
  return kept(mesh, [&](const TriangleMesh::Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t c) { return mesh.vertices[c].z() >= level; });
  });
}

/// Rings of ground around the open bottom, each wider than the last.
TriangleMesh with_ground_patch(TriangleMesh mesh, Random& random) {
  std::vector<std::uint32_t> ring = boundary_loops(mesh).front();
  Vec3 centre = Vec3::Zero();
  for (const std::uint32_t v : ring) centre += mesh.vertices[v] / static_cast<double>(ring.size());
  for (int k = 0; k < 6; ++k) {
    std::vector<std::uint32_t> wider;
    for (const std::uint32_t v : ring) {
      Vec3 point = centre + 1.14 * (mesh.vertices[v] - centre);
      point.z() = centre.z() + 0.3 * (mesh.vertices[v].z() - centre.z()) + 0.006 * random.normal();
      wider.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(point);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      mesh.triangles.push_back({ring[i], ring[j], wider[j]});
      mesh.triangles.push_back({ring[i], wider[j], wider[i]});
    }
    ring = wider;
  }
  return mesh;
}

/// A floating crumb: one small open patch, as sparse matching leaves in the air.
void add_crumb(TriangleMesh& mesh, const Vec3& place, Random& random) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 5; ++i) mesh.vertices.push_back(place + 0.02 * random.unit_vector());
  for (std::uint32_t i = 1; i + 1 < 5; ++i) {
    mesh.triangles.push_back({first, first + i, first + i + 1});
  }
}

TriangleMesh with_spikes(TriangleMesh mesh, Random& random) {
  const Bounds box = bounds(mesh);
  const Vec3 centre = (box.low + box.high) / 2.0;
  for (int i = 0; i < 6; ++i) {
    Vec3& vertex = mesh.vertices[random.uniform_index(mesh.vertices.size())];
    vertex += random.uniform(0.2, 0.45) * (vertex - centre);
  }
  return mesh;
}

TriangleMesh with_hole(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const Vec3 place(box.high.x(), (box.low.y() + box.high.y()) / 2.0,
                   (box.low.z() + box.high.z()) / 2.0);
  return kept(mesh, [&](const TriangleMesh::Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t c) {
      return (mesh.vertices[c] - place).norm() > 0.25 * box.diagonal();
    });
  });
}

}  // namespace

std::vector<NamedMesh> dirty_scans() {
  Random random(200);
  TriangleMesh patched = with_ground_patch(
      above_ground(rock({.lengths = {0.9, 0.75, 0.6}, .seed = 201}), 0.25), random);
  const Bounds box = bounds(patched);
  for (int i = 0; i < 4; ++i) {
    add_crumb(patched, box.high + Vec3(0.1 * i, -0.3, random.uniform(0.0, 0.2)), random);
  }
  return {{"D01_ground_patch", std::move(patched)},
          {"D02_open_bottom", above_ground(rock({.lengths = {1.1, 0.8, 0.5}, .seed = 202}), 0.12)},
          {"D03_spikes_and_hole",
           with_hole(with_spikes(rock({.lengths = {0.7, 0.6, 0.5}, .seed = 203}), random))}};
}

}  // namespace clast
