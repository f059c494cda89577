#pragma once
/// Writing of results files.
#include <filesystem>
#include <functional>

#include "study/results/results_journal.hpp"

namespace clast::study_detail {

/// Writes a results file with the header and `count` runs. `run(i)` must return the run with index
/// i; it is called in ascending order.
void write_results_file(const std::filesystem::path& target, const CampaignHeader& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

/// Checks that the target can be written, and that the disk has space for journal and results file.
/// For this, a file without runs is written.
/// @throws InputError  if the file cannot be written or there is too little space
void check_results_disk_space(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs);

}  // namespace clast::study_detail
