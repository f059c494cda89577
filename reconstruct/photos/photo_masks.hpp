#pragma once
/// Image masks, which select the used areas of photos.
#include <filesystem>
#include <vector>

namespace clast {

/// Finds the mask of each photo. The mask of a.jpg is a.png, a.jpg.png (COLMAP) or a_mask.png, or
/// has another image extension. Black areas (below 128 of 255) are not used.
/// @param folder  folder of masks
/// @throws InputError  if masks are missing, differ in size from their photos, or are all black
std::vector<std::filesystem::path> find_masks(const std::vector<std::filesystem::path>& photos,
                                              const std::filesystem::path& folder);

}  // namespace clast
