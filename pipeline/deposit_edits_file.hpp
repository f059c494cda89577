#pragma once
/// Reader of the corrections of a segmented deposit (docs/formats.md).
#include <filesystem>
#include <vector>

#include "reconstruct/deposit/deposit_edits.hpp"

namespace clast {

/// Reads corrections as the page of a deposit saves them.
/// @throws InputError  if the file cannot be read or does not hold valid edits; names file, edit,
///                     key and expectation
std::vector<DepositEdit> read_deposit_edits(const std::filesystem::path& file);

}  // namespace clast
