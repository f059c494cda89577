#pragma once
/// Ground zones by slope and height.
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::terrain_detail {

/// Zone with its conditions, all of which must hold.
struct ZoneRule {
  struct Condition {
    bool of_slope = false;  ///< false: of height
    bool above = false;     ///< true: greater than the bound; false: less
    bool or_equal = false;
    double bound = 0.0;  ///< rad, or m on the map
  };
  std::string zone;
  std::vector<Condition> conditions;  ///< empty: always

  bool applies(double slope, double height) const;
};

/// Parses rules such as "rock=slope>60", "scree=height<1450&slope>=30", "soil=else"; slopes in
/// degrees (above 90: overhangs), heights in metres on the map.
/// @throws InputError  if a rule is invalid
std::vector<ZoneRule> parse_zone_rules(const std::vector<std::string>& texts);

}  // namespace clast::terrain_detail
