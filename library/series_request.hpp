#pragma once
/// What is asked of a series of bodies, and doing it: what `clast vary` and Python call.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "library/block_library.hpp"
#include "library/block_series.hpp"
#include "library/series_steps.hpp"

namespace clast {

/// Twins of the blocks of a library, and bodies drawn from a population.
struct SeriesRequest {
  std::filesystem::path library;
  std::vector<std::string> ids;       ///< blocks that are varied; empty: all of the library
  SeriesTargets steps;                ///< what each of them is varied by
  std::vector<std::string> like_ids;  ///< blocks of the library to whose ratios they are stretched
  std::size_t draw = 0;               ///< bodies drawn from a population besides
  std::filesystem::path table;        ///< of measured blocks, the population; empty: the blocks
  std::string units;                  ///< of the table; empty: as its header says, else m
  std::string prefix = "V";           ///< of ids of the bodies drawn
  std::uint64_t seed = 1;
  SeriesOptions options;
  std::filesystem::path output;  ///< library to which the bodies are added; empty: none
  bool replace = false;          ///< blocks of the same id there

  bool is_empty() const;
  void check() const;  ///< throws InputError naming the field and its value, or what is missing
};

/// What became of a request.
struct SeriesResult {
  BlockSeries series;              ///< one body at least
  std::size_t wanted = 0;          ///< bodies
  std::size_t output_blocks = 0;   ///< blocks in `output` then
  std::optional<CopulaFit> fit;    ///< of the population, where bodies were drawn
  std::vector<std::string> notes;  ///< on the table
};

/// Makes the bodies of the blocks of a library that is there already.
/// @throws InputError     as `SeriesRequest::check`; a block or file that can't be used; a body
/// asked
///                        for twice; more than 100,000
/// @throws GeometryError  no body could be made
SeriesResult make_series(const SeriesRequest& request, const BlockLibrary& library);

/// Reads the library, makes the bodies and adds them to `output`.
/// @throws InputError     as above; a library that can't be used
/// @throws GeometryError  no body could be made
SeriesResult make_series(const SeriesRequest& request);

}  // namespace clast
