#pragma once
/// One surface from registered scans.
#include <span>
#include <string>
#include <vector>

#include "reconstruct/cloud/cloud_surface.hpp"
#include "reconstruct/registration/registration.hpp"

namespace clast {

/// Points of a joined scan, in the frame of the block.
struct JoinedPoints {
  std::vector<Vec3> points;  ///< m
  /// Distance of each point above the surface of the other scans, m; NaN where these observed
  /// nothing.
  std::vector<double> distances;
};

/// Surface of registered scans, in the frame of the first, m.
struct JoinedSurface {
  CloudSurface cloud;  ///< its uncertainty includes that of the registration
  std::vector<JoinedPoints> scans;
  std::vector<std::string> notes;
};

/// Reconstructs one surface from the points of all scans. Points at places that another scan
/// contradicts, such as remains of a ground, are left out.
/// @throws InputError, GeometryError  if `fit_cloud_surface` throws
JoinedSurface join_surfaces(const std::vector<ScanToRegister>& scans, const Registration& fit,
                            const CloudSurfaceOptions& options);

}  // namespace clast
