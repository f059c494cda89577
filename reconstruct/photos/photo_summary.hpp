#pragma once
/// What the photos of a block show of it, for its page and its JSON.
#include <array>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/camera_ring.hpp"
#include "reconstruct/photos/surface_views.hpp"

namespace clast {

/// Share of the closed surface that at least so many photos, or pairs, see.
struct ViewCoverage {
  std::uint16_t min_views = 0;
  double photos = 0.0, pairs = 0.0;
};

/// Limits of the coverages: one pair gives a depth, three that agree a point.
inline constexpr std::array<std::uint16_t, 5> kCoverageSteps = {1, 2, 3, 5, 10};

/// What became of a marker.
struct MarkerUsage {
  int id = 0;
  std::size_t photos = 0;
  double error = 0.0;  ///< px; 0 where its place is not known
  double side = 0.0;   ///< m, by the model; 0 where its place is not known
  bool used = false;   ///< for the scale
  std::string reason;  ///< it was not used; empty where it was
};

struct PhotoSummary {
  CameraRing ring;
  SurfaceViews views;  ///< of the triangles of the closed scan
  std::vector<ViewCoverage> coverage;
  std::vector<MarkerUsage> markers;  ///< in order of ids
};

/// @param up  as `ScanOptions::up` was when the block was made
PhotoSummary summarise_photos(const PhotoScan& scan, const FieldBlock& block,
                              const std::string& up);

}  // namespace clast
