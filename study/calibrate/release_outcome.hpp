#pragma once
/// Outcome of a simulated release, as used by calibrations.
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Moment at which the state of a released block is observed: after an impact, or at a time after
/// the release.
struct ObservedMoment {
  enum class Kind {
    kImpact,  ///< end of an impact on the ground
    kTime,    ///< time after the release
  };
  Kind kind = Kind::kImpact;
  double value = 1.0;  ///< number of the impact, from 1, or time, s

  std::string name() const;  ///< name of the moment, such as "impact 1" or "0.5 s"
  auto operator<=>(const ObservedMoment&) const = default;
};

/// State of a block at a barrier, after an impact, or at a time. Values are NaN if the block did
/// not pass the barrier or had no such impact.
struct OutcomeAtMoment {
  double speed = std::numeric_limits<double>::quiet_NaN();  ///< speed of the centre of mass, m/s
  double spin = std::numeric_limits<double>::quiet_NaN();   ///< angular speed, rad/s
  /// Height of the centre of mass above the ground, m.
  double height = std::numeric_limits<double>::quiet_NaN();
  /// Kinetic energy of translation and rotation, J.
  double energy = std::numeric_limits<double>::quiet_NaN();
  double depth = std::numeric_limits<double>::quiet_NaN();  ///< largest overlap of an impact, m
  /// Position at a time, map coordinates, m.
  Vec2 position = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());

  bool passed() const { return speed == speed; }
};

struct ReleaseOutcome {
  std::uint32_t block = 0;  ///< index into the blocks of the site
  std::uint32_t point = 0;  ///< index of the release point
  Vec2 start = Vec2::Zero();
  /// Last position of the run: at rest, at the border of the terrain or at the time limit, map, m.
  Vec2 stop = Vec2::Zero();
  std::vector<OutcomeAtMoment> barriers;  ///< state at each barrier of the campaign of the site
  std::uint32_t release = 0;              ///< index of the release set
  std::vector<OutcomeAtMoment> moments;   ///< state at each observed moment of the site
};

/// Blocks, barriers and release sets of a site to which observations can refer.
struct SiteDescription {
  std::string name;
  std::vector<std::string> blocks;    ///< ids of the blocks
  std::vector<std::string> shapes;    ///< shape class of each block: "compact" or "elongated"
  std::vector<std::string> barriers;  ///< names of the barriers
  Vec2 downslope = Vec2::UnitX();     ///< downslope direction, unit vector
  Vec2 mean_start = Vec2::Zero();
  std::vector<std::string> releases = {};  ///< names of the release sets; "" if there is only one
  /// Impacts and times at which states are observed, unique and ascending.
  std::vector<ObservedMoment> moments = {};
};

/// Function that simulates the releases of one member of a calibration at a site.
/// @param values  values of the unknown parameters of the member
using MemberSimulator = std::function<std::vector<ReleaseOutcome>(
    std::size_t site, std::uint32_t member, const std::vector<double>& values)>;

}  // namespace clast
