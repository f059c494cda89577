#pragma once
/// Comparison of two observed surfaces at a given pose.
#include "reconstruct/registration/detail/sampled_surface.hpp"

namespace clast::reconstruct_detail {

/// Relation of a point to another observed surface at a pose.
enum class PointRelation {
  kMatched,       ///< on the other surface, with a similar normal
  kContradicted,  ///< where the other scan saw free space, or rock with another surface
  kUnobserved,    ///< where the other scan observed nothing
};

struct PointComparison {
  PointRelation relation = PointRelation::kUnobserved;
  double height = 0.0;      ///< above the other surface, m
  std::uint32_t point = 0;  ///< nearest point of the other surface
};

/// Compares a point with a surface.
/// @param tolerance  largest height of a matched point, m
/// @param position, normal  in the frame of `other`
PointComparison compare_point(const SampledSurface& other, const Vec3& position, const Vec3& normal,
                              double tolerance);

/// Agreement of two surfaces. Fractions are relative to the smaller surface, each surface counted
/// half.
struct SurfaceAgreement {
  double matched = 0.0;       ///< fraction that lies on the other surface
  double contradicted = 0.0;  ///< fraction at impossible places
  double deviation = 0.0;     ///< root mean square height of matched points, m
  /// Mean square height of matched and contradicted points, those counted with the tolerance, m^2.
  double misfit = 0.0;
  /// Sum of 1 - (h / tolerance)^2 over matched points less the weighted number of contradicted
  /// ones, as a fraction. The weight is 3 for subsets of the points and 10 for all points.
  double score = 0.0;

  /// Fraction of the comparable points that match.
  double consistency() const { return matched > 0.0 ? matched / (matched + contradicted) : 0.0; }
};

SurfaceAgreement compare_surfaces(const SampledSurface& fixed, const SampledSurface& moving,
                                  const Similarity& fixed_from_moving, double tolerance,
                                  PointDensity density);

}  // namespace clast::reconstruct_detail
