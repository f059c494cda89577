#pragma once
/// Where the ground zone of every triangle comes from.
#include "terrain/terrain_input.hpp"

namespace clast::terrain_detail {

/// Gives every triangle the zone that covers most of its plan area; an upright one the zone under
/// its centroid. With `cut`, borders of polygons are made edges first.
/// @param terrain  everything but zones; `zone` and `zone_names` are filled in, those used, in
///                 order of class number or of first appearance in the file
/// @throws InputError     a source that can't be read or does not fit; overlapping polygons with
///                        different zones
/// @throws GeometryError  triangles of which less than half has a zone: the area and a place
void assign_zones(Terrain& terrain, const ZoneFile& source, bool cut);

/// Gives every triangle the zone of the first rule that its slope and the height of its centroid
/// satisfy. Names in order of the rules, those used.
/// @throws InputError     a rule that can't be read
/// @throws GeometryError  triangles that no rule is for: their area and a place
void assign_zones(Terrain& terrain, const std::vector<std::string>& rules);

}  // namespace clast::terrain_detail
