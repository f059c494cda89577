#pragma once
/// Removal of spurious contacts caused by overlapping cores.
#include <vector>

#include "dem/search/feature_tests.hpp"

namespace clast::dem_detail {

/// Removes spurious edge and face contacts. A contact is spurious if it disappears after a
/// shallower contact has pushed the block out of the ground. Example: the side of a block that
/// overhangs a step lies deep behind the wall of the step. Contacts in which only the rounded
/// layers overlap are kept.
/// @param contacts  contact points in the frame of the ground
void remove_resolved_contacts(std::vector<ContactPoint>& contacts, const IndexedSurface& ground,
                              const IndexedSurface& block, const Pose& ground_from_block,
                              double size);

}  // namespace clast::dem_detail
