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
struct VariationSeriesRequest {
  std::filesystem::path library;
  std::vector<std::string> ids;  ///< ids of the blocks to vary; empty for all
  VariationTargets targets;      ///< variations of each block
  std::vector<std::string>
      target_ratio_ids;           ///< library blocks to whose ratios the blocks are stretched
  std::size_t sampled_count = 0;  ///< number of additional bodies sampled from a population
  /// Table or library (.h5) of the population; if empty, the library blocks are the population.
  std::filesystem::path table;
  std::string units;  ///< length unit of the table; if empty, that of its header, otherwise m
  std::string prefix = "V";  ///< prefix of the ids of sampled bodies
  std::uint64_t seed = 1;
  VariationSeriesOptions options;
  std::filesystem::path output;  ///< library to which the bodies are added; may be empty
  bool replace = false;          ///< true: existing blocks with the same id are replaced

  bool is_empty() const;
  void check() const;  ///< throws InputError naming the field and its value, or the missing field
};

struct VariationSeriesResult {
  VariedBlockSeries series;         ///< at least one body
  std::size_t requested_count = 0;  ///< number of requested bodies
  std::size_t output_blocks = 0;    ///< number of blocks in `output` after the bodies were added
  std::optional<CopulaFit> fit;     ///< fit to the population, if bodies were sampled
  std::vector<std::string> notes;   ///< notes on the table
};

/// Makes the requested bodies from the blocks of `library`.
/// @throws InputError  if `VariationSeriesRequest::check` throws, a block or file cannot be used, a
/// body is
///                     requested twice, or there are more than 100,000 bodies
/// @throws GeometryError  if no body could be made
VariationSeriesResult make_variation_series(const VariationSeriesRequest& request,
                                            const BlockLibrary& library);

/// Reads the library of the request, makes the requested bodies and adds them to `output`.
/// @throws InputError  if the other overload would throw, or a library cannot be used
/// @throws GeometryError  if no body could be made
VariationSeriesResult make_variation_series(const VariationSeriesRequest& request);

}  // namespace clast
