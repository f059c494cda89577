#pragma once
/// Results of other engines, of the scenes that `write_engine_scenes` wrote, as results of the
/// campaign.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "study/results/results.hpp"

namespace clast {

/// Names of the engines whose results are read: "rockable".
const std::vector<std::string>& importable_engines();

struct EngineResultsOptions {
  std::string engine = "rockable";
  std::filesystem::path scenes =
      {};  ///< the folder of the scenes, with what the engine wrote in each
  /// The campaign file; none: the folder keeps the text, and SCENE.txt says where it was.
  std::optional<std::filesystem::path> campaign = {};
  bool replace = false;    ///< results that the target holds
  ProgressCallback progress = {};  ///< called after each run

  void check() const;  ///< throws InputError naming the field and its value
};

/// What was found.
struct EngineImportSummary {
  std::size_t runs = 0;
  std::size_t planned = 0;
  std::size_t without = 0;         ///< scenes that were written but not run
  std::vector<std::string> notes;  ///< what the results can't tell, and what differs
};

/// Reads the states that the engine wrote of each run and writes them as results of the campaign:
/// speeds, energies, crossings and stops, the trajectories as they are. What needs contacts
/// (`is_of_contacts`) is not in the file.
/// @throws InputError  no scenes of this engine; another campaign, or one whose inputs have
///                     changed; no scene was run; a file that can't be read, or is of another
///                     scene; the target can't be written, or holds what is kept
EngineImportSummary import_engine_results(const EngineResultsOptions& options,
                                 const std::filesystem::path& target);

}  // namespace clast
