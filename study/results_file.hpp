#pragma once
/// Writing a results file from runs, wherever they come from.
#include <filesystem>
#include <functional>

#include "study/results_journal.hpp"

namespace clast {

/// Writes `target` whole: the header, then `count` runs in the order in which `run` is asked for
/// them, which is that of their numbers.
void write_results_file(const std::filesystem::path& target, const CampaignResults& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

}  // namespace clast
