#pragma once
/// Where runs start, as maps show it.
#include <cstdint>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// A place that single blocks start from.
struct ReleasePlace {
  Vec2 place = Vec2::Zero();  ///< map, m
  std::uint32_t point = 0;    ///< number of the release point
};

/// The plan outline of a multi-block release.
struct ReleaseOutline {
  std::string name;           ///< "release of 60 blocks"
  std::vector<Vec2> corners;  ///< of the convex hull of all starts, map, m; not closed
};

struct ReleasePlaces {
  std::vector<ReleasePlace> places;      ///< each once
  std::vector<ReleaseOutline> outlines;  ///< by file, then mass
};

/// Blocks that are released together have one outline over all realisations instead of a place
/// each; those on one line have their places.
ReleasePlaces release_places(const Comparison& comparison);

}  // namespace clast::report_detail
