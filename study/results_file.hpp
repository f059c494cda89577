#pragma once
/// Writing a results file from runs, wherever they come from.
#include <filesystem>
#include <functional>

#include "study/results_journal.hpp"

namespace clast {

/// That writing `target` would cost nobody a campaign file, a library or a terrain.
/// @throws InputError  a folder; a file that is not empty and no results file
void check_replaceable(const std::filesystem::path& target);

/// Writes `target` whole: the header, then `count` runs in the order in which `run` is asked for
/// them, which is that of their numbers.
void write_results_file(const std::filesystem::path& target, const CampaignResults& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

}  // namespace clast
