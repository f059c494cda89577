#pragma once
/// Removal of spurious contacts caused by overlapping cores.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// Removes contacts of edges and faces that vanish once a shallower contact has pushed the block
/// out: if a block overhangs an edge, its wall is deep behind the ground's wall although it
/// penetrates the top only slightly. Contacts of the rounded layers alone are kept.
/// @param contacts  in the frame of the ground
void remove_resolved_contacts(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                              const IndexedSurface& block, const Pose& ground_from_block,
                              double size);

}  // namespace clast::dem_detail
