#include "tests/support/damage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {

namespace {

using Triangle = TriangleMesh::Triangle;

class Vandal {
 public:
  Vandal(const TriangleMesh& rock, const Damage& damage, std::uint64_t seed)
      : rock_(rock), damage_(damage), random_(seed), diagonal_(bounds(rock).diagonal()) {
    box_ = bounds(rock);
    middle_ = 0.5 * (box_.low + box_.high);
  }

  DamagedRock run() {
    DamagedRock result;
    TriangleMesh mesh = rock_;
    raise_spikes(mesh);
    const TriangleMesh sheets = doubled_patches(mesh);
    cut_holes(mesh);
    result.lost_share = 1.0 - surface_area(mesh) / surface_area(rock_);
    result.largest_hole = widest_hole(mesh);
    add_fins(mesh);
    mesh = merged(std::move(mesh), sheets);
    for (std::size_t i = 0; i < damage_.islands; ++i) mesh = merged(std::move(mesh), island(i));
    for (std::size_t i = 0; i < damage_.bubbles; ++i) mesh = merged(std::move(mesh), bubble());
    flip_and_double(mesh);
    result.mesh = soup_of(mesh);
    return result;
  }

 private:
  const Vec3& random_vertex() {
    return rock_.vertices[random_.uniform_index(rock_.vertices.size())];
  }

  static Vec3 centre(const TriangleMesh& mesh, const Triangle& t) {
    return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
  }

  static std::vector<Vec3> normals(const TriangleMesh& mesh) {
    std::vector<Vec3> result(mesh.vertices.size(), Vec3::Zero());
    for (const Triangle& t : mesh.triangles) {
      const Vec3 doubled = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                               .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
      for (const std::uint32_t v : t) result[v] += doubled;
    }
    for (Vec3& n : result) n.normalize();
    return result;
  }

  void raise_spikes(TriangleMesh& mesh) {
    const std::vector<Vec3> outward = normals(mesh);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (random_.uniform() >= damage_.spikes) continue;
      const double height = damage_.spike_height * diagonal_ * random_.uniform(0.5, 1.0);
      mesh.vertices[v] += (random_.uniform() < 0.8 ? height : -height) * outward[v];
    }
  }

  TriangleMesh doubled_patches(const TriangleMesh& mesh) {
    const std::vector<Vec3> outward = normals(rock_);
    TriangleMesh sheets;
    for (std::size_t i = 0; i < damage_.sheets; ++i) {
      const Vec3 place = random_vertex();
      const double radius = damage_.sheet_radius * diagonal_ * random_.uniform(0.4, 1.0);
      const double gap = damage_.sheet_gap * diagonal_ * random_.uniform(0.2, 1.0);
      TriangleMesh sheet = mesh;
      std::erase_if(sheet.triangles,
                    [&](const Triangle& t) { return (centre(rock_, t) - place).norm() > radius; });
      for (std::size_t v = 0; v < sheet.vertices.size(); ++v) sheet.vertices[v] += gap * outward[v];
      sheets = merged(std::move(sheets), sheet);
    }
    return sheets;
  }

  void cut_holes(TriangleMesh& mesh) {
    const double ground = box_.low.z() + damage_.ground_height * (box_.high.z() - box_.low.z());
    std::vector<std::pair<Vec3, double>> balls;
    for (std::size_t i = 0; i < damage_.holes; ++i) {
      const double radius = damage_.hole_radius * diagonal_ * (i == 0 ? 1.0 : random_.uniform());
      balls.emplace_back(random_vertex(), radius);
    }
    std::vector<Triangle> kept;
    for (const Triangle& t : mesh.triangles) {
      // By the sound rock, so that a spike doesn't save its triangles.
      const bool low = std::all_of(t.begin(), t.end(),
                                   [&](std::uint32_t v) { return rock_.vertices[v].z() < ground; });
      const bool in_hole = std::any_of(balls.begin(), balls.end(), [&](const auto& ball) {
        return (centre(rock_, t) - ball.first).norm() < ball.second;
      });
      if (!low && !in_hole) kept.push_back(t);
    }
    mesh.triangles = std::move(kept);
  }

  static double widest_hole(const TriangleMesh& mesh) {
    double widest = 0.0;
    for (const auto& loop : boundary_loops(mesh)) {
      Vec3 middle = Vec3::Zero();
      for (const std::uint32_t v : loop) middle += mesh.vertices[v] / double(loop.size());
      for (const std::uint32_t v : loop) {
        widest = std::max(widest, (mesh.vertices[v] - middle).norm());
      }
    }
    return widest;
  }

  void add_fins(TriangleMesh& mesh) {
    const std::size_t sound = mesh.triangles.size();
    for (std::size_t i = 0; i < damage_.fins; ++i) {
      const Triangle t = mesh.triangles[random_.uniform_index(sound)];
      const double length = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).norm();
      mesh.vertices.push_back(centre(mesh, t) +
                              length * random_.uniform(0.5, 2.0) * random_.unit_vector());
      mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
    }
  }

  TriangleMesh island(std::size_t number) {
    TriangleMesh scrap = geodesic_sphere(3);
    if (number % 2 == 0) scrap.triangles.resize(scrap.triangles.size() / 2);
    const Vec3 place = middle_ + random_.uniform(0.6, 0.9) * diagonal_ * random_.unit_vector();
    const double size = diagonal_ * random_.uniform(0.003, 0.02);
    for (Vec3& v : scrap.vertices) v = place + size * v;
    return scrap;
  }

  TriangleMesh bubble() {
    TriangleMesh shell = geodesic_sphere(4);
    const Vec3 place = middle_ + 0.05 * diagonal_ * random_.unit_vector();
    const double size = diagonal_ * random_.uniform(0.005, 0.015);
    for (Vec3& v : shell.vertices) v = place + size * v;
    for (Triangle& t : shell.triangles) std::swap(t[0], t[1]);
    return shell;
  }

  void flip_and_double(TriangleMesh& mesh) {
    for (Triangle& t : mesh.triangles) {
      if (random_.uniform() < damage_.flipped) std::swap(t[1], t[2]);
    }
    const std::size_t sound = mesh.triangles.size();
    for (std::size_t i = 0; i < damage_.duplicates; ++i) {
      Triangle again = mesh.triangles[random_.uniform_index(sound)];
      if (i % 2 == 0) std::swap(again[0], again[1]);
      mesh.triangles.push_back(again);
    }
  }

  TriangleMesh soup_of(const TriangleMesh& mesh) {
    if (damage_.jitter == 0.0) return mesh;
    TriangleMesh soup;
    for (const Triangle& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(soup.vertices.size());
      for (const std::uint32_t v : t) {
        const double shift = damage_.jitter * diagonal_ * random_.uniform();
        soup.vertices.push_back(mesh.vertices[v] + shift * random_.unit_vector());
      }
      soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
  }

  const TriangleMesh& rock_;
  const Damage& damage_;
  Random random_;
  double diagonal_;
  Bounds box_;
  Vec3 middle_;
};

}  // namespace

Damage Damage::of_intensity(double factor) {
  const auto times = [&](std::size_t count) {
    return static_cast<std::size_t>(std::lround(factor * static_cast<double>(count)));
  };
  Damage d;
  d.ground_height *= factor;
  d.holes = times(d.holes);
  d.flipped *= factor;
  d.duplicates = times(d.duplicates);
  d.fins = times(d.fins);
  d.spikes *= factor;
  d.sheets = times(d.sheets);
  d.sheet_gap *= factor;
  d.islands = times(d.islands);
  d.bubbles = times(d.bubbles);
  return d;
}

DamagedRock damaged(const TriangleMesh& rock, const Damage& damage, std::uint64_t seed) {
  return Vandal(rock, damage, seed).run();
}

}  // namespace clast
