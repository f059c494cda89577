#include "particles/detail/body_surface.hpp"

#include <cmath>
#include <utility>

#include "mesh/surface_samples.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast::particles_detail {

namespace {

constexpr int kSurfaceSegments = 6;  ///< of a quarter turn, for samples
/// Least distance of a sample from the solid over the radius. Samples on chords of the rounded mesh
/// have at least 0.9914. Samples below are inside the body, beside a reflex edge.
constexpr double kLeastOffset = 0.99;
constexpr std::size_t kAreaSamples = 4000;  ///< for the exposed part of the area

}  // namespace

BodySurface::BodySurface(TriangleMesh solid, double radius)
    : solid_(std::move(solid)), radius_(radius), tree_(solid_) {
  if (radius_ > 0.0) {
    rounded_ = rounded_surface_mesh(make_sphero_polyhedron(solid_, radius_), kSurfaceSegments);
  } else {
    rounded_ = solid_;
  }
  box_ = bounds(rounded_);
  const std::vector<Vec3> samples = sample_surface(rounded_, kAreaSamples);
  exposed_part_ = static_cast<double>(exposed(samples).size()) / static_cast<double>(kAreaSamples);
}

BodySurface::Closest BodySurface::closest(const Vec3& point, std::uint32_t hint) const {
  const TriangleTree::SignedClosest found = tree_.signed_closest_point(point, hint);
  return {found.distance - radius_, found.outward, found.triangle};
}

std::vector<Vec3> BodySurface::exposed(const std::vector<Vec3>& points) const {
  if (radius_ == 0.0) return points;
  std::vector<Vec3> kept;
  std::uint32_t hint = 0;
  for (const Vec3& point : points) {
    const Closest found = closest(point, hint);
    hint = found.triangle;
    if (found.distance > (kLeastOffset - 1.0) * radius_) kept.push_back(found.foot(point));
  }
  return kept;
}

std::vector<Vec3> BodySurface::sample(std::size_t count) const {
  const double all = static_cast<double>(count) / exposed_part_;
  return exposed(sample_surface(rounded_, static_cast<std::size_t>(std::lround(all))));
}

std::vector<Vec3> BodySurface::corners(std::size_t most) const {
  std::vector<Vec3> normals(solid_.vertices.size(), Vec3::Zero());
  for (std::uint32_t t = 0; t < solid_.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      normals[solid_.triangles[t][static_cast<std::size_t>(k)]] = tree_.outward_normal(t, 1 + k);
    }
  }
  const std::size_t step = solid_.vertices.size() / most + 1;
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < solid_.vertices.size(); v += step) {
    points.push_back(solid_.vertices[v] + radius_ * normals[v]);
  }
  return exposed(points);
}

double BodySurface::area() const { return exposed_part_ * surface_area(rounded_); }

}  // namespace clast::particles_detail
