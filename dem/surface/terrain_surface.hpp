#pragma once
/// Terrain for contacts: one-sided triangles with classified and indexed edges.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Checked terrain for the contact search. The solid is below the triangles (opposite to their
/// normals). Overhangs and vertical walls are allowed; holes are not checked.
class TerrainSurface {
 public:
  /// Builds the surface.
  /// @param mesh  triangles with normals out of the ground, welded, z up, local frame, m
  /// @param zones  ground zone of each triangle
  /// @param radius  offset of the contact surface above the triangles, m
  /// @throws GeometryError  if it is empty, a triangle is degenerate, or an edge non-manifold
  TerrainSurface(TriangleMesh mesh, std::vector<std::uint16_t> zones, double radius = 0.0);
  ~TerrainSurface();
  TerrainSurface(TerrainSurface&&) noexcept;

  const TriangleMesh& mesh() const;
  double radius() const;
  std::uint16_t zone_count() const;  ///< largest zone index + 1
  const Bounds& extent() const;

  /// Returns the height of the surface on the vertical through (x, y): the upward-facing surface
  /// nearest to `z_near`; empty outside the surveyed area.
  std::optional<double> height_at(double x, double y, double z_near) const;
  /// Returns the ground zone of that surface.
  std::optional<std::uint16_t> zone_at(double x, double y, double z_near) const;
  /// True if some triangle is above or below (x, y).
  bool covers(double x, double y) const;

  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
