#include "reconstruct/detail/shape_anomalies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/number_text.hpp"
#include "mesh/plane.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/detail/body_seam.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/oriented_box.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Mean thickness, twice the volume over the area, against S: a ball has 0.33, a plate 0.8, and a
/// rock of one and a half times the area of a smooth one 0.2.
constexpr double kShellThickness = 0.1;
/// Volume over that of the convex hull, below which a body is hollow; few rocks have 0.7.
constexpr double kHollowFill = 0.5;
/// Minimum z of the normals of ground; fraction of the height above the ground's median height from
/// which the body counts as tall.
constexpr double kGroundLevel = 0.85, kRises = 0.35;
/// It does not fall away from the body, as the flanks of a flat rock do: mean sine, outward.
constexpr double kGroundFall = 0.12;
constexpr double kMaxSlabHeight = 0.8;  ///< of the width: a needle that stands up has no ground
constexpr double kMinGround = 0.2;      ///< of the plan area
/// It reaches beyond the body, by this share of the width, in so many of the sectors of the plan.
constexpr double kMinRim = 0.1;
constexpr std::size_t kGroundSectors = 12, kSectorsWithGround = 10;
/// The base is as wide as the ground: minimum fraction of the plan that faces down within this
/// fraction of the height.
constexpr double kBaseFraction = 0.7, kBaseHeight = 0.3;

/// Depth of a point below the planes of a convex hull.
double depth_below(const std::vector<Plane>& planes, const Vec3& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes) depth = std::min(depth, -plane.signed_distance(point));
  return depth;
}

ShapeAnomaly hollow_of(const TriangleMesh& closed, const TriangleMesh& hull, double fill) {
  std::vector<Plane> planes;
  for (const auto& [a, b, c] : hull.triangles) {
    const Vec3 normal = (hull.vertices[b] - hull.vertices[a])
                            .cross(hull.vertices[c] - hull.vertices[a])
                            .normalized();
    if (normal.allFinite()) planes.push_back({normal, normal.dot(hull.vertices[a])});
  }
  ShapeAnomaly anomaly{ShapeAnomaly::Kind::kHollow, closed.vertices[0], 0.0, fill};
  for (const Vec3& vertex : closed.vertices) {
    const double depth = depth_below(planes, vertex);
    if (depth > anomaly.size) {
      anomaly.size = depth;
      anomaly.position = vertex;
    }
  }
  return anomaly;
}

/// A triangle seen along the way up.
struct PlanPiece {
  double area = 0.0;    ///< in plan, m^2
  double height = 0.0;  ///< over the lowest vertex, m
  double level = 0.0;   ///< z of its unit normal
  Vec3 centre, normal;
};

/// The height that half of the level area lies below.
double median_level_height(const std::vector<PlanPiece>& upper) {
  std::vector<std::array<double, 2>> level;  // height, area
  double whole = 0.0;
  for (const PlanPiece& piece : upper) {
    if (piece.level <= kGroundLevel) continue;
    level.push_back({piece.height, piece.area});
    whole += piece.area;
  }
  std::sort(level.begin(), level.end());
  double below = 0.0;
  for (const auto& [height, area] : level) {
    below += area;
    if (below >= 0.5 * whole) return height;
  }
  return 0.0;
}

/// Ground around a body whose base lies opposite to `up`.
std::optional<ShapeAnomaly> ground_around(const TriangleMesh& closed, const Vec3& up) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& vertex : closed.vertices) {
    lowest = std::min(lowest, up.dot(vertex));
    highest = std::max(highest, up.dot(vertex));
  }
  const double whole = highest - lowest;
  std::vector<PlanPiece> upper;
  double plan = 0.0, base = 0.0, tall_area = 0.0;
  Vec3 tall = Vec3::Zero();
  for (const TriangleMesh::Triangle& t : closed.triangles) {
    const Vec3 area = 0.5 * doubled_area_vector(closed, t);
    if (!(area.norm() > 0.0)) continue;
    const Vec3 centre =
        (closed.vertices[t[0]] + closed.vertices[t[1]] + closed.vertices[t[2]]) / 3.0;
    const double facing = area.dot(up), height = up.dot(centre) - lowest;
    if (facing <= 0.0) {
      if (height < kBaseHeight * whole) base -= facing;
      continue;
    }
    plan += facing;
    upper.push_back({facing, height, facing / area.norm(), centre, area.normalized()});
  }
  const double ground_height = median_level_height(upper);
  const double rises = ground_height + kRises * (whole - ground_height);
  for (const PlanPiece& piece : upper) {
    if (piece.height <= rises) continue;
    tall_area += piece.area;
    tall += piece.area * piece.centre;
  }
  if (!(tall_area > 0.0) || base < kBaseFraction * plan) return std::nullopt;
  tall /= tall_area;
  const Vec3 east = up.unitOrthogonal(), north = up.cross(east);
  std::array<double, kGroundSectors> body{}, ground{};
  double ground_area = 0.0, fall = 0.0;
  for (const PlanPiece& piece : upper) {
    const Vec3 away = piece.centre - tall;
    const double x = east.dot(away), y = north.dot(away), radius = std::hypot(x, y);
    const double circle_fraction = (std::atan2(y, x) + kPi) / (2.0 * kPi);
    const auto sector =
        std::min(kGroundSectors - 1, static_cast<std::size_t>(circle_fraction * kGroundSectors));
    if (piece.height > rises) {
      body[sector] = std::max(body[sector], radius);
    } else if (piece.level > kGroundLevel) {
      ground[sector] = std::max(ground[sector], radius);
      ground_area += piece.area;
      fall += piece.area * (x * east.dot(piece.normal) + y * north.dot(piece.normal)) /
              std::max(radius, 1e-300);
    }
  }
  std::size_t around = 0;
  for (std::size_t i = 0; i < kGroundSectors; ++i)
    around += ground[i] > body[i] + kMinRim * std::sqrt(plan);
  if (whole > kMaxSlabHeight * std::sqrt(plan) || around < kSectorsWithGround ||
      ground_area < kMinGround * plan || fall > kGroundFall * ground_area) {
    return std::nullopt;
  }
  return ShapeAnomaly{ShapeAnomaly::Kind::kSlab, tall, std::sqrt(plan), ground_area / plan};
}

}  // namespace

std::vector<ShapeAnomaly> find_shape_anomalies(const TriangleMesh& closed) {
  const OrientedBox box = smallest_box(closed.vertices);
  const double volume = signed_volume(closed), thickness = 2.0 * volume / surface_area(closed);
  const TriangleMesh hull = convex_hull(closed.vertices);
  const double fill = volume / signed_volume(hull);
  std::vector<ShapeAnomaly> anomalies;
  std::vector<Vec3> ups = {Vec3::UnitZ()};
  for (int axis = 0; axis < 3; ++axis) {
    ups.emplace_back(box.axes.col(axis));
    ups.emplace_back(-box.axes.col(axis));
  }
  std::optional<ShapeAnomaly> slab;
  for (const Vec3& up : ups) {
    const std::optional<ShapeAnomaly> found = ground_around(closed, up);
    if (found && (!slab || found->size > slab->size)) slab = found;
  }
  if (slab) return {*slab};
  if (thickness < kShellThickness * box.lengths[2]) {
    anomalies.push_back({ShapeAnomaly::Kind::kShell, closed.vertices[0], thickness, fill});
    return anomalies;
  }
  if (fill < kHollowFill) anomalies.push_back(hollow_of(closed, hull, fill));
  if (const auto seam = find_body_seam(closed)) {
    anomalies.push_back({ShapeAnomaly::Kind::kSeam, seam->position, seam->width,
                         seam->smaller_fraction, seam->plane});
  }
  return anomalies;
}

std::string format_shape_anomaly(
    const ShapeAnomaly& anomaly,
    const std::function<std::string(const Vec3&)>& format_file_position) {
  const std::string size = format_significant(anomaly.size, 2) + " m",
                    percent = format_significant(100.0 * anomaly.fraction, 2) + " %",
                    near = " near " + format_file_position(anomaly.position);
  switch (anomaly.kind) {
    case ShapeAnomaly::Kind::kShell:
      return "this seems to be a shell " + size + " thick, not like a rock: it fills " + percent +
             " of its convex hull," + near +
             "; if a program thickened an open scan, export the scan without thickness";
    case ShapeAnomaly::Kind::kHollow:
      return "this fills only " + percent + " of its convex hull, with a hollow " + size + " deep" +
             near + ": check that it is one whole rock";
    case ShapeAnomaly::Kind::kSlab:
      return "this seems to be a block with the ground around it, " + size + " across: " + percent +
             " of its plan is level ground around the block" + near +
             "; cut the ground away, or use the scan from before its underside was closed";
    case ShapeAnomaly::Kind::kSeam:
      return "this seems to be two bodies that meet in a seam " + size + " wide" + near +
             ", the smaller with " + percent + " of the volume: check that it is one rock";
  }
  return "";
}

}  // namespace clast::reconstruct_detail
