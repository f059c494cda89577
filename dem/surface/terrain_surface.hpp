#pragma once
/// The ground in contact: one-sided triangles with their edges classified and indexed.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A checked terrain for the contact search. Solid is below the triangles (against their
/// normals). Overhangs and vertical walls are allowed; holes are not checked.
class TerrainSurface {
 public:
  /// @param mesh    triangles with normals out of the ground, welded, z up, local frame, m
  /// @param zones   ground zone of every triangle
  /// @param radius  the skin is this far above the triangles, m
  /// @throws GeometryError  empty, a degenerate triangle, or an edge with three or more triangles
  TerrainSurface(TriangleMesh mesh, std::vector<std::uint16_t> zones, double radius = 0.0);
  ~TerrainSurface();
  TerrainSurface(TerrainSurface&&) noexcept;

  const TriangleMesh& mesh() const;
  double radius() const;
  std::uint16_t zone_count() const;  ///< largest zone number + 1
  const Bounds& extent() const;

  /// Height of the skin on the vertical through (x, y): the surface nearest to `z_near`, out of all
  /// that face upwards there. None outside the surveyed plan area.
  std::optional<double> height_at(double x, double y, double z_near) const;
  /// Ground zone of that surface.
  std::optional<std::uint16_t> zone_at(double x, double y, double z_near) const;
  /// True when some triangle is above or below (x, y).
  bool covers(double x, double y) const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
