#pragma once
/// Options of `clast reconstruct` for folders of photographs.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "reconstruct/photos/photo_scan.hpp"

namespace clast {

struct PhotoArgs {
  std::vector<std::string> bars;
  std::filesystem::path board;  ///< board file; empty if not given
  double marker_size = 0.0;     ///< side length of the markers, m; 0 if not given
  double colmap_minutes = 60.0;
  PhotoScanOptions options;

  /// Parses the options for photographs.
  /// @throws CLI::ValidationError  if a scale bar is invalid, or a marker is not on the board
  /// @throws InputError  if `read_scale_board` throws
  PhotoScanOptions parse() const;
};

void add_photo_options(CLI::App& command, PhotoArgs& args);

}  // namespace clast
