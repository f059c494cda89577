#pragma once
/// Assignment of ground zones to triangles.
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

/// Assigns each triangle the zone that covers most of its plan area, and vertical triangles the
/// zone under their centroid. With `cut`, polygon borders become edges first.
/// @param terrain  complete except for zones; `zone` and `zone_names` are set, with used zones
///                 only, in order of class number or first appearance
/// @throws InputError  if a source cannot be read or does not fit, or polygons of different zones
///                     overlap
/// @throws GeometryError  if less than half of some triangles has a zone, with area and position
void assign_zones(Terrain& terrain, const ZoneFile& source, bool cut);

/// Assigns each triangle the zone of the first rule that its slope and the height of its centroid
/// satisfy. Used names in order of the rules.
/// @throws InputError  if a rule is invalid
/// @throws GeometryError  if no rule applies to some triangles, with area and position
void assign_zones(Terrain& terrain, const std::vector<std::string>& rules);

}  // namespace clast::terrain_detail
