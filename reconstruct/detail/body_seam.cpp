#include "reconstruct/detail/body_seam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "shapes/convex_hull.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr int kSeamDirections = 400;  ///< normals of planes, over half a sphere
constexpr int kSlices = 40;           ///< planes of each normal
/// Area of the section, against the largest on the side that has less, above which it is no neck.
constexpr double kWidestNeck = 0.85;
/// A part with less of the volume than this is no second body.
constexpr double kMinPart = 0.004;
constexpr double kSamePart = 0.02;       ///< of the volume: planes that differ by less are alike
constexpr std::size_t kTriedNecks = 12;  ///< of different normals, the narrowest first
constexpr double kFirstTurn = 0.1, kLastTurn = 0.02, kWidestTurn = 0.25;  ///< of a normal, rad
/// Sum of the sines by which the surfaces on both sides of a seam face each other.
constexpr double kFacing = 0.5;
/// The surfaces are looked at within this share of the cube root of the smaller part's volume.
constexpr double kSeamReach = 0.2;
constexpr int kSeamRefinements = 10;  ///< planes between two slices
constexpr std::size_t kOutlineSamples = 72;

/// Limits within which a neck is a seam. Single rocks of the test data have a hull gain of at most
/// 0.31, and that at a ratio of 0.7.
struct SeamRule {
  double widest_neck;      ///< area of the section over the largest on the side that has less
  double least_hull_gain;  ///< volume of the hull of the whole beyond those of the parts, over that
                           ///< of the smaller part's hull
  double concave_outline;  ///< share of the outline along which the surface is concave
};
/// A very narrow neck, or parts that are far from one convex body, are a seam whatever the outline:
/// bodies can touch in several places, with gaps between them that were not scanned.
constexpr std::array<SeamRule, 3> kSeamRules = {
    {{kWidestNeck, 1.0, 0.0}, {0.6, 0.25, 0.7}, {0.4, 0.5, 0.0}}};

bool is_seam(double ratio, double hull_gain, double concave_outline) {
  return std::any_of(kSeamRules.begin(), kSeamRules.end(), [&](const SeamRule& rule) {
    return ratio < rule.widest_neck && hull_gain > rule.least_hull_gain &&
           concave_outline >= rule.concave_outline;
  });
}

/// Evenly over the upper half of the sphere, along a spiral.
Vec3 half_sphere_direction(int i, int count) {
  const double z = (i + 0.5) / count, around = i * kPi * (3.0 - std::sqrt(5.0));
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

/// A piece of the outline of a section.
struct OutlinePiece {
  Vec3 from, to;
};

/// Intersects a triangle with a plane, given the heights of its corners above it. The piece runs
/// from the rising to the falling side.
std::optional<OutlinePiece> cut_triangle(const std::array<Vec3, 3>& corner,
                                         const std::array<double, 3>& height) {
  OutlinePiece piece;
  int found = 0;
  for (int k = 0; k < 3; ++k) {
    const double a = height[k], b = height[(k + 1) % 3];
    if ((a < 0.0) == (b < 0.0)) continue;
    (a < 0.0 ? piece.from : piece.to) = corner[k] + a / (a - b) * (corner[(k + 1) % 3] - corner[k]);
    ++found;
  }
  if (found != 2) return std::nullopt;
  return piece;
}

/// A plane that may divide the body.
struct Neck {
  Vec3 normal = Vec3::UnitZ();
  double height = 0.0, step = 0.0;  ///< along the normal; to the next plane
  double ratio = 1.0, area = 0.0, smaller_fraction = 0.0;
  bool smaller_above = true;
};

class SeamSearch {
 public:
  explicit SeamSearch(const TriangleMesh& closed) : mesh_(closed) {
    const Bounds box = bounds(closed);
    const Vec3 middle = 0.5 * (box.low + box.high);
    for (Vec3& vertex : mesh_.vertices) vertex -= middle;
    middle_ = middle;
  }

  std::optional<BodySeam> run() const {
    std::vector<Neck> necks;
    for (int i = 0; i < kSeamDirections; ++i) {
      if (const auto neck = narrowest(half_sphere_direction(i, kSeamDirections))) {
        necks.push_back(*neck);
      }
    }
    std::stable_sort(necks.begin(), necks.end(),
                     [](const Neck& a, const Neck& b) { return a.ratio < b.ratio; });
    std::vector<Neck> tried;
    std::optional<BodySeam> best;
    for (Neck neck : necks) {
      if (tried.size() == kTriedNecks) break;
      if (std::any_of(tried.begin(), tried.end(),
                      [&](const Neck& other) { return is_beside(neck, other); })) {
        continue;
      }
      optimise_orientation(neck);
      tried.push_back(neck);
      refine(neck);
      if (best && neck.ratio >= best->ratio) continue;
      const std::vector<OutlinePiece> outline = outline_at(neck);
      const double gain = hull_gain(neck, outline);
      if (!is_seam(neck.ratio, gain, concave_fraction(neck, outline))) continue;
      const Vec3 towards = neck.smaller_above ? neck.normal : Vec3(-neck.normal);
      const double height = neck.smaller_above ? neck.height : -neck.height;
      best = {middle_ + centroid(outline),
              std::sqrt(neck.area),
              neck.smaller_fraction,
              neck.ratio,
              {towards, height + towards.dot(middle_)}};
    }
    return best;
  }

 private:
  std::optional<Neck> narrowest(const Vec3& normal) const {
    std::vector<double> heights;
    for (const Vec3& vertex : mesh_.vertices) heights.push_back(normal.dot(vertex));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const double first = *low, step = (*high - *low) / (kSlices + 1);
    std::array<double, kSlices> areas{};
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      const std::array<double, 3> at = {heights[t[0]], heights[t[1]], heights[t[2]]};
      const auto [below, above] = std::minmax({at[0], at[1], at[2]});
      const int begin = std::max(0, static_cast<int>(std::floor((below - first) / step)) - 1);
      for (int k = begin; k < kSlices && first + (k + 1) * step <= above; ++k) {
        const double level = first + (k + 1) * step;
        if (const auto piece =
                cut_triangle({mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]},
                             {at[0] - level, at[1] - level, at[2] - level})) {
          areas[static_cast<std::size_t>(k)] += 0.5 * normal.dot(piece->from.cross(piece->to));
        }
      }
    }
    double whole = 0.0;
    for (double& area : areas) whole += (area = std::abs(area));
    Neck best{.normal = normal, .step = step, .ratio = kWidestNeck};
    double below = 0.0, largest_below = 0.0;
    for (std::size_t k = 0; k < kSlices; ++k) {
      const double largest_above =
          *std::max_element(areas.begin() + static_cast<long>(k), areas.end());
      const double smaller = std::min(below, whole - below) / whole;
      const double ratio = areas[k] / std::min(largest_below, largest_above);
      if (smaller >= kMinPart && ratio < best.ratio) {
        best = {normal,
                first + static_cast<double>(k + 1) * step,
                step,
                ratio,
                areas[k],
                smaller,
                below > whole - below};
      }
      below += areas[k];
      largest_below = std::max(largest_below, areas[k]);
    }
    if (!(best.area > 0.0)) return std::nullopt;
    return best;
  }

  /// True for planes that the turns of one of them reach, at about the same place.
  static bool is_beside(const Neck& neck, const Neck& other) {
    return std::abs(neck.normal.dot(other.normal)) > std::cos(2.0 * kWidestTurn) &&
           std::abs(neck.smaller_fraction - other.smaller_fraction) < kSamePart;
  }

  /// Turns the plane to where the section is narrowest against the body on both sides.
  void optimise_orientation(Neck& neck) const {
    const Vec3 first = neck.normal;
    for (double angle = kFirstTurn; angle > kLastTurn; angle *= 0.5) {
      for (bool turned = true; turned;) {
        turned = false;
        const Vec3 across = neck.normal.unitOrthogonal(), along = neck.normal.cross(across);
        for (const Vec3& side : {across, Vec3(-across), along, Vec3(-along)}) {
          const Vec3 normal = (neck.normal + std::tan(angle) * side).normalized();
          if (first.dot(normal) < std::cos(kWidestTurn)) continue;
          const auto tried = narrowest(normal);
          if (!tried || tried->ratio >= neck.ratio) continue;
          neck = *tried;
          turned = true;
          break;
        }
      }
    }
  }

  /// Moves the plane to where the section is least between the slices beside it.
  void refine(Neck& neck) const {
    const Neck coarse = neck;
    for (int k = 1 - kSeamRefinements; k < kSeamRefinements; ++k) {
      Neck tried = coarse;
      tried.height += coarse.step * k / kSeamRefinements;
      double area = 0.0;
      for (const OutlinePiece& piece : outline_at(tried)) {
        area += 0.5 * tried.normal.dot(piece.from.cross(piece.to));
      }
      tried.area = std::abs(area);
      if (tried.area > 0.0 && tried.area < neck.area) neck = tried;
    }
  }

  std::vector<OutlinePiece> outline_at(const Neck& neck) const {
    std::vector<OutlinePiece> pieces;
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      std::array<Vec3, 3> corner;
      std::array<double, 3> height{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = mesh_.vertices[t[k]];
        height[k] = neck.normal.dot(corner[k]) - neck.height;
      }
      if (const auto piece = cut_triangle(corner, height)) pieces.push_back(*piece);
    }
    return pieces;
  }

  static Vec3 centroid(const std::vector<OutlinePiece>& outline) {
    Vec3 sum = Vec3::Zero();
    double length = 0.0;
    for (const OutlinePiece& piece : outline) {
      const double side = (piece.to - piece.from).norm();
      sum += 0.5 * side * (piece.from + piece.to);
      length += side;
    }
    return sum / length;
  }

  /// Places along the outline, evenly by length.
  static std::vector<Vec3> samples_of(const std::vector<OutlinePiece>& outline) {
    double length = 0.0;
    for (const OutlinePiece& piece : outline) length += (piece.to - piece.from).norm();
    std::vector<Vec3> samples;
    double walked = 0.0;
    const double spacing = length / static_cast<double>(kOutlineSamples);
    for (const OutlinePiece& piece : outline) {
      walked += (piece.to - piece.from).norm();
      for (; walked > (static_cast<double>(samples.size()) + 0.5) * spacing;) {
        samples.push_back(0.5 * (piece.from + piece.to));
      }
    }
    return samples;
  }

  /// A part of a triangle, short against the distance within which surfaces are looked at.
  struct SurfacePiece {
    Vec3 centre, area;
    bool above;  ///< the plane
  };

  /// Adds the parts of a triangle that are near the plane.
  static void collect_pieces(const std::array<Vec3, 3>& corner, const Neck& neck, double reach,
                             std::vector<SurfacePiece>& pieces) {
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = neck.normal.dot(corner[k]) - neck.height;
    const auto [lowest, highest] = std::minmax_element(height.begin(), height.end());
    if (*lowest > reach || *highest < -reach) return;
    std::size_t longest = 0;
    double length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = (corner[(k + 1) % 3] - corner[k]).norm();
      if (side > length) {
        length = side;
        longest = k;
      }
    }
    if (length < 0.5 * reach) {
      const Vec3 centre = (corner[0] + corner[1] + corner[2]) / 3.0;
      pieces.push_back({centre, (corner[1] - corner[0]).cross(corner[2] - corner[0]),
                        neck.normal.dot(centre) > neck.height});
      return;
    }
    const Vec3 &a = corner[longest], &b = corner[(longest + 1) % 3], &c = corner[(longest + 2) % 3];
    const Vec3 middle = 0.5 * (a + b);
    collect_pieces({a, middle, c}, neck, reach, pieces);
    collect_pieces({middle, b, c}, neck, reach, pieces);
  }

  double concave_fraction(const Neck& neck, const std::vector<OutlinePiece>& outline) const {
    const double volume = std::abs(signed_volume(mesh_));
    const double reach = kSeamReach * std::cbrt(neck.smaller_fraction * volume);
    std::vector<SurfacePiece> near;
    for (const auto& [a, b, c] : mesh_.triangles) {
      const std::vector<Vec3>& at = mesh_.vertices;
      collect_pieces({at[a], at[b], at[c]}, neck, reach, near);
    }
    const std::vector<Vec3> samples = samples_of(outline);
    std::size_t concave = 0;
    for (const Vec3& sample : samples) {
      Vec3 above = Vec3::Zero(), below = Vec3::Zero();
      for (const SurfacePiece& piece : near) {
        if ((piece.centre - sample).squaredNorm() > reach * reach) continue;
        (piece.above ? above : below) += piece.area;
      }
      if (!(above.norm() > 0.0 && below.norm() > 0.0)) continue;
      concave += neck.normal.dot(below.normalized() - above.normalized()) > kFacing;
    }
    return samples.empty() ? 0.0
                           : static_cast<double>(concave) / static_cast<double>(samples.size());
  }

  double hull_gain(const Neck& neck, const std::vector<OutlinePiece>& outline) const {
    std::vector<Vec3> above, below;
    for (const OutlinePiece& piece : outline) above.push_back(piece.from);
    below = above;
    for (const Vec3& vertex : mesh_.vertices) {
      (neck.normal.dot(vertex) > neck.height ? above : below).push_back(vertex);
    }
    const auto hull_volume = [](const std::vector<Vec3>& points) {
      return signed_volume(convex_hull(points));
    };
    const double one = hull_volume(above), other = hull_volume(below);
    return (hull_volume(mesh_.vertices) - one - other) / std::min(one, other);
  }

  TriangleMesh mesh_;
  Vec3 middle_ = Vec3::Zero();
};

}  // namespace

std::optional<BodySeam> find_body_seam(const TriangleMesh& closed) {
  return SeamSearch(closed).run();
}

}  // namespace clast::reconstruct_detail
