#include "reconstruct/cloud/detail/poisson.hpp"

// CGAL solves for the indicator with Eigen; the macro says that it may.
#define CGAL_EIGEN3_ENABLED

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/Random.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "mesh/detail/cgal_mesh.hpp"

/// Order in which CGAL refines cells of equal quality: by their corners. Its default is by address,
/// which differs from run to run (https://github.com/CGAL/cgal/issues/6240).
template <>
struct std::less<CGAL::Poisson_reconstruction_function<
    clast::mesh_detail::CgalKernel>::Triangulation::Cell_handle> {
  template <class DelaunayCell>
  bool operator()(const DelaunayCell& a, const DelaunayCell& b) const {
    if (a == b) return false;
    for (int k = 0; k < 4; ++k) {
      const auto &p = a->vertex(k)->point(), &q = b->vertex(k)->point();
      if (p != q) return p < q;
    }
    return false;
  }
};

namespace clast::reconstruct_detail {

namespace {

enum class Side : std::uint8_t { kOutside, kInside, kReached };

using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, mesh_detail::CgalKernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<Side, mesh_detail::CgalKernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<mesh_detail::CgalKernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using DelaunayCell = Delaunay::Cell_handle;
using Oriented = std::pair<mesh_detail::CgalPoint, mesh_detail::CgalKernel::Vector_3>;
using Function = CGAL::Poisson_reconstruction_function<mesh_detail::CgalKernel>;

/// Flat to rounding: its circumcentre is nowhere, and CGAL must not be asked for it.
bool is_flat(const DelaunayCell& cell) {
  const auto edge = [&](int k) { return cell->vertex(k)->point() - cell->vertex(0)->point(); };
  const auto p = edge(1), q = edge(2), r = edge(3);
  return CGAL::determinant(p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), r.x(), r.y(), r.z()) == 0.0;
}

/// Point at which the side of a cell is tested: the circumcentre, or the centroid of a flat cell.
mesh_detail::CgalPoint asked_at(const DelaunayCell& cell) {
  const mesh_detail::CgalPoint &a = cell->vertex(0)->point(), &b = cell->vertex(1)->point(),
                               &c = cell->vertex(2)->point(), &d = cell->vertex(3)->point();
  if (is_flat(cell)) return CGAL::centroid(a, b, c, d);
  const mesh_detail::CgalPoint centre = CGAL::circumcenter(a, b, c, d);
  return std::isfinite(CGAL::squared_distance(centre, a)) ? centre : CGAL::centroid(a, b, c, d);
}

/// All cells of one side that are connected with `first`; they are `kReached` after.
std::vector<DelaunayCell> hanging_together(const DelaunayCell& first, Side side) {
  std::vector<DelaunayCell> cells = {first};
  first->info() = Side::kReached;
  for (std::size_t next = 0; next < cells.size(); ++next) {
    for (int i = 0; i < 4; ++i) {
      const DelaunayCell beside = cells[next]->neighbor(i);
      if (beside->info() != side) continue;
      beside->info() = Side::kReached;
      cells.push_back(beside);
    }
  }
  return cells;
}

void set(const std::vector<DelaunayCell>& cells, Side side) {
  for (const DelaunayCell& cell : cells) cell->info() = side;
}

/// Keeps the largest component inside, by volume, and fills what is enclosed.
void keep_one_solid(Delaunay& delaunay) {
  const std::vector<DelaunayCell> around =
      hanging_together(delaunay.infinite_vertex()->cell(), Side::kOutside);
  for (const DelaunayCell cell : delaunay.finite_cell_handles()) {
    if (cell->info() == Side::kOutside) cell->info() = Side::kInside;
  }
  set(around, Side::kOutside);
  double largest = 0.0;
  std::vector<DelaunayCell> kept;
  for (const DelaunayCell cell : delaunay.finite_cell_handles()) {
    if (cell->info() != Side::kInside) continue;
    std::vector<DelaunayCell> component = hanging_together(cell, Side::kInside);
    double volume = 0.0;
    for (const DelaunayCell& part : component) volume += delaunay.tetrahedron(part).volume();
    if (volume <= largest) continue;
    largest = volume;
    kept = std::move(component);
  }
  for (const DelaunayCell cell : delaunay.all_cell_handles()) cell->info() = Side::kOutside;
  set(kept, Side::kInside);
}

/// Facets with a cell inside and one outside, facing outward; vertices are numbers of points.
std::vector<TriangleMesh::Triangle> border(const Delaunay& delaunay) {
  std::vector<TriangleMesh::Triangle> triangles;
  for (const DelaunayCell cell : delaunay.finite_cell_handles()) {
    if (cell->info() != Side::kInside) continue;
    for (int i = 0; i < 4; ++i) {
      if (cell->neighbor(i)->info() == Side::kInside) continue;
      TriangleMesh::Triangle t;
      for (int k = 0; k < 3; ++k) {
        // CGAL's triples face into the cell.
        t[static_cast<std::size_t>(2 - k)] =
            cell->vertex(Delaunay::vertex_triple_index(i, k))->info();
      }
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      triangles.push_back(t);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Maximum circumradius, in point spacings, of cells in parts too thin for the indicator.
constexpr double kThin = 1.5;

/// The indicator ends before the tips and ridges that are thinner than the points lie apart, and
/// leaves their points outside: from the body on, takes in the small cells at these points.
void take_in_thin_parts(Delaunay& delaunay, std::span<const double> spacings) {
  std::vector<bool> held(spacings.size(), false);
  std::vector<DelaunayCell> front;
  for (const DelaunayCell cell : delaunay.finite_cell_handles()) {
    if (cell->info() != Side::kInside) continue;
    front.push_back(cell);
    for (int k = 0; k < 4; ++k) held[cell->vertex(k)->info()] = true;
  }
  const auto is_thin_part = [&](const DelaunayCell& cell) {
    double spacing = 0.0;
    for (int k = 0; k < 4; ++k) {
      const std::uint32_t v = cell->vertex(k)->info();
      if (!held[v]) spacing = std::max(spacing, spacings[v]);
    }
    return spacing > 0.0 && !is_flat(cell) &&
           CGAL::squared_radius(cell->vertex(0)->point(), cell->vertex(1)->point(),
                                cell->vertex(2)->point(),
                                cell->vertex(3)->point()) <= kThin * kThin * spacing * spacing;
  };
  for (std::size_t next = 0; next < front.size(); ++next) {
    const DelaunayCell cell = front[next];  // a copy: the list grows
    for (int i = 0; i < 4; ++i) {
      const DelaunayCell beside = cell->neighbor(i);
      if (delaunay.is_infinite(beside) || beside->info() == Side::kInside) continue;
      if (!is_thin_part(beside)) continue;
      beside->info() = Side::kInside;
      front.push_back(beside);
    }
  }
}

constexpr std::size_t kSlopeSamples = 500;
/// The slope is taken over this share of the diagonal to both sides.
constexpr double kSlopeStep = 0.005;

}  // namespace

struct IndicatorFunction::Impl {
  Vec3 origin;
  Function function;

  static std::vector<Oriented> oriented(std::span<const Vec3> points,
                                        std::span<const Vec3> normals) {
    std::vector<Oriented> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 p = points[i] - points[0];
      const Vec3& n = normals[i];
      result.emplace_back(mesh_detail::CgalPoint(p.x(), p.y(), p.z()),
                          mesh_detail::CgalKernel::Vector_3(n.x(), n.y(), n.z()));
    }
    return result;
  }
  explicit Impl(const Vec3& first, const std::vector<Oriented>& points)
      : origin(first),
        function(points.begin(), points.end(), CGAL::First_of_pair_property_map<Oriented>(),
                 CGAL::Second_of_pair_property_map<Oriented>()) {}
};

IndicatorFunction::IndicatorFunction(std::span<const Vec3> points, std::span<const Vec3> normals) {
  if (points.empty()) return;
  CGAL::get_default_random() = CGAL::Random(1);  // CGAL's own is seeded by the clock
  auto impl = std::make_unique<Impl>(points[0], Impl::oriented(points, normals));
  if (!impl->function.compute_implicit_function()) return;
  impl_ = std::move(impl);
  Bounds box;
  for (const Vec3& p : points) box.include(p);
  const double step = kSlopeStep * box.diagonal();
  std::vector<double> slopes;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kSlopeSamples);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    slopes.push_back(
        (value_at(points[i] + step * normals[i]) - value_at(points[i] - step * normals[i])) /
        (2.0 * step));
  }
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  facing_ = *middle < 0.0 ? -1.0 : 1.0;
}

IndicatorFunction::~IndicatorFunction() = default;

bool IndicatorFunction::is_solved() const { return impl_ != nullptr; }

double IndicatorFunction::value_at(const Vec3& position) const {
  const Vec3 p = position - impl_->origin;
  return facing_ * impl_->function(mesh_detail::CgalPoint(p.x(), p.y(), p.z()));
}

TriangleMesh extract_surface(std::span<const Vec3> points, const IndicatorFunction& indicator,
                             std::span<const double> spacings) {
  if (points.empty()) return {};
  const Vec3 origin = points[0];
  std::vector<std::pair<mesh_detail::CgalPoint, std::uint32_t>> numbered;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - origin;
    numbered.emplace_back(mesh_detail::CgalPoint(p.x(), p.y(), p.z()), i);
  }
  Delaunay delaunay(numbered.begin(), numbered.end());
  const auto is_inside = [&](const DelaunayCell& cell) {
    const mesh_detail::CgalPoint p = asked_at(cell);
    return indicator.value_at(origin + Vec3(p.x(), p.y(), p.z())) < 0.0;
  };
  for (const DelaunayCell cell : delaunay.all_cell_handles()) {
    const bool inside = !delaunay.is_infinite(cell) && is_inside(cell);
    cell->info() = inside ? Side::kInside : Side::kOutside;
  }
  keep_one_solid(delaunay);
  if (!spacings.empty()) {
    take_in_thin_parts(delaunay, spacings);
    keep_one_solid(delaunay);
  }
  return {std::vector<Vec3>(points.begin(), points.end()), border(delaunay)};
}

}  // namespace clast::reconstruct_detail
