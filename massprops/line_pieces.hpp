#pragma once
/// Intersections of vertical lines (along z) with a core and its offset layer.
#include <cstdint>
#include <span>
#include <vector>

#include "massprops/offset_layer.hpp"

namespace clast::massprops_detail {

/// Interval of numbers; empty if low >= high.
struct LineInterval {
  double low = 0.0, high = 0.0;
};

/// Plane z = x_slope x + y_slope y + height.
struct HeightPlane {
  double x_slope = 0.0, y_slope = 0.0, height = 0.0;
  double height_at(double x, double y) const { return x_slope * x + y_slope * y + height; }
};

/// Intersection of convex pieces with vertical lines. The pieces are sorted by their lowest y.
class PieceLineClipper {
 public:
  PieceLineClipper(const std::vector<OffsetPiece>& pieces, double radius);

  std::size_t size() const { return pieces_.size(); }
  /// Returns the range of y of a piece. Its lower end increases with the index of the piece.
  LineInterval y_range(std::size_t piece) const { return pieces_[piece].rows; }
  /// Returns the range of x in which vertical lines at `y` can intersect the piece.
  LineInterval x_range(std::size_t piece, double y) const;
  /// Returns the interval of z in which the vertical line through (x, y) is inside a piece. x must
  /// be in `x_range`.
  LineInterval clip_line(std::size_t piece, double x, double y) const;

 private:
  struct Piece {
    LineInterval rows, columns, heights;
    OffsetPiece::CurvedFace curved_face;
    Vec3 centre,
        axis;  ///< zero for balls, for which the cylinder formulas give the chord of the ball
    /// Indices into `height_planes_` of the first lower bound of z, first upper bound and first
    /// side, and end index. A line can meet the piece if height_at(x, y) <= 0 for all sides.
    std::uint32_t lower, upper, sides, end;
  };

  LineInterval clip_round_line(const Piece& piece, double x, double y) const;
  std::span<const HeightPlane> height_planes(std::uint32_t begin, std::uint32_t end) const {
    return {height_planes_.data() + begin, height_planes_.data() + end};
  }

  double radius_squared_;
  std::vector<Piece> pieces_;
  std::vector<HeightPlane> height_planes_;
};

/// Crossings of the core's triangles with vertical lines. The triangles are sorted by lowest y.
class TriangleLineCrossings {
 public:
  explicit TriangleLineCrossings(const TriangleMesh& core);

  std::size_t size() const { return triangles_.size(); }
  LineInterval y_range(std::size_t triangle) const;
  LineInterval x_range(std::size_t triangle, double y) const;

  /// Returns +1 if the upward line through (x, y) leaves the core through the triangle, -1 if it
  /// enters there, and 0 if it misses the triangle. A line through a shared edge hits exactly one
  /// of the two triangles.
  int crossing_sign(std::size_t triangle, double x, double y) const;
  /// Returns the height at which the vertical line through (x, y) crosses the triangle.
  double crossing_height(std::size_t triangle, double x, double y) const;

 private:
  struct Triangle {
    std::array<Vec3, 3> corner;
    std::array<bool, 3> reversed;  ///< edge runs from the larger to the smaller index
    HeightPlane plane;
    Bounds box;
  };
  std::vector<Triangle> triangles_;
};

}  // namespace clast::massprops_detail
