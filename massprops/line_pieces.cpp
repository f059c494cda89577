#include "massprops/line_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace clast::massprops_detail {
namespace {

// A plane this close to vertical bounds a line on its side, not along it.
constexpr double kVertical = 1e-12;

}  // namespace

PieceLineClipper::PieceLineClipper(const std::vector<OffsetPiece>& pieces, double radius)
    : radius_squared_(radius * radius) {
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return pieces[a].box.low.y() < pieces[b].box.low.y();
  });
  pieces_.reserve(pieces.size());
  std::vector<HeightPlane> lower, upper, sides;
  for (const std::uint32_t i : order) {
    const OffsetPiece& from = pieces[i];
    lower.clear();
    upper.clear();
    sides.clear();
    for (const HalfSpace& plane : from.planes) {
      const Vec3& n = plane.normal;
      if (std::abs(n.z()) < kVertical) {
        sides.push_back({n.x(), n.y(), -plane.offset});
        continue;
      }
      const HeightPlane bound{-n.x() / n.z(), -n.y() / n.z(), plane.offset / n.z()};
      (n.z() > 0.0 ? upper : lower).push_back(bound);
    }
    // A line crosses the planes' common part where every lower bound is below every upper one.
    for (const HeightPlane& low : lower) {
      for (const HeightPlane& high : upper) {
        sides.push_back(
            {low.x_slope - high.x_slope, low.y_slope - high.y_slope, low.height - high.height});
      }
    }
    Piece piece{{from.box.low.y(), from.box.high.y()},
                {from.box.low.x(), from.box.high.x()},
                {from.box.low.z(), from.box.high.z()},
                from.curved_face,
                from.centre,
                from.axis,
                0,
                0,
                0,
                0};
    const auto packed = [&](const std::vector<HeightPlane>& list) {
      height_planes_.insert(height_planes_.end(), list.begin(), list.end());
      return static_cast<std::uint32_t>(height_planes_.size());
    };
    piece.lower = packed({});
    piece.upper = packed(lower);
    piece.sides = packed(upper);
    piece.end = packed(sides);
    pieces_.push_back(piece);
  }
}

LineInterval PieceLineClipper::x_range(std::size_t index, double y) const {
  const Piece& piece = pieces_[index];
  LineInterval range = piece.columns;
  if (piece.curved_face == OffsetPiece::CurvedFace::sphere) {
    const double dy = y - piece.centre.y();
    const double half = std::sqrt(std::max(radius_squared_ - dy * dy, 0.0));
    range.low = std::max(range.low, piece.centre.x() - half);
    range.high = std::min(range.high, piece.centre.x() + half);
  }
  for (const HeightPlane& side : height_planes(piece.sides, piece.end)) {
    const double room = -side.height - side.y_slope * y;
    if (side.x_slope > 0.0) {
      range.high = std::min(range.high, room / side.x_slope);
    } else if (side.x_slope < 0.0) {
      range.low = std::max(range.low, room / side.x_slope);
    } else if (room < 0.0) {
      return {};
    }
  }
  return range;
}

LineInterval PieceLineClipper::clip_round_line(const Piece& piece, double x, double y) const {
  if (piece.curved_face == OffsetPiece::CurvedFace::none) return piece.heights;
  const double dx = x - piece.centre.x();
  const double dy = y - piece.centre.y();
  const double along = dx * piece.axis.x() + dy * piece.axis.y();
  const double a = 1.0 - piece.axis.z() * piece.axis.z();
  const double b = -along * piece.axis.z();
  const double c = dx * dx + dy * dy - along * along - radius_squared_;
  if (a < kVertical) return c <= 0.0 ? piece.heights : LineInterval{};
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0)) return {};
  const double half = std::sqrt(discriminant);
  return {piece.centre.z() + (-b - half) / a, piece.centre.z() + (-b + half) / a};
}

LineInterval PieceLineClipper::clip_line(std::size_t index, double x, double y) const {
  const Piece& piece = pieces_[index];
  LineInterval result = clip_round_line(piece, x, y);
  for (const HeightPlane& bound : height_planes(piece.lower, piece.upper)) {
    result.low = std::max(result.low, bound.height_at(x, y));
  }
  for (const HeightPlane& bound : height_planes(piece.upper, piece.sides)) {
    result.high = std::min(result.high, bound.height_at(x, y));
  }
  return result;
}

TriangleLineCrossings::TriangleLineCrossings(const TriangleMesh& core) {
  triangles_.reserve(core.triangles.size());
  for (const auto& corners : core.triangles) {
    Triangle t;
    for (int i = 0; i < 3; ++i) {
      t.corner[i] = core.vertices[corners[i]];
      t.reversed[i] = corners[i] > corners[(i + 1) % 3];
      t.box.include(t.corner[i]);
    }
    const Vec3 n = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
    // Edge-on to the line, or without area: the height is clamped to the triangle's own range.
    if (std::abs(n.z()) > 0.0) {
      t.plane = {-n.x() / n.z(), -n.y() / n.z(), n.dot(t.corner[0]) / n.z()};
    }
    triangles_.push_back(t);
  }
  std::stable_sort(triangles_.begin(), triangles_.end(), [](const Triangle& a, const Triangle& b) {
    return a.box.low.y() < b.box.low.y();
  });
}

LineInterval TriangleLineCrossings::y_range(std::size_t triangle) const {
  const Bounds& box = triangles_[triangle].box;
  return {box.low.y(), box.high.y()};
}

/// Not by the edges: only `crossing_sign` may decide on which side of one a line is.
LineInterval TriangleLineCrossings::x_range(std::size_t triangle, double) const {
  const Bounds& box = triangles_[triangle].box;
  return {box.low.x(), box.high.x()};
}

int TriangleLineCrossings::crossing_sign(std::size_t triangle, double x, double y) const {
  const Triangle& t = triangles_[triangle];
  int left_of = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3& p = t.corner[t.reversed[i] ? (i + 1) % 3 : i];
    const Vec3& q = t.corner[t.reversed[i] ? i : (i + 1) % 3];
    const bool left = (q.x() - p.x()) * (y - p.y()) > (q.y() - p.y()) * (x - p.x());
    left_of += left != t.reversed[i];
  }
  return left_of == 3 ? 1 : left_of == 0 ? -1 : 0;
}

double TriangleLineCrossings::crossing_height(std::size_t triangle, double x, double y) const {
  const Triangle& t = triangles_[triangle];
  return std::clamp(t.plane.height_at(x, y), t.box.low.z(), t.box.high.z());
}

}  // namespace clast::massprops_detail
