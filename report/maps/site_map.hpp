#pragma once
/// What the maps of a site show: its ground, and where blocks start and are counted.
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"
#include "terrain/relief.hpp"

namespace clast {

/// A location that single blocks start from.
struct ReleasePosition {
  Vec2 place = Vec2::Zero();  ///< map, m
  std::uint32_t point = 0;    ///< number of the release point
};

/// The plan outline of a multi-block release.
struct ReleaseOutline {
  std::string name;           ///< "release of 60 blocks"
  std::vector<Vec2> corners;  ///< of the convex hull of all starts, map, m; not closed
};

/// The site of a comparison, of a campaign or of a terrain, in map coordinates. Refers to the
/// terrain that it was made of.
struct SiteMap {
  const Terrain* terrain = nullptr;
  PlanWindow window;  ///< the part of the plan that is drawn, m
  /// Heights over which contours are spaced, m.
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  std::vector<ReleasePosition> places;      ///< each once
  std::vector<ReleaseOutline> outlines;  ///< by file, then mass
  std::vector<BarrierLine> barriers;
  bool counts_crossings = true;  ///< of `barriers`; else they are lines alone, without a name

  /// Metres between contours: about a dozen over the heights.
  double contour_interval() const;
};

/// The site of runs: the window holds releases, stops, barriers and measured stops, and contours
/// are spaced over the heights that the runs pass. Blocks that are released together have one
/// outline over all realisations instead of a place each; those on one line have their places. The
/// terrain is that of the first file.
SiteMap make_site_map(const Comparison& comparison);

/// The site of a campaign: the window holds the whole terrain.
/// @param header  of a campaign without runs
SiteMap make_site_map(const CampaignHeader& header);

/// The site of a terrain, all of it, with release points and barrier lines.
/// @param releases, lines  map, m
/// @throws InputError  a mark farther off the ground than the ground is large
SiteMap make_site_map(const Terrain& terrain, std::span<const Vec2> releases,
                 const std::vector<std::vector<Vec2>>& lines);

}  // namespace clast
