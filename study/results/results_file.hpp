#pragma once
/// Writing of results files.
#include <filesystem>
#include <functional>

#include "study/results/results_journal.hpp"

namespace clast::study_detail {

/// Writes a results file: the header and `count` runs. `run(i)` is called in ascending order and
/// returns the run at index i.
void write_results_file(const std::filesystem::path& target, const CampaignHeader& header,
                        std::size_t count, const std::function<StoredRun(std::size_t)>& run);

/// Checks that the target can be written and that the disk has space for that many runs in the
/// journal and for the results file. A file without runs is written as a trial.
/// @throws InputError  as `ResultsWriter::create`
void check_results_disk_space(const std::filesystem::path& target, const CampaignHeader& header,
                              std::size_t runs);

}  // namespace clast::study_detail
