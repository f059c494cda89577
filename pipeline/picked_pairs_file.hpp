#pragma once
/// Reader of the places that a user picked in several scans (docs/formats.md).
#include <filesystem>
#include <vector>

#include "pipeline/join_options.hpp"

namespace clast {

/// Reads a table with the columns scan_a, x, y, z, scan_b, x, y, z. A first row without numbers is
/// a heading.
/// @throws InputError  if the file cannot be read, or a row is not of this form; names file, line
///                     and field
std::vector<NamedPair> read_picked_pairs(const std::filesystem::path& file);

}  // namespace clast
