#pragma once
/// Measures of how well a scan fits others at its pose.
#include "reconstruct/registration/detail/scan_group.hpp"

namespace clast::reconstruct_detail {

/// Distances of a surface from others that exceed the noise.
struct Disagreement {
  double overlap = 0.0;   ///< fraction of the surface that the others observed
  double fraction = 0.0;  ///< fraction of the overlap that lies off the other surfaces
  double distance = 0.0;  ///< root mean square distance of that part, m
};

/// Measures a surface against a group.
Disagreement measure_disagreement(const ScanGroup& group, const PlacedSurface& surface);

/// Scale at which a surface fits a group best.
struct ScaleEstimate {
  double scale = 1.0;  ///< factor of the lengths of the surface
  double standard_error = 0.0;
  SurfaceAgreement agreement;     ///< at that scale
  Similarity first_from_surface;  ///< pose in the frame of the first surface of the group
};

/// Standard error of a scale due to noise and to the smoothing of both surfaces.
/// @param variance  variance of the logarithm of the scale due to noise
double scale_error(double scale, double variance);

ScaleEstimate estimate_scale(const ScanGroup& group, const PlacedSurface& surface);

}  // namespace clast::reconstruct_detail
