#pragma once
/// What a calibration needs to know of a simulated release.
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// A release at a barrier of its site; all not a number where it did not pass.
struct OutcomeAtBarrier {
  double speed = std::numeric_limits<double>::quiet_NaN();   ///< m/s
  double spin = std::numeric_limits<double>::quiet_NaN();    ///< rad/s
  double height = std::numeric_limits<double>::quiet_NaN();  ///< of the centre above ground, m
  double energy = std::numeric_limits<double>::quiet_NaN();  ///< translational and rotational, J

  bool passed() const { return speed == speed; }
};

/// Where a release went.
struct ReleaseOutcome {
  std::uint32_t block = 0;  ///< index into the blocks of its site
  std::uint32_t point = 0;  ///< release point: releases of one share its ground
  Vec2 start = Vec2::Zero();
  /// Where it came to rest, left the terrain or was at the end of the time, map, m.
  Vec2 stop = Vec2::Zero();
  std::vector<OutcomeAtBarrier> barriers;  ///< in the order of the site's campaign
};

/// What observations can ask of the simulations of a site.
struct SiteFacts {
  std::string name;
  std::vector<std::string> blocks;    ///< ids
  std::vector<std::string> shapes;    ///< of each block, compact or elongated
  std::vector<std::string> barriers;  ///< names
  Vec2 downslope = Vec2::UnitX();     ///< unit
  Vec2 middle_of_starts = Vec2::Zero();
};

/// Simulates the releases of one member of the design at a site.
/// @param values  of the unknowns, in their order and units
using MemberSimulator = std::function<std::vector<ReleaseOutcome>(
    std::size_t site, std::uint32_t member, const std::vector<double>& values)>;

}  // namespace clast
