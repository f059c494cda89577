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

/// Moment of a release at which its state can be observed.
struct ObservedMoment {
  enum class Kind {
    kImpact,  ///< end of an impact (see `Impact`)
    kTime,    ///< time after the release
  };
  Kind kind = Kind::kImpact;
  double value = 1.0;  ///< number of the impact, from 1; or time, s

  std::string name() const;  ///< "impact 1", "0.5 s"
  auto operator<=>(const ObservedMoment&) const = default;
};

/// State of a block at a barrier or moment. Values are NaN if the block did not pass the barrier or
/// had no such impact. A finished run keeps its final state at later times.
struct OutcomeAtMoment {
  double speed = std::numeric_limits<double>::quiet_NaN();   ///< m/s
  double spin = std::numeric_limits<double>::quiet_NaN();    ///< rad/s
  double height = std::numeric_limits<double>::quiet_NaN();  ///< centre of mass above the ground, m
  double energy =
      std::numeric_limits<double>::quiet_NaN();  ///< kinetic energy of translation and rotation, J
  double depth = std::numeric_limits<double>::quiet_NaN();  ///< largest overlap of an impact, m
  Vec2 position = Vec2::Constant(
      std::numeric_limits<double>::quiet_NaN());  ///< position if the moment is a time, map, m

  bool passed() const { return speed == speed; }
};

struct ReleaseOutcome {
  std::uint32_t block = 0;  ///< index into the blocks of the site
  std::uint32_t point = 0;  ///< release point; releases of one point share its ground
  Vec2 start = Vec2::Zero();
  /// Last position of the run: at rest, at the border of the terrain or at the time limit, map, m.
  Vec2 stop = Vec2::Zero();
  std::vector<OutcomeAtMoment> barriers;  ///< one entry per barrier of the site's campaign
  std::uint32_t release = 0;              ///< index into the release sets of the site
  std::vector<OutcomeAtMoment>
      moments;  ///< one entry per moment of the site (`SiteDescription::moments`)
};

/// Blocks, barriers and release sets of a site to which observations can refer.
struct SiteDescription {
  std::string name;
  std::vector<std::string> blocks;    ///< ids
  std::vector<std::string> shapes;    ///< "compact" or "elongated", one per block
  std::vector<std::string> barriers;  ///< names
  Vec2 downslope = Vec2::UnitX();     ///< unit vector
  Vec2 mean_start = Vec2::Zero();
  std::vector<std::string> releases = {};    ///< names of the release sets; "" if there is only one
  std::vector<ObservedMoment> moments = {};  ///< observed moments, unique and ascending
};

/// Function that simulates the releases of one member at a site.
/// @param values  values of the unknowns, in their order and units
using MemberSimulator = std::function<std::vector<ReleaseOutcome>(
    std::size_t site, std::uint32_t member, const std::vector<double>& values)>;

}  // namespace clast
