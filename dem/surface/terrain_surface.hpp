#pragma once
/// Terrain surface for the contact search: one-sided triangles with ground zones.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Terrain for the contact search. The solid ground lies on the side opposite to the triangle
/// normals. Overhangs and vertical walls are allowed. Holes are not checked for.
class TerrainSurface {
 public:
  /// Builds the terrain surface.
  /// @param mesh  welded triangles with normals out of the ground; local frame, z up, m
  /// @param zones  ground zone of each triangle
  /// @param radius  offset of the contact surface above the triangles, m
  /// @throws GeometryError  if the mesh is empty, a triangle degenerate or an edge non-manifold
  TerrainSurface(TriangleMesh mesh, std::vector<std::uint16_t> zones, double radius = 0.0);
  ~TerrainSurface();
  TerrainSurface(TerrainSurface&&) noexcept;

  const TriangleMesh& mesh() const;
  double radius() const;
  std::uint16_t zone_count() const;  ///< largest zone index + 1
  const Bounds& extent() const;

  /// Returns the height of the surface at (x, y), m; empty outside the surveyed area. If there are
  /// several upward-facing triangles, it is the height nearest to `z_near`.
  std::optional<double> height_at(double x, double y, double z_near) const;
  /// Returns the ground zone of the triangle that gives `height_at(x, y, z_near)`; empty outside.
  std::optional<std::uint16_t> zone_at(double x, double y, double z_near) const;
  /// True if the vertical line through (x, y) meets a triangle.
  bool covers(double x, double y) const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
