#pragma once
/// What a calibration needs to know of a simulated release.
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// An instant of a release that can be observed, besides its end and its passages of barriers.
struct Moment {
  enum class Kind {
    kImpact,  ///< the end of an impact, as `Impact` defines it
    kTime,    ///< so long after the release
  };
  Kind kind = Kind::kImpact;
  double value = 1.0;  ///< number of the impact, from 1; or the time, s

  std::string name() const;  ///< "impact 1", "0.5 s"
  auto operator<=>(const Moment&) const = default;
};

/// A release at a barrier of its site, or at a moment; all not a number where it did not pass, or
/// had no such impact. A run that is over counts with its end at every later time.
struct OutcomeAtMoment {
  double speed = std::numeric_limits<double>::quiet_NaN();   ///< m/s
  double spin = std::numeric_limits<double>::quiet_NaN();    ///< rad/s
  double height = std::numeric_limits<double>::quiet_NaN();  ///< of the centre above ground, m
  double energy = std::numeric_limits<double>::quiet_NaN();  ///< translational and rotational, J
  double depth = std::numeric_limits<double>::quiet_NaN();   ///< largest overlap of an impact, m
  Vec2 place = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());  ///< at a time, map, m

  bool passed() const { return speed == speed; }
};

/// Where a release went.
struct ReleaseOutcome {
  std::uint32_t block = 0;  ///< index into the blocks of its site
  std::uint32_t point = 0;  ///< release point: releases of one share its ground
  Vec2 start = Vec2::Zero();
  /// Where it came to rest, left the terrain or was at the end of the time, map, m.
  Vec2 stop = Vec2::Zero();
  std::vector<OutcomeAtMoment> barriers;  ///< in the order of the site's campaign
  std::uint32_t release = 0;        ///< release set: index into the releases of its site
  std::vector<OutcomeAtMoment> moments;   ///< in the order of the site's
};

/// What observations can ask of the simulations of a site.
struct SiteDescription {
  std::string name;
  std::vector<std::string> blocks;    ///< ids
  std::vector<std::string> shapes;    ///< of each block, compact or elongated
  std::vector<std::string> barriers;  ///< names
  Vec2 downslope = Vec2::UnitX();     ///< unit
  Vec2 middle_of_starts = Vec2::Zero();
  std::vector<std::string> releases = {};  ///< names of the release sets; "" of the only one
  std::vector<Moment> moments = {};        ///< that are observed, each once, rising
};

/// Simulates the releases of one member of the design at a site.
/// @param values  of the unknowns, in their order and units
using MemberSimulator = std::function<std::vector<ReleaseOutcome>(
    std::size_t site, std::uint32_t member, const std::vector<double>& values)>;

}  // namespace clast
