#pragma once
/// Contents of a site map: ground, release positions and barriers.
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "terrain/relief.hpp"

namespace clast {

struct ReleasePosition {
  Vec2 position = Vec2::Zero();  ///< map coordinates, m
  std::uint32_t point = 0;       ///< index of the release point
};

/// Plan outline of a multi-block release.
struct ReleaseOutline {
  std::string name;           ///< name, such as "release of 60 blocks"
  std::vector<Vec2> corners;  ///< convex hull of all starts, map coordinates, m; not closed
};

/// Site map of a comparison, campaign or terrain, in map coordinates. The terrain must outlive it.
struct SiteMap {
  const Terrain* terrain = nullptr;
  PlanWindow window;  ///< drawn part of the plan, m
  /// Lowest height of the contours, m.
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  std::vector<ReleasePosition> release_positions;  ///< release positions, each once
  std::vector<ReleaseOutline> release_outlines;    ///< outlines of simultaneous releases
  std::vector<BarrierLine> barriers;
  bool counts_crossings = true;  ///< true if barriers are drawn with names and arrows

  /// Returns the contour interval, m, which gives about a dozen contours.
  double contour_interval() const;
};

/// Makes the site map of a comparison. The window contains releases, stops, barriers and observed
/// stops. The terrain is that of the first file.
SiteMap make_site_map(const Comparison& comparison);

/// Makes the site map of a campaign, with the whole terrain.
/// @param header  header of a campaign without runs
SiteMap make_site_map(const CampaignHeader& header);

/// Makes the site map of a whole terrain with release points and barrier lines.
/// @param releases, lines  map coordinates, m
/// @throws InputError  if the distance of a point from the terrain exceeds the size of the terrain
SiteMap make_site_map(const Terrain& terrain, std::span<const Vec2> releases,
                      const std::vector<std::vector<Vec2>>& lines);

}  // namespace clast
