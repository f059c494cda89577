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

/// Weight of a contradicted point in the score, in comparisons of few points and of all. Poses are
/// coarse in the former, so that points are contradicted at the true pose too.
constexpr double kCoarseContradiction = 3.0, kContradiction = 10.0;

/// Sums over the points of one surface.
struct AgreementSums {
  double matched = 0.0, contradicted = 0.0, squares = 0.0, score = 0.0;
};

/// Compares a position with the surface near `point`.
PointComparison compare_at(const SampledSurface& other, const Vec3& position, const Vec3& normal,
                           double tolerance, std::uint32_t point) {
  const OrientedSurface& surface = other.surface;
  if (surface.ground && surface.ground->signed_distance(position) < -kDeepest * other.diagonal) {
    return {PointRelation::kContradicted, 2.0 * tolerance, 0};
  }
  PointComparison found;
  found.point = point;
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

AgreementSums compare_one_way(const SampledSurface& to, const SampledSurface& from,
                              PointDensity density, const Similarity& to_from, double tolerance) {
  const Mat3 rotation = to_from.pose.rotation.toRotationMatrix();
  const Mat3 scaled_rotation = to_from.scale * rotation;
  const double penalty = density == PointDensity::kAll ? kContradiction : kCoarseContradiction;
  AgreementSums sums;
  for (const std::uint32_t i : from.points_at(density)) {
    const Vec3 position = scaled_rotation * from.surface.points[i] + to_from.pose.translation;
    const std::uint32_t other = density == PointDensity::kFew ? to.grid.near_point(position)
                                                              : to.grid.nearest_point(position);
    const PointComparison found =
        compare_at(to, position, rotation * from.surface.normals[i], tolerance, other);
    if (found.relation == PointRelation::kUnobserved) continue;
    const double relative = found.height / tolerance;
    if (found.relation == PointRelation::kMatched) {
      sums.matched += 1.0;
      sums.squares += found.height * found.height;
      sums.score += 1.0 - relative * relative;
    } else {
      sums.contradicted += 1.0;
      sums.score -= penalty * std::min(1.0, std::abs(relative * relative - 1.0));
    }
  }
  return sums;
}

}  // namespace

PointComparison compare_point(const SampledSurface& other, const Vec3& position, const Vec3& normal,
                              double tolerance) {
  return compare_at(other, position, normal, tolerance, other.grid.nearest_point(position));
}

SurfaceAgreement compare_surfaces(const SampledSurface& fixed, const SampledSurface& moving,
                                  const Similarity& fixed_from_moving, double tolerance,
                                  PointDensity density) {
  const std::vector<std::uint32_t>& of_fixed = fixed.points_at(density);
  const std::vector<std::uint32_t>& of_moving = moving.points_at(density);
  const AgreementSums forth = compare_one_way(fixed, moving, density, fixed_from_moving, tolerance);
  const AgreementSums back =
      compare_one_way(moving, fixed, density, fixed_from_moving.inverse(), tolerance);
  // A point of a subset stands for several points of its surface.
  const auto per_point = [](const SampledSurface& s, const std::vector<std::uint32_t>& chosen) {
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
