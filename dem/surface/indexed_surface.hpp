#pragma once
/// A surface others can touch: features with a plan grid over them. The ground is one, and so is
/// every block that another block may hit.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast::dem_detail {

/// The point of a surface nearest to a query, with the side the query lies on.
struct NearestPoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< out of the solid: of the face, edge or vertex hit
  double distance = 0.0;        ///< signed: negative inside the solid
  std::uint32_t face = kNoFeature;
  bool within_face = false;           ///< the foot of the query lies on the face, not on its border
  std::uint32_t edge = kNoFeature;    ///< else it lies on this edge of the face ...
  std::uint32_t vertex = kNoFeature;  ///< ... or on this vertex
};

/// True when the point nearest to a query lies where an open surface ends.
bool is_on_border(const SurfaceFeatures& surface, const NearestPoint& nearest);

/// Nearest point of one face to `query`; `distance` is signed by the normal of the feature hit.
NearestPoint nearest_on_face(const SurfaceFeatures& surface, std::uint32_t face, const Vec3& query);
/// The same in two steps, for those who look at many faces: first the point, without the side that
/// the query lies on when that is no foot within the face, then the side.
NearestPoint project_onto_face(const SurfaceFeatures& surface, std::uint32_t face,
                               const Vec3& query);
void determine_side(const SurfaceFeatures& surface, const Vec3& query, NearestPoint& foot);

/// Plan grid: every cell lists the faces whose bounds reach into it, with their height range.
class PlanGrid {
 public:
  PlanGrid() = default;
  explicit PlanGrid(const SurfaceFeatures& surface);

  struct Cell {
    std::span<const std::uint32_t> faces;
    double low = 0.0;
    double high = 0.0;
  };
  /// Cell range [first, last] that covers the plan interval, clamped to the grid; empty (first >
  /// last) when outside.
  struct CellRange {
    int first_column, last_column, first_row, last_row;
  };
  CellRange cells_over(double x_low, double x_high, double y_low, double y_high) const;
  Cell cell(int column, int row) const;
  /// Top of the height range of a cell, m; -infinity where it lists no face.
  double cell_top(int column, int row) const {
    return highs_[static_cast<std::size_t>(row) * columns_ + column];
  }
  /// Distance of a point from a cell in plan, m.
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
  std::vector<std::uint32_t> face_of_vertex;  ///< one face at every vertex: gives its zone
  double radius = 0.0;                        ///< the skin is this far outside the features, m
  Bounds extent;                              ///< of the vertices
  bool is_block = false;                      ///< not of a terrain
  PlanGrid grid;

  /// Nearest point of the triangles (not the skin) to `query`, or none farther than `reach`.
  /// @param guess  a face that may be near: the answer is the same, but sooner found
  std::optional<NearestPoint> nearest_point(const Vec3& query, double reach,
                                            std::uint32_t guess = kNoFeature) const;
  /// A lower bound of the distance from `query` to the triangles, by height ranges alone; 0 when
  /// they give none. Cheap, for points well above the ground.
  double height_clearance(const Vec3& query, double reach) const;
  /// Faces whose bounds come within `reach` of the box, sorted.
  std::vector<std::uint32_t> find_faces_near(const Bounds& box, double reach) const;
};

/// @param wires  edges that belong to no triangle (capsules), as vertex pairs
/// @throws GeometryError  a triangle without area, or an edge with three or more triangles
IndexedSurface index_surface(const TriangleMesh& mesh, double radius,
                             std::span<const std::array<std::uint32_t, 2>> wires = {});
/// The surface of a block, in the frame of its core.
IndexedSurface index_surface(const SpheroPolyhedron& body);

}  // namespace clast::dem_detail
