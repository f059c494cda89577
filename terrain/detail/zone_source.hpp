#pragma once
/// Where the ground zone of every triangle comes from.
#include "terrain/terrain_input.hpp"

namespace clast::detail {

/// Gives every triangle the zone in which its centroid lies, seen from above.
/// @param terrain  everything but zones; `zone` and `zone_names` are filled in, those used, in
///                 order of class number or of first appearance in the file
/// @throws InputError     a source that can't be read or does not fit; overlapping polygons with
///                        different zones
/// @throws GeometryError  ground without a zone: its area and a place
void assign_zones(Terrain& terrain, const ZoneFile& source);

}  // namespace clast::detail
