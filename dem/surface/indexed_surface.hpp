#pragma once
/// Contact surface of the ground or of a block: vertices, edges and faces with a grid in plan.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast::dem_detail {

/// Point of a surface nearest to a query point, and the side on which the query point lies.
struct NearestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< outward normal of the nearest face, edge or vertex
  double distance = 0.0;  ///< signed distance of the query point, m; negative inside the solid
  std::uint32_t face = kNoFeature;
  bool within_face = false;         ///< true if the nearest point is in the interior of the face
  std::uint32_t edge = kNoFeature;  ///< edge that contains the nearest point, otherwise kNoFeature
  std::uint32_t vertex = kNoFeature;  ///< vertex at the nearest point, otherwise kNoFeature
};

/// True if the nearest point is on the border of an open surface.
bool is_on_border(const SurfaceFeatures& surface, const NearestPoint& nearest);

/// Returns the point of a face nearest to a query point, with the signed distance.
NearestPoint nearest_point_on_face(const SurfaceFeatures& surface, std::uint32_t face,
                                   const Vec3& query);
/// Returns the point of a face nearest to a query point. The distance has no sign if the point is
/// on an edge or vertex. Faster than `nearest_point_on_face`.
NearestPoint project_onto_face(const SurfaceFeatures& surface, std::uint32_t face,
                               const Vec3& query);
void determine_query_side(const SurfaceFeatures& surface, const Vec3& query, NearestPoint& foot);

/// Grid in plan. Each cell lists the faces of a surface whose bounds overlap it, and their height
/// range.
class PlanGrid {
 public:
  PlanGrid() = default;
  explicit PlanGrid(const SurfaceFeatures& surface);

  struct Cell {
    std::span<const std::uint32_t> faces;
    double low = 0.0;
    double high = 0.0;
  };
  /// Columns and rows of the cells that cover a plan rectangle. Empty (first > last) if the
  /// rectangle is outside the grid.
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
  /// One adjacent face of each vertex, which gives its ground zone.
  std::vector<std::uint32_t> face_of_vertex;
  double radius = 0.0;    ///< offset of the rounded surface from the features, m
  Bounds extent;          ///< bounding box of the vertices
  bool is_block = false;  ///< false for a terrain
  PlanGrid grid;

  /// Returns the nearest point of the triangles, without rounding; empty if none is within `reach`.
  /// @param guess  index of a face that is probably near; affects only the speed
  std::optional<NearestPoint> nearest_point(const Vec3& query, double reach,
                                            std::uint32_t guess = kNoFeature) const;
  /// Returns a lower bound of the distance to the triangles, from the height ranges of the grid
  /// cells; 0 if unknown. Faster than `nearest_point`.
  double height_clearance(const Vec3& query, double reach) const;
  /// Finds the faces whose bounding boxes are within `reach` of a box. Returns their sorted
  /// indices.
  std::vector<std::uint32_t> find_faces_near(const Bounds& box, double reach) const;
};

/// Builds the contact surface of a mesh.
/// @param wires  edges without triangles (capsules), as vertex pairs
/// @throws GeometryError  if a triangle is degenerate or an edge non-manifold
IndexedSurface build_indexed_surface(const TriangleMesh& mesh, double radius,
                                     std::span<const std::array<std::uint32_t, 2>> wires = {});
/// Builds the contact surface of a block, in the frame of its core.
IndexedSurface build_indexed_surface(const SpheroPolyhedron& body);

}  // namespace clast::dem_detail
