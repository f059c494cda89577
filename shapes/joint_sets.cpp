#include "shapes/joint_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/triangle_tree.hpp"

namespace clast {
namespace {

/// Fraction of the mass's diagonal within which points lie on a plane.
constexpr double kMassSlack = 1e-9;
/// Pieces of the surface whose normals are this near to that of the largest are cut off together,
/// degrees. Small angles suit smooth surfaces, large ones rough ones: all are tried.
constexpr std::array<double, 4> kSameDirections = {2.0, 10.0, 25.0, 45.0};
/// Area of the surface inside a cell that is no longer cut off, share of the cell's size squared.
constexpr double kNoArea = 1e-9;
constexpr int kMaxTrims = 60;

/// The planes of a set in the direction of its normal, one more than `most` at most.
std::vector<Plane> planes_of(const JointSet& set, const TriangleMesh& mass, Random& random,
                             std::size_t most) {
  const Vec3 normal = set.normal();
  double low = 1e300, high = -1e300;
  for (const Vec3& vertex : mass.vertices) {
    low = std::min(low, normal.dot(vertex));
    high = std::max(high, normal.dot(vertex));
  }
  // Log-normal with the mean and the standard deviation asked for.
  const double ratio = set.spacing_deviation / set.spacing;
  const double sigma = std::sqrt(std::log1p(ratio * ratio));
  const double mean = std::log(set.spacing) - 0.5 * sigma * sigma;
  const auto distance = [&] {
    return set.spacing_deviation > 0.0 ? std::exp(mean + sigma * random.normal()) : set.spacing;
  };
  std::vector<Plane> planes;
  for (double at = low + random.uniform() * distance(); at < high && planes.size() <= most;
       at += distance()) {
    planes.push_back({normal, at});
  }
  return planes;
}

/// A triangle of the surface, as far as it lies in a cell.
struct Piece {
  std::vector<Vec3> corners;
  Vec3 normal = Vec3::UnitZ();
  double area = 0.0;
};

double polygon_area(const std::vector<Vec3>& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return 0.5 * sum.norm();
}

class Cutting {
 public:
  Cutting(const TriangleMesh& mass, const JointCuttingOptions& options)
      : mass_(mass), options_(options), tree_(mass), slack_(kMassSlack * bounds(mass).diagonal()) {
    for (const TriangleMesh::Triangle& triangle : mass.triangles) {
      Bounds box;
      for (const std::uint32_t vertex : triangle) box.include(mass.vertices[vertex]);
      boxes_.push_back(box);
    }
  }

  std::vector<ConvexCell> cells_between(std::span<const JointSet> sets) const {
    Random random(options_.seed);
    std::vector<ConvexCell> cells = {ConvexCell(bounds(mass_))};
    for (const JointSet& set : sets) {
      const std::vector<Plane> planes = planes_of(set, mass_, random, 10 * options_.max_blocks);
      if (planes.empty()) continue;
      if (planes.size() > 10 * options_.max_blocks) refuse_count();
      std::vector<ConvexCell> parts;
      for (const ConvexCell& cell : cells) {
        add_slices(cell, planes, parts);
        // Some lie in the box around the mass only.
        check_count(parts.size() / 10);
      }
      cells = std::move(parts);
    }
    return cells;
  }

  void check_count(std::size_t count) const {
    if (count > options_.max_blocks) refuse_count();
  }

  [[noreturn]] void refuse_count() const {
    throw InputError(
        "the joint sets cut the mass into more than " + std::to_string(options_.max_blocks) +
        " blocks; use wider spacings or a smaller mass, raise the limit, or check the units");
  }

  /// Returns the largest part of the cell inside the mass; empty if too little is left.
  std::optional<ConvexCell> inside(const ConvexCell& cell) const {
    std::optional<ConvexCell> largest;
    for (const double angle : kSameDirections) {
      std::optional<ConvexCell> part = trimmed(cell, std::cos(angle * kRadiansPerDegree));
      if (part && (!largest || part->volume() > largest->volume())) largest = std::move(part);
    }
    if (!largest || tree_.signed_distance(largest->centre()) >= 0.0) return std::nullopt;
    return largest;
  }

 private:
  /// @param same  least cosine between normals of what is cut off together
  std::optional<ConvexCell> trimmed(std::optional<ConvexCell> cell, double same) const {
    for (int trim = 0; cell && trim < kMaxTrims; ++trim) {
      if (cell->volume() < options_.min_volume) return std::nullopt;
      const std::vector<Piece> pieces = surface_in(*cell);
      if (pieces.empty()) return cell;
      cell = cell->clipped_below(inner_plane(pieces, same), slack_);
    }
    return std::nullopt;
  }

  /// Cuts a cell by parallel planes. @param planes in the direction of their normal
  void add_slices(const ConvexCell& cell, const std::vector<Plane>& planes,
                  std::vector<ConvexCell>& slices) const {
    std::optional<ConvexCell> rest = cell;
    const auto keep = [&](std::optional<ConvexCell> part) {
      if (part && part->volume() >= options_.min_volume) slices.push_back(*std::move(part));
    };
    double low = 1e300, high = -1e300;
    for (const Vec3& vertex : cell.vertices()) {
      low = std::min(low, planes.front().normal.dot(vertex));
      high = std::max(high, planes.front().normal.dot(vertex));
    }
    auto plane = std::lower_bound(planes.begin(), planes.end(), low,
                                  [](const Plane& a, double at) { return a.distance < at; });
    for (; plane != planes.end() && plane->distance < high; ++plane) {
      keep(rest->clipped_below(*plane, slack_));
      check_count(slices.size() / 10);
      rest = rest->clipped_below({-plane->normal, -plane->distance}, slack_);
      if (!rest) return;
    }
    keep(std::move(rest));
  }

  /// The surface of the mass inside a cell, not on its faces.
  std::vector<Piece> surface_in(const ConvexCell& cell) const {
    const Bounds box = cell.box();
    const std::vector<Plane> planes = cell.planes();
    const double size = box.diagonal();
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if ((boxes_[i].high.array() < box.low.array()).any() ||
          (boxes_[i].low.array() > box.high.array()).any()) {
        continue;
      }
      const TriangleMesh::Triangle& triangle = mass_.triangles[i];
      Piece piece{
          {mass_.vertices[triangle[0]], mass_.vertices[triangle[1]], mass_.vertices[triangle[2]]},
          unit_normal(mass_, triangle)};
      for (const Plane& plane : planes) {
        if (piece.corners.size() < 3) break;
        piece.corners =
            clip_polygon_below(piece.corners, {plane.normal, plane.distance - 10.0 * slack_});
      }
      if (piece.corners.size() < 3) continue;
      piece.area = polygon_area(piece.corners);
      if (piece.area > kNoArea * size * size) pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  /// A plane that has the largest piece, and those that face the same way, on its outer side.
  static Plane inner_plane(const std::vector<Piece>& pieces, double same) {
    const Piece& largest =
        *std::max_element(pieces.begin(), pieces.end(),
                          [](const Piece& a, const Piece& b) { return a.area < b.area; });
    Vec3 normal = Vec3::Zero();
    for (const Piece& piece : pieces) {
      if (piece.normal.dot(largest.normal) >= same) normal += piece.area * piece.normal;
    }
    Plane plane{normal.normalized(), 1e300};
    for (const Piece& piece : pieces) {
      if (piece.normal.dot(largest.normal) < same) continue;
      for (const Vec3& corner : piece.corners) {
        plane.distance = std::min(plane.distance, plane.normal.dot(corner));
      }
    }
    return plane;
  }

  const TriangleMesh& mass_;
  const JointCuttingOptions& options_;
  TriangleTree tree_;
  double slack_;
  std::vector<Bounds> boxes_;  ///< of the triangles
};

}  // namespace

Vec3 JointSet::normal() const {
  return {std::sin(dip) * std::sin(dip_direction), std::sin(dip) * std::cos(dip_direction),
          std::cos(dip)};
}

JointSet parse_joint_set(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('/', at), text.size());
    const std::optional<double> number = parse_number(std::string_view(text).substr(at, end - at));
    if (!number) {
      numbers.clear();
      break;
    }
    numbers.push_back(*number);
    at = end + 1;
  }
  if (numbers.size() != 3 && numbers.size() != 4) {
    throw InputError(
        "\"" + text +
        "\" is not a joint set; give DIP/DIP_DIRECTION/SPACING or "
        "DIP/DIP_DIRECTION/SPACING/SCATTER in degrees and metres, such as 65/095/1.2/0.3");
  }
  if (numbers.size() == 3) numbers.push_back(0.0);
  const auto check = [&](std::size_t i, const char* name, double low, double high,
                         const char* unit) {
    if (numbers[i] >= low && numbers[i] <= high) return;
    throw InputError("`joints` " + text + ": " + name + " = " + format_significant(numbers[i], 6) +
                     "; must be from " + format_significant(low, 4) + " to " +
                     format_significant(high, 4) + unit);
  };
  check(0, "dip", 0.0, 90.0, " degrees");
  check(1, "dip direction", 0.0, 360.0, " degrees");
  check(2, "spacing", 1e-3, 1000.0, " m");
  check(3, "scatter", 0.0, 3.0 * numbers[2], " m, three times the spacing");
  return {numbers[0] * kRadiansPerDegree, numbers[1] * kRadiansPerDegree, numbers[2], numbers[3]};
}

JointedRockMass cut_by_joints(const TriangleMesh& on_map, std::span<const JointSet> sets,
                              const JointCuttingOptions& options) {
  if (sets.empty()) throw InputError("no joint set is given; at least one is needed to cut a mass");
  const MeshReport report = inspect_mesh(on_map);
  if (!report.is_closed() || !report.is_oriented()) {
    throw GeometryError("the mass is not a closed surface (" + report.summary() +
                        "); close it, for example by filling its holes in MeshLab");
  }
  if (const std::size_t crossings = find_self_intersections(on_map).size()) {
    throw GeometryError("the surface of the mass crosses itself, " +
                        format_count(crossings, "pair") +
                        " of triangles do; repair it, for example in MeshLab");
  }
  // Map coordinates would cost digits.
  const Vec3 origin = bounds(on_map).low.array().round();
  const TriangleMesh mass = transformed(on_map, Pose{-origin, Quat::Identity()});
  JointedRockMass cut;
  cut.volume = signed_volume(mass);
  if (!(cut.volume > 0.0)) {
    throw GeometryError("the surface of the mass faces inwards; turn its triangles around");
  }
  const Cutting cutting(mass, options);
  for (const ConvexCell& cell : cutting.cells_between(sets)) {
    const std::optional<ConvexCell> inside = cutting.inside(cell);
    std::optional<TriangleMesh> block = inside ? inside->welded_mesh() : std::nullopt;
    if (!block) continue;
    cut.blocks.push_back(*std::move(block));
    cut.block_volume += signed_volume(cut.blocks.back());
    for (Vec3& vertex : cut.blocks.back().vertices) vertex += origin;
    cutting.check_count(cut.blocks.size());
  }
  if (cut.blocks.empty()) {
    throw InputError("no block of " + format_significant(options.min_volume, 3) +
                     " m3 or more fits into the mass of " + format_significant(cut.volume, 3) +
                     " m3; use wider spacings or a smaller least volume");
  }
  return cut;
}

}  // namespace clast
