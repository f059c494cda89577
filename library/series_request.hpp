#pragma once
/// Requests for series of varied blocks, as made by `clast vary` and Python.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "library/block_library.hpp"
#include "library/block_series.hpp"
#include "library/series_steps.hpp"

namespace clast {

/// Request for variations of library blocks and for bodies sampled from a population.
struct SeriesRequest {
  std::filesystem::path library;
  std::vector<std::string> ids;       ///< varied blocks; empty: all
  SeriesTargets steps;                ///< variations of each block
  std::vector<std::string> like_ids;  ///< library blocks to whose ratios the blocks are stretched
  std::size_t draw = 0;               ///< number of additional bodies sampled from a population
  std::filesystem::path table;        ///< population of measured blocks; empty: the library blocks
  std::string units;                  ///< of the table; empty: from its header, or m
  std::string prefix = "V";           ///< of the ids of sampled bodies
  std::uint64_t seed = 1;
  SeriesOptions options;
  std::filesystem::path output;  ///< library for the bodies; empty: none
  bool replace = false;          ///< replace existing blocks of the same id

  bool is_empty() const;
  void check() const;  ///< throws InputError naming the field and its value, or what is missing
};

struct SeriesResult {
  BlockSeries series;              ///< at least one body
  std::size_t wanted = 0;          ///< number of requested bodies
  std::size_t output_blocks = 0;   ///< number of blocks in `output` afterwards
  std::optional<CopulaFit> fit;    ///< of the population, if bodies were sampled
  std::vector<std::string> notes;  ///< on the table
};

/// Makes the bodies from a loaded library.
/// @throws InputError  as `SeriesRequest::check`; if a block or file cannot be used, a body is
///                     requested twice, or there are more than 100,000
/// @throws GeometryError  if no body could be made
SeriesResult make_series(const SeriesRequest& request, const BlockLibrary& library);

/// Reads the library, makes the bodies and adds them to `output`.
/// @throws InputError  as above; or if a library cannot be used
/// @throws GeometryError  if no body could be made
SeriesResult make_series(const SeriesRequest& request);

}  // namespace clast
