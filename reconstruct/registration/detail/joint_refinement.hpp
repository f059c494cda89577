#pragma once
/// Joint refinement of the poses of several observed surfaces.
#include <Eigen/Core>
#include <span>
#include <vector>

#include "reconstruct/registration/detail/indexed_surface.hpp"

namespace clast::reconstruct_detail {

struct RefinementOptions {
  double tolerance = 0.0;  ///< heights beyond which points do not count, m
  int iterations = 10;
  PointDensity density = PointDensity::kAll;
  std::vector<bool> free_scale = {};  ///< surfaces with unknown scale; empty: none
};

struct Refinement {
  std::vector<Similarity> first_from;  ///< pose of each surface in the frame of the first
  /// Covariance of rotation (rad), translation (m) and logarithm of scale of all surfaces but the
  /// first, seven rows each, about the origin of the first; rows of fixed scales are zero. Computed
  /// for independent points with the noise of their scans.
  Eigen::MatrixXd covariance;
  double deviation = 0.0;       ///< weighted root mean square height, m
  bool is_constrained = false;  ///< false if the surfaces can slide along each other
};

/// Minimises heights of points above the surfaces of the others, with the weights of Tukey. Heights
/// are along the sum of both normals.
/// @param surfaces  at least two; not null
/// @param first_from  initial poses; that of the first is the identity and does not change
/// @cite rusinkiewicz2019
Refinement refine_jointly(std::span<const IndexedSurface* const> surfaces,
                          std::vector<Similarity> first_from, const RefinementOptions& options);

}  // namespace clast::reconstruct_detail
