#include "reconstruct/underside/detail/flank_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "shapes/convex_hull.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Radius of a patch over the root of the observed area. It is so large that the mean normal is
/// that of the flank, not of a bump. See docs/accuracy.md for other sizes.
constexpr double kPatchRadius = 0.10;
/// The planes lie outside of what was seen by so many times what stands out over tangent planes.
constexpr double kSlack = 1.5;
/// Protrusion at a rim, over the root of the observed area, above which a patch is ignored.
constexpr double kHeldByRim = 0.01;
/// A patch whose triangles face apart has no normal: the share of its area that is left of it.
constexpr double kMinNormal = 0.7;

/// Triangles by the cell that holds their middle.
class Cells {
 public:
  Cells(std::span<const Vec3> middles, double side) : middles_(middles), side_(side) {
    for (std::uint32_t i = 0; i < middles.size(); ++i) entries_.push_back({cell(middles[i]), i});
    std::sort(entries_.begin(), entries_.end());
  }
  /// Calls `visit` with each triangle whose middle is within a side of a place.
  template <class Visit>
  void near(const Vec3& position, const Visit& visit) const {
    const Cell middle = cell(position);
    for (long i = -1; i <= 1; ++i) {
      for (long j = -1; j <= 1; ++j) {
        for (long k = -1; k <= 1; ++k) {
          const Cell wanted = {middle[0] + i, middle[1] + j, middle[2] + k};
          for (auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{wanted, 0});
               at != entries_.end() && at->cell == wanted; ++at) {
            if ((middles_[at->triangle] - position).norm() <= side_) visit(at->triangle);
          }
        }
      }
    }
  }

 private:
  using Cell = std::array<long, 3>;
  struct Entry {
    Cell cell;
    std::uint32_t triangle;
    bool operator<(const Entry& other) const {
      return cell != other.cell ? cell < other.cell : triangle < other.triangle;
    }
  };
  Cell cell(const Vec3& position) const {
    Cell result;
    for (int axis = 0; axis < 3; ++axis)
      result[static_cast<std::size_t>(axis)] = std::lround(std::floor(position[axis] / side_));
    return result;
  }

  std::span<const Vec3> middles_;
  double side_;
  std::vector<Entry> entries_;
};

/// Triangles about a place, as a plane.
struct FlankPatch {
  Vec3 normal = Vec3::Zero();  ///< unit; zero where the triangles face apart
  double area = 0.0;           ///< m^2
  double distance = -1e300;    ///< of the outermost of its vertices along the normal, m
};

double support(std::span<const Vec3> points, const Vec3& normal) {
  double most = -1e300;
  for (const Vec3& p : points) most = std::max(most, normal.dot(p));
  return most;
}

/// Patches that cover the seen surface; neighbours overlap.
std::vector<FlankPatch> patches_of(const TriangleMesh& mesh, std::span<const Vec3> middles,
                                   std::span<const Vec3> areas, double radius) {
  const Cells cells(middles, radius);
  std::vector<std::uint8_t> covered(middles.size(), 0);
  std::vector<FlankPatch> patches;
  for (std::size_t t = 0; t < middles.size(); ++t) {
    if (covered[t] != 0) continue;
    FlankPatch patch;
    std::vector<std::uint32_t> members;
    cells.near(middles[t], [&](std::uint32_t other) {
      covered[other] = 1;
      members.push_back(other);
      patch.normal += areas[other];
      patch.area += areas[other].norm();
    });
    const bool faces_one_way = patch.normal.norm() > kMinNormal * patch.area;
    if (!(patch.area > 0.0) || !faces_one_way) continue;
    patch.normal.normalize();
    for (const std::uint32_t member : members) {
      for (const std::uint32_t v : mesh.triangles[member]) {
        patch.distance = std::max(patch.distance, patch.normal.dot(mesh.vertices[v]));
      }
    }
    patches.push_back(patch);
  }
  return patches;
}

}  // namespace

FlankPlanes fit_flank_planes(const TriangleMesh& closed, std::size_t observed,
                             std::span<const std::uint32_t> rims) {
  std::vector<Vec3> corners, middles, areas, rim_points;
  double whole = 0.0;
  for (std::size_t t = 0; t < observed; ++t) {
    const auto& [a, b, c] = closed.triangles[t];
    const Vec3 &p = closed.vertices[a], &q = closed.vertices[b], &r = closed.vertices[c];
    corners.insert(corners.end(), {p, q, r});
    middles.push_back((p + q + r) / 3.0);
    areas.push_back(0.5 * (q - p).cross(r - p));
    whole += areas.back().norm();
  }
  for (const std::uint32_t v : rims) rim_points.push_back(closed.vertices[v]);
  const std::vector<Vec3> hull = extreme_points(corners);
  const double size = std::sqrt(whole);

  FlankPlanes found;
  double standing_out = 0.0, weights = 0.0;
  for (const FlankPatch& patch : patches_of(closed, middles, areas, kPatchRadius * size)) {
    const double distance = std::max(support(hull, patch.normal), patch.distance);
    const double over = distance - patch.distance;
    standing_out += patch.area * over;
    weights += patch.area;
    const bool held_by_rim =
        over > kHeldByRim * size && support(rim_points, patch.normal) >= distance - 1e-9 * size;
    if (!held_by_rim) found.planes.push_back({patch.normal, distance});
  }
  if (weights > 0.0) found.outward_offset = kSlack * standing_out / weights;
  for (Plane& plane : found.planes) plane.distance += found.outward_offset;
  return found;
}

}  // namespace clast::reconstruct_detail
