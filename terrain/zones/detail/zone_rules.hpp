#pragma once
/// Ground zones by slope and height.
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

/// One zone and when it applies: all conditions hold.
struct ZoneRule {
  struct Condition {
    bool of_slope = false;  ///< else of height
    bool above = false;     ///< more than the bound, else less
    bool or_equal = false;
    double bound = 0.0;  ///< rad or m on the map
  };
  std::string zone;
  std::vector<Condition> conditions;  ///< none: always

  bool applies(double slope, double height) const;
};

/// "rock=slope>60", "scree=height<1450&slope>=30", "soil=else"; slopes in degrees from level (more
/// than 90 overhangs), heights in metres on the map.
/// @throws InputError  a rule that can't be read
std::vector<ZoneRule> parse_zone_rules(const std::vector<std::string>& texts);

}  // namespace clast::terrain_detail
