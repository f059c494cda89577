#pragma once
/// Summary of a photo scan, for the page and the JSON file of a block.
#include <array>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/camera_ring.hpp"
#include "reconstruct/photos/surface_views.hpp"

namespace clast {

/// Fractions of the closed surface that are seen by at least `min_views` photos, or by at least
/// `min_views` stereo pairs.
struct ViewCoverage {
  std::uint16_t min_views = 0;
  double photos = 0.0, pairs = 0.0;
};

/// Values of `ViewCoverage::min_views`. One stereo pair suffices for a depth; a point of the dense
/// cloud needs three agreeing pairs.
inline constexpr std::array<std::uint16_t, 5> kCoverageSteps = {1, 2, 3, 5, 10};

struct MarkerUsage {
  int id = 0;
  std::size_t photos = 0;
  double error = 0.0;  ///< reprojection error, px; 0 if not located
  double side = 0.0;   ///< side length in the model, m; 0 if not located
  bool used = false;   ///< true if used for the scale
  std::string reason;  ///< reason why it was not used; empty if it was used
};

struct PhotoSummary {
  CameraRing ring;
  SurfaceViews views;  ///< number of views of each triangle of the closed scan
  std::vector<ViewCoverage> coverage;
  std::vector<MarkerUsage> markers;  ///< ordered by id
};

/// Summarises cameras, surface coverage and markers of a photo scan.
/// @param up  value of `ScanOptions::up` used for the block
PhotoSummary summarise_photos(const PhotoScan& scan, const FieldBlock& block,
                              const std::string& up);

}  // namespace clast
