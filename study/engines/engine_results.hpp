#pragma once
/// Import of results that other engines computed from scenes of a campaign.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "study/results/results.hpp"

namespace clast {

/// Returns the names of the engines whose results can be imported: "rockable".
const std::vector<std::string>& importable_engines();

struct EngineResultsOptions {
  std::string engine = "rockable";
  std::filesystem::path scenes = {};  ///< folder of the scenes with the output of the engine
  /// Campaign file; if empty, the copy in the folder of the scenes.
  std::optional<std::filesystem::path> campaign = {};
  bool replace = false;            ///< true if existing results in the target are replaced
  ProgressCallback progress = {};  ///< called after each run

  void check() const;  ///< throws InputError naming the field and its value
};

struct EngineImportSummary {
  std::size_t runs = 0;
  std::size_t planned = 0;
  std::size_t without_output = 0;  ///< number of scenes without output
  std::vector<std::string> notes;  ///< notes on missing quantities and differences
};

/// Imports the states that another engine computed. Writes a results file with speeds, energies,
/// crossings, stops and trajectories, but without contact data.
/// @throws InputError  if there are no scenes of this engine, the campaign or its inputs differ, no
///                     scene was run, a file cannot be read, or the target cannot be written or
///                     replaced
EngineImportSummary import_engine_results(const EngineResultsOptions& options,
                                          const std::filesystem::path& target);

}  // namespace clast
