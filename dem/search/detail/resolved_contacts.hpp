#pragma once
/// Removal of spurious contacts caused by overlapping cores.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// Removes contacts of edges and faces that disappear once a shallower contact has pushed the block
/// out. Example: a block overhangs a step. It penetrates the top only slightly, but its side lies
/// deep behind the step's wall. Contacts in which only the rounded layers overlap are kept.
/// @param contacts  in the frame of the ground
void remove_resolved_contacts(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                              const IndexedSurface& block, const Pose& ground_from_block,
                              double size);

}  // namespace clast::dem_detail
