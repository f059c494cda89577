#pragma once
/// Whether the numbers of a block are consistent.
#include <string>

#include "library/block.hpp"

namespace clast::library_detail {

/// Refuses a block whose mass is not density times volume, whose moments no solid has or are not
/// those of its inertia, whose box is not the one around its core, or, where a closed form gives
/// them, whose volume and moments are not those of its core. Numbers of every version of clast
/// agree to rounding, and where they were integrated, to their stated error.
/// @param where  the start of the message: "blocks.h5: block B017"
/// @throws InputError  with both numbers
void check_block_consistency(const Block& block, const std::string& where);

}  // namespace clast::library_detail
