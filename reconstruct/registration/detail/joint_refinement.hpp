#pragma once
/// Joint refinement of the poses of several observed surfaces.
#include <Eigen/Core>
#include <span>
#include <vector>

#include "reconstruct/registration/detail/sampled_surface.hpp"

namespace clast::reconstruct_detail {

struct RefinementOptions {
  double tolerance = 0.0;  ///< heights beyond which points do not count, m
  int iterations = 10;
  PointDensity density = PointDensity::kAll;
  std::vector<bool> free_scale = {};  ///< surfaces with unknown scale; empty: none
};

/// Small change of a similarity: a rotation vector about the origin (rad), a translation (m) and a
/// logarithm of the scale about the surface's own origin.
using PoseStep = Eigen::Matrix<double, 7, 1>;

/// Returns a similarity after a step.
Similarity moved_by_step(const Similarity& before, const PoseStep& step);

struct Refinement {
  std::vector<Similarity> first_from;  ///< pose of each surface in the frame of the first
  /// Covariance of rotation (rad), translation (m) and logarithm of scale of all surfaces but the
  /// first, seven rows each, about the origin of the first; rows of fixed scales are zero. Computed
  /// from the noise of the scans, with one independent height per `kCellsPerPlane` points.
  Eigen::MatrixXd covariance;
  double deviation = 0.0;  ///< weighted root mean square height, m
  /// Movements along which the last surface can slide: they hardly change any height. Each moves it
  /// by at most about one metre. Empty if its pose is determined.
  std::vector<PoseStep> free_movements;
};

/// Minimises heights of points above the surfaces of the others, with the weights of Tukey. Heights
/// are along the sum of both normals.
/// @param surfaces  at least two; not null
/// @param first_from  initial poses; that of the first is the identity and does not change
/// @cite rusinkiewicz2019
Refinement refine_jointly(std::span<const SampledSurface* const> surfaces,
                          std::vector<Similarity> first_from, const RefinementOptions& options);

}  // namespace clast::reconstruct_detail
