#pragma once
/// Contact surface: features with a plan grid. It represents the ground or a block hit by others.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast::dem_detail {

/// Nearest point of a surface to a query, with the side of the query.
struct NearestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< outward normal of the nearest face, edge or vertex
  double distance = 0.0;        ///< signed: negative inside the solid
  std::uint32_t face = kNoFeature;
  bool within_face = false;           ///< true if the foot is inside the face
  std::uint32_t edge = kNoFeature;    ///< edge that contains the foot, otherwise kNoFeature
  std::uint32_t vertex = kNoFeature;  ///< vertex at the foot, otherwise kNoFeature
};

/// True if the nearest point is on the border of an open surface.
bool is_on_border(const SurfaceFeatures& surface, const NearestPoint& nearest);

/// Returns the nearest point of a face. The normal of the nearest feature (face, edge or vertex)
/// decides the sign of `distance`.
NearestPoint nearest_point_on_face(const SurfaceFeatures& surface, std::uint32_t face,
                                   const Vec3& query);
/// Returns the nearest point of a face without the sign of `distance`, which is set only if the
/// foot is inside the face. First step of `nearest_point_on_face`, for testing many faces.
NearestPoint project_onto_face(const SurfaceFeatures& surface, std::uint32_t face,
                               const Vec3& query);
void determine_query_side(const SurfaceFeatures& surface, const Vec3& query, NearestPoint& foot);

/// Plan grid: each cell lists the faces whose bounds overlap it, with their height range.
class PlanGrid {
 public:
  PlanGrid() = default;
  explicit PlanGrid(const SurfaceFeatures& surface);

  struct Cell {
    std::span<const std::uint32_t> faces;
    double low = 0.0;
    double high = 0.0;
  };
  /// Range of the cells that cover a plan rectangle, clamped to the grid; empty (first > last) if
  /// the rectangle is outside the grid.
  struct CellRange {
    int first_column, last_column, first_row, last_row;
  };
  CellRange cell_range(double x_low, double x_high, double y_low, double y_high) const;
  Cell cell(int column, int row) const;
  /// Returns the largest height of the faces in a cell, m; -infinity if it has none.
  double max_cell_height(int column, int row) const {
    return highs_[static_cast<std::size_t>(row) * columns_ + column];
  }
  /// Returns the horizontal distance of a point from a cell, m.
  double distance_to_cell(int column, int row, const Vec2& point) const {
    const Vec2 low = corner_ + size_ * Vec2(column, row);
    return (low - point).cwiseMax(point - low - Vec2::Constant(size_)).cwiseMax(0.0).norm();
  }
  double cell_size() const { return size_; }
  int column_count() const { return columns_; }
  int row_count() const { return rows_; }

 private:
  double size_ = 1.0;
  Vec2 corner_ = Vec2::Zero();
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> faces_;
  std::vector<float> lows_, highs_;  // widened to the next float, so never too tight
};

struct IndexedSurface {
  SurfaceFeatures features;
  std::vector<std::uint32_t> face_of_vertex;  ///< one face per vertex, which gives its zone
  double radius = 0.0;    ///< offset of the rounded surface from the features, m
  Bounds extent;          ///< of the vertices
  bool is_block = false;  ///< false for a terrain
  PlanGrid grid;

  /// Nearest point of the triangles (not of the rounded surface); empty if none is within `reach`.
  /// @param guess  index of a face that is probably near; affects only the speed
  std::optional<NearestPoint> nearest_point(const Vec3& query, double reach,
                                            std::uint32_t guess = kNoFeature) const;
  /// Returns a lower bound of the distance to the triangles, from the height ranges of the cells; 0
  /// if they give no bound. Cheaper than `nearest_point`.
  double height_clearance(const Vec3& query, double reach) const;
  /// Returns the sorted faces whose bounds are within `reach` of the box.
  std::vector<std::uint32_t> find_faces_near(const Bounds& box, double reach) const;
};

/// Builds the surface of a mesh.
/// @param wires  edges without triangles (capsules), as vertex pairs
/// @throws GeometryError  if a triangle is degenerate or an edge non-manifold
IndexedSurface build_indexed_surface(const TriangleMesh& mesh, double radius,
                                     std::span<const std::array<std::uint32_t, 2>> wires = {});
/// Builds the surface of a block, in the frame of its core.
IndexedSurface build_indexed_surface(const SpheroPolyhedron& body);

}  // namespace clast::dem_detail
