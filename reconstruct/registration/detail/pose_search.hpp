#pragma once
/// Search for all poses at which two observed surfaces may fit.
#include <vector>

#include "reconstruct/registration/detail/joint_refinement.hpp"
#include "reconstruct/registration/detail/surface_agreement.hpp"

namespace clast::reconstruct_detail {

/// A refined pose and the agreement of the surfaces at it.
struct PoseCandidate {
  Similarity fixed_from_moving;
  SurfaceAgreement agreement;
  /// Movements along which the surfaces can slide; see `Refinement`.
  std::vector<PoseStep> free_movements;
};

/// Largest height (m) of a point of one surface above the other that their noise explains.
double fine_tolerance(const OrientedSurface& a, const OrientedSurface& b, double diagonal);

/// True if two poses move no part of a surface apart by more than `distance` (m).
/// @param radius  of the surface about the middle `centre`, m
bool are_near(const Similarity& a, const Similarity& b, const Vec3& centre, double radius,
              double distance);

/// Refines a pose that is right within a few percent of the size of the surfaces.
PoseCandidate refine_near_pose(const SampledSurface& fixed, const SampledSurface& moving,
                               const Similarity& fixed_from_moving);

/// Searches all poses (`search_rotations`), refines the best and returns them with the highest
/// score first.
/// @param threads  number of threads; does not affect the result
std::vector<PoseCandidate> search_poses(const SampledSurface& fixed, const SampledSurface& moving,
                                        unsigned threads);

}  // namespace clast::reconstruct_detail
