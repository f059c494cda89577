#pragma once
/// Consistency checks of block records.
#include <string>

#include "library/block.hpp"

namespace clast::library_detail {

/// Checks a block. The mass must equal density times volume. The moments must be physically
/// possible and agree with the inertia tensor. The box must enclose the core. If a closed form
/// exists, volume and moments must be those of the core. The tolerance is that of rounding; for
/// numerically integrated values, it is their stated error.
/// @param where  prefix of messages, such as "blocks.h5: block B017"
/// @throws InputError  if a check fails; states both numbers
void check_block_consistency(const Block& block, const std::string& where);

}  // namespace clast::library_detail
