#include "report/blocks/particle_shape.hpp"

#include <algorithm>
#include <cmath>

#include "shapes/sphero_polyhedron.hpp"

namespace clast::report_detail {
namespace {

/// Triangles of all spheres together, before hidden ones are left out.
constexpr double kAllSphereTriangles = 20'000.0;
constexpr int kFewestSegments = 3, kMostSegments = 12;  ///< of a quarter turn

TriangleMesh unit_sphere(std::size_t spheres) {
  // n segments of a quarter turn are 8 n^2 triangles.
  const double segments = std::sqrt(kAllSphereTriangles / (8.0 * static_cast<double>(spheres)));
  SpheroPolyhedron point;
  point.vertices = {Vec3::Zero()};
  point.radius = 1.0;
  return rounded_surface_mesh(
      point, std::clamp(static_cast<int>(segments), kFewestSegments, kMostSegments));
}

/// True if all corners of a triangle are inside one other ball, and thus all of the triangle.
bool is_hidden(const std::array<Vec3, 3>& corners, std::size_t own,
               const std::vector<Ball>& balls) {
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (b == own) continue;
    if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
          return (corner - balls[b].centre).squaredNorm() < balls[b].radius * balls[b].radius;
        })) {
      return true;
    }
  }
  return false;
}

void append_sphere(ParticleSurface& surface, const TriangleMesh& sphere, std::size_t own,
                   const std::vector<Ball>& balls) {
  const Ball& ball = balls[own];
  std::vector<std::uint32_t> new_index(sphere.vertices.size(), kNoIndex);
  const auto place = [&](std::uint32_t v) {
    return Vec3(ball.centre + ball.radius * sphere.vertices[v]);
  };
  for (const TriangleMesh::Triangle& t : sphere.triangles) {
    if (is_hidden({place(t[0]), place(t[1]), place(t[2])}, own, balls)) continue;
    TriangleMesh::Triangle kept;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& index = new_index[t[k]];
      if (index == kNoIndex) {
        index = static_cast<std::uint32_t>(surface.mesh.vertices.size());
        surface.mesh.vertices.push_back(place(t[k]));
      }
      kept[k] = index;
    }
    surface.mesh.triangles.push_back(kept);
    surface.components.push_back(static_cast<std::uint16_t>(own));
  }
}

void append_part(ParticleSurface& surface, const TriangleMesh& part, std::size_t own) {
  const auto first = static_cast<std::uint32_t>(surface.mesh.vertices.size());
  surface.mesh.vertices.insert(surface.mesh.vertices.end(), part.vertices.begin(),
                               part.vertices.end());
  for (const TriangleMesh::Triangle& t : part.triangles) {
    surface.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    surface.components.push_back(static_cast<std::uint16_t>(own));
  }
}

}  // namespace

ParticleSurface make_particle_surface(const Particle& particle) {
  ParticleSurface surface;
  if (!particle.balls.empty()) {
    const TriangleMesh sphere = unit_sphere(particle.balls.size());
    for (std::size_t b = 0; b < particle.balls.size(); ++b) {
      append_sphere(surface, sphere, b, particle.balls);
    }
  }
  for (std::size_t p = 0; p < particle.parts.size(); ++p) {
    append_part(surface, particle.parts[p], p);
  }
  return surface;
}

}  // namespace clast::report_detail
