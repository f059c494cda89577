#pragma once
/// What vertical lines cut out of a core and its skin.
#include <cstdint>
#include <span>
#include <vector>

#include "massprops/offset_layer.hpp"

namespace clast::massprops_detail {

/// Of numbers; empty when low >= high.
struct LineInterval {
  double low = 0.0, high = 0.0;
};

/// A plane as a height: x_slope x + y_slope y + height.
struct HeightPlane {
  double x_slope = 0.0, y_slope = 0.0, height = 0.0;
  double height_at(double x, double y) const { return x_slope * x + y_slope * y + height; }
};

/// Convex pieces prepared for vertical lines; sorted by their lowest y and packed, since rows of
/// lines meet neighbours one after the other.
class VerticalLinePieces {
 public:
  VerticalLinePieces(const std::vector<OffsetPiece>& pieces, double radius);

  std::size_t size() const { return pieces_.size(); }
  /// Lowest and highest y of a piece; the lowest ascend.
  LineInterval y_range(std::size_t piece) const { return pieces_[piece].rows; }
  /// The x between which lines at `y` can cross the piece.
  LineInterval x_range(std::size_t piece, double y) const;
  /// The part of the line at (x, y) inside the piece, x within its reach.
  LineInterval clip_line(std::size_t piece, double x, double y) const;

 private:
  struct Piece {
    LineInterval rows, columns, heights;
    OffsetPiece::CurvedFace round;
    Vec3 centre, axis;  ///< no axis for a ball: the cylinder's formulas then give the ball's chord
    /// In `height_planes_`: lower bounds, upper bounds, and sides of the shadow that the planes
    /// cast along z, where slope and height are those of at(x, y) <= 0.
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

/// The core's triangles prepared for vertical lines, sorted by their lowest y.
class VerticalLineTriangles {
 public:
  explicit VerticalLineTriangles(const TriangleMesh& core);

  std::size_t size() const { return triangles_.size(); }
  LineInterval y_range(std::size_t triangle) const;
  LineInterval x_range(std::size_t triangle, double y) const;

  /// +1 where a line that rises at (x, y) leaves through the triangle, -1 where it enters, 0 beside
  /// it. Each edge is judged from its smaller vertex index, so both its triangles agree to the bit
  /// and no line slips between them or hits both.
  int crossing_sign(std::size_t triangle, double x, double y) const;
  /// Height at which it crosses there.
  double crossing_height(std::size_t triangle, double x, double y) const;

 private:
  struct Triangle {
    std::array<Vec3, 3> corner;
    std::array<bool, 3> reversed;  ///< edge i runs from the larger to the smaller vertex index
    HeightPlane plane;
    Bounds box;
  };
  std::vector<Triangle> triangles_;
};

}  // namespace clast::massprops_detail
