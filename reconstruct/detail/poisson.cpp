#include "reconstruct/detail/poisson.hpp"

// CGAL solves for the indicator with Eigen; the macro says that it may.
#define CGAL_EIGEN3_ENABLED

#include <CGAL/Random.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include <utility>
#include <vector>

#include "shapes/detail/cgal_mesh.hpp"

namespace clast::detail {

TriangleMesh poisson_surface(std::span<const Vec3> points, std::span<const Vec3> normals,
                             double edge) {
  using Vector = CgalKernel::Vector_3;
  using Oriented = std::pair<CgalPoint, Vector>;
  if (points.empty()) return {};
  const Vec3 origin = points[0];
  std::vector<Oriented> oriented;
  oriented.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - origin;
    const Vec3& n = normals[i];
    oriented.emplace_back(CgalPoint(p.x(), p.y(), p.z()), Vector(n.x(), n.y(), n.z()));
  }
  CGAL::get_default_random() = CGAL::Random(1);  // CGAL's own is seeded by the clock
  // Angles of 20 degrees and more, radii up to the edge, within an eighth of it of the surface.
  CgalMesh surface;
  const bool found = CGAL::poisson_surface_reconstruction_delaunay(
      oriented.begin(), oriented.end(), CGAL::First_of_pair_property_map<Oriented>(),
      CGAL::Second_of_pair_property_map<Oriented>(), surface, edge, 20.0, 1.0, 0.125);
  if (!found) return {};
  TriangleMesh mesh = from_cgal(surface);
  for (Vec3& vertex : mesh.vertices) vertex += origin;
  return mesh;
}

}  // namespace clast::detail
