#include "reconstruct/registration/detail/surface_agreement.hpp"

#include <algorithm>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

constexpr double kSimilarNormal = 0.7;  ///< cosine: 45 degrees
constexpr double kFacesAlike = 0.5;     ///< cosine: behind a surface that faces alike is no rock
constexpr double kFacesAgainst = -0.2;  ///< cosine: two surfaces at one place, back to back
constexpr double kBeyondBorder = 1.0;   ///< spacings beyond a border that are unobserved
/// Depth below the ground, relative to the diagonal, at which no part of the block is expected.
constexpr double kDeepest = 0.15;

constexpr double kContradiction = 3.0;  ///< weight of a contradicted point in the score

/// Sums over the points of one surface.
struct AgreementSums {
  double matched = 0.0, contradicted = 0.0, squares = 0.0, score = 0.0;
};

AgreementSums compare_one_way(const IndexedSurface& to, const IndexedSurface& from,
                              const std::vector<std::uint32_t>& points, const Similarity& to_from,
                              double tolerance) {
  AgreementSums sums;
  for (const std::uint32_t i : points) {
    const PointComparison found =
        compare_point(to, to_from * from.surface.points[i],
                      to_from.pose.rotation * from.surface.normals[i], tolerance);
    if (found.relation == PointRelation::kUnobserved) continue;
    const double relative = found.height / tolerance;
    if (found.relation == PointRelation::kMatched) {
      sums.matched += 1.0;
      sums.squares += found.height * found.height;
      sums.score += 1.0 - relative * relative;
    } else {
      sums.contradicted += 1.0;
      sums.score -= kContradiction * std::min(1.0, std::abs(relative * relative - 1.0));
    }
  }
  return sums;
}

}  // namespace

PointComparison compare_point(const IndexedSurface& other, const Vec3& position, const Vec3& normal,
                              double tolerance) {
  const OrientedSurface& surface = other.surface;
  if (surface.ground && surface.ground->signed_distance(position) < -kDeepest * other.diagonal) {
    return {PointRelation::kContradicted, 2.0 * tolerance, 0};
  }
  PointComparison found;
  found.point = other.grid.nearest_point(position);
  const Vec3 offset = position - surface.points[found.point];
  const Vec3& facing = surface.normals[found.point];
  found.height = facing.dot(offset);
  const double alike = facing.dot(normal);
  const double beside =
      std::sqrt(std::max(0.0, offset.squaredNorm() - found.height * found.height));
  if (surface.is_border[found.point] && beside > kBeyondBorder * surface.spacing) return found;
  if (std::abs(found.height) <= tolerance) {
    if (alike > kSimilarNormal) found.relation = PointRelation::kMatched;
    if (alike < kFacesAgainst) {
      found.relation = PointRelation::kContradicted;
      found.height = 2.0 * tolerance;
    }
    return found;
  }
  if (surface.is_border[found.point]) return found;
  const bool in_front = found.height > 0.0;
  if (in_front || alike > kFacesAlike) found.relation = PointRelation::kContradicted;
  return found;
}

SurfaceAgreement compare_surfaces(const IndexedSurface& fixed, const IndexedSurface& moving,
                                  const Similarity& fixed_from_moving, double tolerance,
                                  PointDensity density) {
  const std::vector<std::uint32_t>& of_fixed = fixed.points_at(density);
  const std::vector<std::uint32_t>& of_moving = moving.points_at(density);
  const AgreementSums forth =
      compare_one_way(fixed, moving, of_moving, fixed_from_moving, tolerance);
  const AgreementSums back =
      compare_one_way(moving, fixed, of_fixed, fixed_from_moving.inverse(), tolerance);
  // A point of a subset stands for several points of its surface.
  const auto per_point = [](const IndexedSurface& s, const std::vector<std::uint32_t>& chosen) {
    return static_cast<double>(s.all.size()) / static_cast<double>(chosen.size());
  };
  const double smaller = static_cast<double>(std::min(fixed.all.size(), moving.all.size()));
  const double f = 0.5 * per_point(moving, of_moving) / smaller;
  const double b = 0.5 * per_point(fixed, of_fixed) / smaller;
  SurfaceAgreement agreement;
  agreement.matched = f * forth.matched + b * back.matched;
  agreement.contradicted = f * forth.contradicted + b * back.contradicted;
  agreement.score = f * forth.score + b * back.score;
  const double count = forth.matched + back.matched;
  const double contradicted = forth.contradicted + back.contradicted;
  const double squares = forth.squares + back.squares;
  if (count > 0.0) agreement.deviation = std::sqrt(squares / count);
  if (count + contradicted > 0.0) {
    agreement.misfit = (squares + contradicted * tolerance * tolerance) / (count + contradicted);
  }
  return agreement;
}

}  // namespace clast::reconstruct_detail
