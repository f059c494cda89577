#pragma once
/// Writing a results file from runs, wherever they come from.
#include <filesystem>
#include <functional>

#include "study/results/results_journal.hpp"

namespace clast::study_detail {

/// Writes `target` whole: the header, then `count` runs in the order in which `run` is asked for
/// them, which is that of their numbers.
void write_results_file(const std::filesystem::path& target, const CampaignHeader& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

/// Checks that the target can be written and that there is room for as many runs in the journal,
/// beside a file that holds no run yet. That file is written, which finds any other problem.
/// @throws InputError  as `ResultsWriter::create`
void check_results_disk_space(const std::filesystem::path& target, const CampaignHeader& header,
                    std::size_t runs);

}  // namespace clast::study_detail
