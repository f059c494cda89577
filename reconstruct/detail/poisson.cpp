#include "reconstruct/detail/poisson.hpp"

// CGAL solves for the indicator with Eigen; the macro says that it may.
#define CGAL_EIGEN3_ENABLED

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/Random.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh_cell_base_3.h>
#include <CGAL/Surface_mesh_complex_2_in_triangulation_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_vertex_base_3.h>
#include <CGAL/make_surface_mesh.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <utility>
#include <vector>

#include "shapes/detail/cgal_mesh.hpp"

namespace clast::detail {

namespace {

/// A vertex or cell that knows when it was made. The mesher keeps sets of them; without a stamp
/// those are in order of their places in memory, and the surface depends on what the program has
/// done before.
template <class Base>
class Stamped : public Base {
 public:
  using Has_timestamp = CGAL::Tag_true;
  template <class Structure>
  struct Rebind_TDS {
    using Other = Stamped<typename Base::template Rebind_TDS<Structure>::Other>;
  };

  using Base::Base;
  Stamped() = default;
  Stamped(const Stamped& other) : Base(other) {}  // a copy is made anew
  Stamped& operator=(const Stamped& other) {
    Base::operator=(other);
    return *this;
  }
  std::size_t time_stamp() const { return stamp_; }
  void set_time_stamp(std::size_t stamp) { stamp_ = stamp; }

 private:
  std::size_t stamp_ = static_cast<std::size_t>(-1);  // none yet
};

using Traits = CGAL::Robust_circumcenter_traits_3<CgalKernel>;
using Vertex = Stamped<CGAL::Surface_mesh_vertex_base_3<Traits>>;
using Cell = Stamped<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
    Traits, CGAL::Surface_mesh_cell_base_3<Traits>>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Traits, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/// Angles in degrees, radii of the Delaunay balls and distances from the surface in edges.
constexpr double kAngle = 20.0, kRadius = 1.0, kDistance = 0.125;
/// The surface is looked for within so many radii of the points, its places are found to this share
/// of the distance allowed.
constexpr double kReach = 5.0, kFineness = 1e-3;

}  // namespace

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
  using Function = CGAL::Poisson_reconstruction_function<CgalKernel>;
  Function function(oriented.begin(), oriented.end(), CGAL::First_of_pair_property_map<Oriented>(),
                    CGAL::Second_of_pair_property_map<Oriented>());
  if (!function.compute_implicit_function()) return {};
  const double reach = kReach * std::sqrt(function.bounding_sphere().squared_radius());
  const CGAL::Implicit_surface_3<CgalKernel, Function> implicit(
      function, CgalKernel::Sphere_3(function.get_inner_point(), reach * reach),
      kFineness * kDistance * edge / reach);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(kAngle, kRadius * edge,
                                                                      kDistance * edge);
  Triangulation triangulation;
  CGAL::Surface_mesh_complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  CGAL::make_surface_mesh(complex, implicit, criteria, CGAL::Manifold_with_boundary_tag());
  if (triangulation.number_of_vertices() == 0) return {};
  CgalMesh surface;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, surface);
  TriangleMesh mesh = from_cgal(surface);
  for (Vec3& vertex : mesh.vertices) vertex += origin;
  return mesh;
}

}  // namespace clast::detail
