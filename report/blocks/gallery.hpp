#pragma once
/// Gallery page of a block library, with filters by class and size.
#include <filesystem>
#include <span>
#include <string>

#include "core/files/output_folder.hpp"
#include "library/block.hpp"

namespace clast {

/// Returns the marks by which an output folder is recognised as a gallery before it is replaced.
OutputFolderKind gallery_folder_kind();

/// Writes the gallery of a block library as one page, with image, measures and 3-D view of each
/// block.
/// @param title  title of the page, such as the name of the library
/// @return path of the page
/// @throws InputError  if the folder cannot be created or written
std::filesystem::path write_gallery(std::span<const Block* const> blocks, const std::string& title,
                                    const std::filesystem::path& folder);

}  // namespace clast
