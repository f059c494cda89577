#include "tests/support/scan_damage.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

namespace {

using Triangle = TriangleMesh::Triangle;

Vec3 centre(const TriangleMesh& mesh, const Triangle& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

/// Unit, of the vertices, weighted by area.
std::vector<Vec3> outward_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) normals[v] += doubled_area_vector(mesh, t);
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

/// A point of the surface, every part of it as likely.
Vec3 surface_point(const TriangleMesh& mesh, Random& random) {
  return SurfaceSampler(mesh).draw(random).point;
}

TriangleMesh ball(const Vec3& place, double radius) {
  TriangleMesh mesh = geodesic_sphere(4);
  for (Vec3& v : mesh.vertices) v = place + radius * v;
  return mesh;
}

/// Vertices that no triangle uses are what a writer of scans does not write.
TriangleMesh without_loose_vertices(const TriangleMesh& mesh) {
  TriangleMesh kept;
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0xffffffffu);
  for (Triangle t : mesh.triangles) {
    for (std::uint32_t& v : t) {
      if (number[v] == 0xffffffffu) {
        number[v] = static_cast<std::uint32_t>(kept.vertices.size());
        kept.vertices.push_back(mesh.vertices[v]);
      }
      v = number[v];
    }
    kept.triangles.push_back(t);
  }
  return kept;
}

/// A point with `clearance` to the surface, inside or outside and not farther from the box than a
/// quarter of its diagonal.
Vec3 clear_point(const TriangleMesh& mesh, const TriangleTree& tree, bool inside, double clearance,
                 Random& random) {
  constexpr int kTrials = 10000;
  const Bounds box = bounds(mesh);
  const Vec3 border = Vec3::Constant(inside ? 0.0 : 0.25 * box.diagonal());
  const Vec3 low = box.low - border, sides = box.high - box.low + 2.0 * border;
  for (int i = 0; i < kTrials; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const Vec3 point = low + Vec3(x, y, z).cwiseProduct(sides);
    if ((inside ? -1.0 : 1.0) * tree.signed_distance(point) > clearance) return point;
  }
  throw InputError("no place for a ball: it is too large for this rock");
}

}  // namespace

TriangleMesh without_faces(TriangleMesh mesh, double share, Random& random) {
  std::erase_if(mesh.triangles, [&](const Triangle&) { return random.uniform() < share; });
  return without_loose_vertices(mesh);
}

TriangleMesh without_vertices(TriangleMesh mesh, double share, Random& random) {
  std::vector<char> lost(mesh.vertices.size());
  for (char& v : lost) v = random.uniform() < share;
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return lost[t[0]] || lost[t[1]] || lost[t[2]]; });
  return without_loose_vertices(mesh);
}

TriangleMesh without_clumps(TriangleMesh mesh, std::size_t count, double radius, Random& random) {
  std::vector<std::pair<Vec3, double>> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = surface_point(mesh, random);
    balls.emplace_back(place, radius * random.uniform(0.5, 1.0));
  }
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(balls.begin(), balls.end(), [&](const auto& b) {
      return (centre(mesh, t) - b.first).norm() < b.second;
    });
  });
  return without_loose_vertices(mesh);
}

TriangleMesh cut_off(const TriangleMesh& mesh, const Vec3& direction, double share) {
  const Quat turn = Quat::FromTwoVectors(-direction, Vec3::UnitZ());
  const TriangleMesh turned = transformed(mesh, {Vec3::Zero(), turn});
  const Bounds box = bounds(turned);
  const double level = box.low.z() + share * (box.high.z() - box.low.z());
  return transformed(above_level(turned, level), {Vec3::Zero(), turn.conjugate()});
}

TriangleMesh without_side(TriangleMesh mesh, const Vec3& direction, double angle) {
  const double limit = std::cos(angle);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return doubled_area_vector(mesh, t).normalized().dot(direction) > limit;
  });
  return without_loose_vertices(mesh);
}

TriangleMesh with_duplicates(TriangleMesh mesh, double share, Random& random) {
  const std::size_t sound = mesh.triangles.size();
  const auto count = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sound)));
  for (std::size_t i = 0; i < count; ++i) {
    Triangle again = mesh.triangles[random.uniform_index(sound)];
    if (i % 2 == 0) std::swap(again[0], again[1]);
    mesh.triangles.push_back(again);
  }
  return mesh;
}

TriangleMesh with_flipped_faces(TriangleMesh mesh, double share, Random& random) {
  for (Triangle& t : mesh.triangles) {
    if (random.uniform() < share) std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh as_soup(const TriangleMesh& mesh, double gap, Random& random) {
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) {
      const double shift = gap * random.uniform();
      soup.vertices.push_back(mesh.vertices[v] + shift * random.unit_vector());
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleMesh with_copy(const TriangleMesh& mesh, double factor, const Vec3& shift, double radius,
                       Random& random) {
  const Bounds box = bounds(mesh);
  const Vec3 middle = 0.5 * (box.low + box.high);
  TriangleMesh copy = mesh;
  if (std::isfinite(radius)) {
    const Vec3 place = surface_point(mesh, random);
    std::erase_if(copy.triangles,
                  [&](const Triangle& t) { return (centre(mesh, t) - place).norm() > radius; });
    copy = without_loose_vertices(copy);
  }
  for (Vec3& v : copy.vertices) v = middle + factor * (v - middle) + shift;
  return merged(mesh, copy);
}

TriangleMesh in_two_halves(const TriangleMesh& mesh, const Vec3& direction, double band,
                           const Vec3& shift) {
  const Bounds box = bounds(mesh);
  const Vec3 middle = 0.5 * (box.low + box.high);
  const auto half = [&](double side) {
    TriangleMesh part = mesh;
    std::erase_if(part.triangles, [&](const Triangle& t) {
      return side * direction.dot(centre(mesh, t) - middle) < -0.5 * band;
    });
    return without_loose_vertices(part);
  };
  TriangleMesh other = half(-1.0);
  for (Vec3& v : other.vertices) v += shift;
  return merged(half(1.0), other);
}

TriangleMesh with_islands(TriangleMesh mesh, std::size_t count, double radius, Random& random) {
  const TriangleMesh rock = mesh;
  const TriangleTree tree(rock);
  for (std::size_t i = 0; i < count; ++i) {
    const double size = radius * random.uniform(0.2, 1.0);
    TriangleMesh scrap = ball(clear_point(rock, tree, false, size, random), size);
    if (i % 2 == 0) scrap.triangles.resize(scrap.triangles.size() / 2);
    mesh = merged(std::move(mesh), without_loose_vertices(scrap));
  }
  return mesh;
}

TriangleMesh with_bubbles(TriangleMesh mesh, std::size_t count, double radius, Random& random) {
  const TriangleMesh rock = mesh;
  const TriangleTree tree(rock);
  for (std::size_t i = 0; i < count; ++i) {
    const double size = radius * random.uniform(0.5, 1.0);
    TriangleMesh shell = ball(clear_point(rock, tree, true, size, random), size);
    if (i % 2 == 0) {
      for (Triangle& t : shell.triangles) std::swap(t[0], t[1]);
    }
    mesh = merged(std::move(mesh), shell);
  }
  return mesh;
}

TriangleMesh with_crossing_balls(TriangleMesh mesh, std::size_t count, double radius,
                                 Random& random) {
  const TriangleMesh rock = mesh;
  for (std::size_t i = 0; i < count; ++i) {
    mesh = merged(std::move(mesh), ball(surface_point(rock, random), radius));
  }
  return mesh;
}

TriangleMesh with_spikes(TriangleMesh mesh, std::size_t count, double height, Random& random) {
  const std::vector<Vec3> outward = outward_normals(mesh);
  std::set<std::uint64_t> chosen;
  while (chosen.size() < count) chosen.insert(random.uniform_index(mesh.vertices.size()));
  for (const std::uint64_t v : chosen) {
    const double side = random.uniform() < 0.8 ? 1.0 : -1.0;
    mesh.vertices[v] += side * height * random.uniform(0.5, 1.0) * outward[v];
  }
  return mesh;
}

TriangleMesh jittered(TriangleMesh mesh, Jitter jitter, double amplitude, Random& random) {
  const std::vector<Vec3> outward = outward_normals(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double share = random.uniform();
    switch (jitter) {
      case Jitter::kAllWays:
        mesh.vertices[v] += amplitude * share * random.unit_vector();
        break;
      case Jitter::kAlongNormals:
        mesh.vertices[v] += amplitude * (2.0 * share - 1.0) * outward[v];
        break;
      case Jitter::kOutward:
        mesh.vertices[v] += amplitude * share * outward[v];
        break;
      case Jitter::kOneSidedNoise:
        if (share < 1.0 / 3.0) {
          mesh.vertices[v] += amplitude * std::abs(random.normal()) * outward[v];
        }
        break;
    }
  }
  return mesh;
}

}  // namespace clast
