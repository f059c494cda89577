#pragma once
/// Options of `clast reconstruct` for folders of photographs.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

/// The options as they are written; what they hold goes into a `PhotoScanOptions`.
struct PhotoArgs {
  std::vector<std::string> bars;
  std::filesystem::path board;  ///< file; empty: none
  double marker_size = 0.0;     ///< m; 0: not given
  double colmap_minutes = 60.0;
  PhotoScanOptions options;

  /// @throws CLI::ValidationError  what is no scale bar; markers that a board doesn't have
  /// @throws InputError            what `read_scale_board` throws
  PhotoScanOptions parsed() const;
};

/// Adds them to the command, in a group of their own.
void add_photo_options(CLI::App& command, PhotoArgs& args);

}  // namespace clast
