#pragma once
/// Consistency checks of block records.
#include <string>

#include "library/block.hpp"

namespace clast::library_detail {

/// Checks a block: mass equals density times volume; moments are physically possible and those of
/// its inertia tensor; the box encloses its core; volume and moments are those of its core if a
/// closed form exists. Numbers agree to rounding for all versions of clast, integrated ones to
/// their stated error.
/// @param where  prefix of messages: "blocks.h5: block B017"
/// @throws InputError  with both numbers
void check_block_consistency(const Block& block, const std::string& where);

}  // namespace clast::library_detail
