#pragma once
/// Masks: what of each photo is to be used.
#include <filesystem>
#include <vector>

namespace clast {

/// The mask of each photo: of a.jpg it is a.png, a.jpg.png as COLMAP has it, or a_mask.png, or the
/// same with another ending of photos. Black (below 128 of 255) is not used.
/// @param folder  of masks
/// @throws InputError  masks that are missing, of another size than their photos, or all black; by
///                     name
std::vector<std::filesystem::path> find_masks(const std::vector<std::filesystem::path>& photos,
                                            const std::filesystem::path& folder);

}  // namespace clast
