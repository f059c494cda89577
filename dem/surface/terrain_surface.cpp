#include "dem/surface/terrain_surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// Returns the height at which the vertical line through (x, y) meets the face, if it does.
std::optional<double> height_on_face(const SurfaceFeatures& features, const SurfaceFace& face,
                                     double x, double y) {
  if (std::abs(face.normal.z()) < 1e-12) return std::nullopt;
  const double sign = face.normal.z() > 0.0 ? 1.0 : -1.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = features.vertices[face.vertices[k]];
    const Vec3& b = features.vertices[face.vertices[(k + 1) % 3]];
    const double first = (b.x() - a.x()) * (y - a.y());
    const double second = (b.y() - a.y()) * (x - a.x());
    // A point on a shared edge belongs to both faces, also after rounding.
    if (sign * (first - second) < -1e-12 * (std::abs(first) + std::abs(second)))
      return std::nullopt;
  }
  const Vec3& a = features.vertices[face.vertices[0]];
  return a.z() - (face.normal.x() * (x - a.x()) + face.normal.y() * (y - a.y())) / face.normal.z();
}

}  // namespace

TerrainSurface::TerrainSurface(TriangleMesh mesh, std::vector<std::uint16_t> zones, double radius)
    : impl_(std::make_unique<Impl>()) {
  if (mesh.triangles.empty()) throw GeometryError("terrain: no triangles");
  if (zones.size() != mesh.triangles.size()) {
    throw GeometryError("terrain: " + std::to_string(mesh.triangles.size()) + " triangles but " +
                        std::to_string(zones.size()) + " zone numbers");
  }
  if (!(radius >= 0.0 && std::isfinite(radius))) {
    throw InputError("terrain: radius = " + format_significant(radius, 6) + "; must be 0 or more");
  }
  impl_->surface = build_indexed_surface(mesh, radius);
  impl_->mesh = std::move(mesh);
  impl_->zone_count = static_cast<std::uint16_t>(*std::max_element(zones.begin(), zones.end()) + 1);
  impl_->zones = std::move(zones);
}

TerrainSurface::~TerrainSurface() = default;
TerrainSurface::TerrainSurface(TerrainSurface&&) noexcept = default;

const TriangleMesh& TerrainSurface::mesh() const { return impl_->mesh; }
double TerrainSurface::radius() const { return impl_->surface.radius; }
std::uint16_t TerrainSurface::zone_count() const { return impl_->zone_count; }
const Bounds& TerrainSurface::extent() const { return impl_->surface.extent; }

std::optional<TerrainSurface::Impl::SurfacePoint> TerrainSurface::Impl::find_surface_point(
    double x, double y, double z_near) const {
  std::optional<SurfacePoint> best;
  const PlanGrid::CellRange home = surface.grid.cell_range(x, x, y, y);
  for (int row = home.first_row; row <= home.last_row; ++row) {
    for (int column = home.first_column; column <= home.last_column; ++column) {
      for (const std::uint32_t f : surface.grid.cell(column, row).faces) {
        const SurfaceFace& face = surface.features.faces[f];
        if (face.normal.z() <= 0.0) continue;
        const std::optional<double> z = height_on_face(surface.features, face, x, y);
        if (!z) continue;
        const double skin = *z + surface.radius / face.normal.z();
        if (!best || std::abs(skin - z_near) < std::abs(best->height - z_near)) best = {skin, f};
      }
    }
  }
  return best;
}

std::optional<double> TerrainSurface::height_at(double x, double y, double z_near) const {
  const std::optional<Impl::SurfacePoint> find_surface_point =
      impl_->find_surface_point(x, y, z_near);
  return find_surface_point ? std::optional(find_surface_point->height) : std::nullopt;
}

std::optional<std::uint16_t> TerrainSurface::zone_at(double x, double y, double z_near) const {
  const std::optional<Impl::SurfacePoint> find_surface_point =
      impl_->find_surface_point(x, y, z_near);
  return find_surface_point ? std::optional(impl_->zones[find_surface_point->face]) : std::nullopt;
}

bool TerrainSurface::covers(double x, double y) const {
  const PlanGrid::CellRange home = impl_->surface.grid.cell_range(x, x, y, y);
  for (int row = home.first_row; row <= home.last_row; ++row) {
    for (int column = home.first_column; column <= home.last_column; ++column) {
      for (const std::uint32_t f : impl_->surface.grid.cell(column, row).faces) {
        if (height_on_face(impl_->surface.features, impl_->surface.features.faces[f], x, y))
          return true;
      }
    }
  }
  return false;
}

}  // namespace clast
