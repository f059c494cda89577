#pragma once
/// The blocks of a library as pictures, to choose from by class and by size.
#include <filesystem>
#include <span>
#include <string>

#include "core/files/output_folder.hpp"
#include "library/block.hpp"

namespace clast {

/// How a folder is known that `write_gallery` filled.
FolderKind gallery_folder_kind();

/// Writes FOLDER/gallery.html, one page that needs no network: for each block a picture, its
/// numbers, and a view that can be turned.
/// @param title  for example the library's name
/// @return the page
/// @throws InputError  the folder can't be made or written to
std::filesystem::path write_gallery(std::span<const Block* const> blocks, const std::string& title,
                                    const std::filesystem::path& folder);

}  // namespace clast
