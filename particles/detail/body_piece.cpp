#include "particles/detail/body_piece.hpp"

#include <cmath>

namespace clast::particles_detail {

namespace {

/// Distance from a plane, relative to the size of the cell, within which a corner is on it.
constexpr double kCellTolerance = 1e-12;

struct Corner {
  Vec3 point;
  double height;  ///< above the plane; 0 on it
};

/// Point on the plane between two corners, the same for both directions of the edge.
Corner crossing(const Corner& a, const Corner& b) {
  const Corner& low = a.height < b.height ? a : b;
  const Corner& high = a.height < b.height ? b : a;
  return {low.point + low.height / (low.height - high.height) * (high.point - low.point), 0.0};
}

/// Adds the part of a triangle on one side (sign -1: below) and closes it over the plane by
/// triangles with the apex `apex`.
void add_side(const std::array<Corner, 3>& triangle, double sign, const Vec3& apex,
              std::vector<Corners>& kept, std::vector<Corners>& caps) {
  std::vector<Corner> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &from = triangle[k], &to = triangle[(k + 1) % 3];
    if (sign * from.height >= 0.0) polygon.push_back(from);
    if ((from.height < 0.0 && to.height > 0.0) || (from.height > 0.0 && to.height < 0.0)) {
      polygon.push_back(crossing(from, to));
    }
  }
  if (polygon.size() < 3) return;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    kept.push_back({polygon[0].point, polygon[k].point, polygon[k + 1].point});
  }
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    if (from.height == 0.0 && to.height == 0.0) caps.push_back({apex, to.point, from.point});
  }
}

double chain_volume(const BodyPiece& piece) {
  const Vec3 origin = piece.cell.centre();
  double sum = 0.0;
  for (const std::vector<Corners>* triangles : {&piece.surface, &piece.caps}) {
    for (const auto& [a, b, c] : *triangles) {
      sum += (a - origin).dot((b - origin).cross(c - origin));
    }
  }
  return sum / 6.0;
}

}  // namespace

BodyPiece whole_body(const TriangleMesh& mesh) {
  Bounds box = bounds(mesh);
  const double margin = 0.01 * box.diagonal();
  box.low.array() -= margin;
  box.high.array() += margin;
  BodyPiece piece{ConvexCell(box), {}, {}, {}, 0.0};
  for (const auto& [a, b, c] : mesh.triangles) {
    piece.surface.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  }
  piece.volume = chain_volume(piece);
  return piece;
}

std::optional<std::array<BodyPiece, 2>> divided(const BodyPiece& piece, const Plane& plane,
                                                const TriangleTree& tree) {
  const double tolerance = kCellTolerance * piece.cell.box().diagonal();
  const Plane reversed{-plane.normal, -plane.distance};
  std::optional<ConvexCell> below = piece.cell.clipped_below(plane, tolerance);
  std::optional<ConvexCell> above = piece.cell.clipped_below(reversed, tolerance);
  if (!below || !above) return std::nullopt;
  std::array<BodyPiece, 2> sides = {BodyPiece{std::move(*below), {}, {}, {}, 0.0},
                                    BodyPiece{std::move(*above), {}, {}, {}, 0.0}};
  const Vec3 centre = piece.cell.centre();
  const Vec3 apex = centre - plane.signed_distance(centre) * plane.normal;
  for (const bool real : {true, false}) {
    for (const Corners& corners : real ? piece.surface : piece.caps) {
      std::array<Corner, 3> triangle;
      bool flat = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const double height = plane.signed_distance(corners[k]);
        triangle[k] = {corners[k], std::abs(height) <= tolerance ? 0.0 : height};
        flat = flat && triangle[k].height == 0.0;
      }
      for (const std::size_t side : {0u, 1u}) {
        // A triangle in the plane is below it; its side above is closed by the cap.
        if (flat && side == 1) continue;
        BodyPiece& target = sides[side];
        add_side(triangle, side == 0 ? -1.0 : 1.0, apex, real ? target.surface : target.caps,
                 target.caps);
      }
    }
  }
  for (BodyPiece& side : sides) {
    side.volume = chain_volume(side);
    for (const Vec3& corner : side.cell.vertices()) {
      if (tree.signed_distance(corner) < 0.0) side.inner_corners.push_back(corner);
    }
    if (side.surface.empty() && side.inner_corners.empty()) return std::nullopt;
  }
  return sides;
}

std::vector<Vec3> points_of(const BodyPiece& piece) {
  std::vector<Vec3> points = piece.inner_corners;
  for (const Corners& triangle : piece.surface) {
    points.insert(points.end(), triangle.begin(), triangle.end());
  }
  return points;
}

}  // namespace clast::particles_detail
