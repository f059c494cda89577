#pragma once
/// Assignment of ground zones to triangles.
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

/// Assigns each triangle the zone of most of its plan area, or of its centroid if vertical.
/// @param terrain  receives `zone` and `zone_names`. Only used zones are listed, in order of class
///                 number or first appearance
/// @param cut  true to make polygon borders edges of the terrain first
/// @throws InputError  if the source cannot be read or does not fit the terrain, or if polygons of
///                     different zones overlap
/// @throws GeometryError  if less than half the area of a triangle has a zone; the message gives
///                        area and position
void assign_zones(Terrain& terrain, const ZoneFile& source, bool cut);

/// Assigns each triangle the zone of the first rule that its slope and the height of its centroid
/// satisfy. `zone_names` lists the used zones in the order of the rules.
/// @throws InputError  if a rule is invalid
/// @throws GeometryError  if no rule applies to some triangle; the message gives area and position
void assign_zones(Terrain& terrain, const std::vector<std::string>& rules);

}  // namespace clast::terrain_detail
