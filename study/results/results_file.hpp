#pragma once
/// Writing of results files.
#include <filesystem>
#include <functional>

#include "study/results/results_journal.hpp"

namespace clast::study_detail {

/// Writes a results file with the header and `count` runs. `run(i)` returns the run with index i.
void write_results_file(const std::filesystem::path& target, const CampaignHeader& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

/// Checks that the results file can be written, and that the disk has space for it and its journal.
/// @throws InputError  if the file cannot be written or there is too little space
void check_results_disk_space(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs);

}  // namespace clast::study_detail
