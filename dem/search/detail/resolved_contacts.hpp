#pragma once
/// Removes contacts that are none, found only because the cores overlap.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// Removes contacts of edges and faces that would be gone once a shallower contact has pushed the
/// block out: where a block overhangs an edge, its own wall is deep behind the ground's wall though
/// it only sank a little into the top. Contacts of the skins alone are left as they are.
/// @param contacts  in the frame of the ground
void remove_resolved_contacts(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                              const IndexedSurface& block, const Pose& ground_from_block,
                              double size);

}  // namespace clast::dem_detail
