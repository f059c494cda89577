#pragma once
/// Simulation of runs with checkpoints of long realisations.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

class ResumableRuns {
 public:
  /// Function that receives the progress about twice per second. If it throws, a checkpoint is
  /// written and the realisation ends.
  using Report = std::function<void(const std::string& what)>;

  /// Stores references to the arguments, which must outlive this object.
  /// @param target  results file; checkpoints are stored beside it
  ResumableRuns(const CampaignPlan& prepared, const std::filesystem::path& target,
                const CampaignRunOptions& options)
      : prepared_(prepared), target_(target), options_(options) {}

  /// Checks all checkpoints of a campaign before the first run.
  /// @param firsts  first run of each group of runs that are computed together
  /// @throws InputError  if a checkpoint is damaged or of another campaign
  void check_checkpoints(const std::vector<std::uint32_t>& firsts) const;
  /// Simulates the run or realisation that starts with run `first`. If there is a checkpoint, the
  /// simulation continues from it.
  /// @param threads  number of threads for a realisation
  /// @throws InputError  if the checkpoint is damaged or of another campaign
  std::vector<StoredRun> compute(std::uint32_t first, unsigned threads,
                                 const Report& report = {}) const;
  /// Removes the checkpoint of a group whose runs are stored.
  void remove_checkpoint(std::uint32_t first) const;

 private:
  const CampaignPlan& prepared_;
  const std::filesystem::path& target_;
  const CampaignRunOptions& options_;
};

}  // namespace clast::study_detail
