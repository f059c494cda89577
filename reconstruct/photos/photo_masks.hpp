#pragma once
/// Image masks: used areas of photos.
#include <filesystem>
#include <vector>

namespace clast {

/// Finds the mask of each photo: for a.jpg it is a.png, a.jpg.png (COLMAP) or a_mask.png, or with
/// another image extension. Black (below 128 of 255) is not used.
/// @param folder  of masks
/// @throws InputError  if masks are missing, differ in size from their photos, or are all black
std::vector<std::filesystem::path> find_masks(const std::vector<std::filesystem::path>& photos,
                                              const std::filesystem::path& folder);

}  // namespace clast
