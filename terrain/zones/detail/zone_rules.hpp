#pragma once
/// Ground zones by slope and height.
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

/// Zone and the conditions for it, all of which must hold.
struct ZoneRule {
  struct Condition {
    bool of_slope = false;  ///< true for a bound of the slope, false for one of the height
    bool above = false;     ///< true if the value must exceed the bound, false if it must be below
    bool or_equal = false;
    double bound = 0.0;  ///< slope in rad, or map height in m
  };
  std::string zone;
  std::vector<Condition> conditions;  ///< if empty, the rule always applies

  bool applies(double slope, double height) const;
};

/// Parses rules such as "rock=slope>60", "scree=height<1450&slope>=30", "soil=else". Slopes are in
/// degrees, above 90 for overhangs; heights are map heights in metres.
/// @throws InputError  if a rule is invalid
std::vector<ZoneRule> parse_zone_rules(const std::vector<std::string>& texts);

}  // namespace clast::terrain_detail
