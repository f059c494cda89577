#pragma once
/// Runs of a campaign, and what is kept of realisations under way, which can take hours.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

class ResumableRuns {
 public:
  /// Receives progress about twice a second. When it throws, a checkpoint is written and the
  /// realisation ends.
  using Report = std::function<void(const std::string& what)>;

  /// All must outlive it.
  /// @param target  of the results, beside which checkpoints are kept
  ResumableRuns(const CampaignPlan& prepared, const std::filesystem::path& target,
                const RunOptions& options)
      : prepared_(prepared), target_(target), options_(options) {}

  /// To be called before the first runs.
  /// @param firsts  of those that are computed together
  /// @throws InputError  a checkpoint to resume from is damaged, or of another campaign
  void check_checkpoints(const std::vector<std::uint32_t>& firsts) const;
  /// Those that are computed together from `first` on; to resume, from their checkpoint if there is
  /// one. A checkpoint that can't be written on the way is tried again later, and reported.
  /// @param threads  that a realisation may use
  /// @throws InputError  as `check_checkpoints`
  std::vector<StoredRun> compute(std::uint32_t first, unsigned threads,
                                 const Report& report = {}) const;
  /// Of those runs, once they are kept.
  void remove_checkpoint(std::uint32_t first) const;

 private:
  const CampaignPlan& prepared_;
  const std::filesystem::path& target_;
  const RunOptions& options_;
};

}  // namespace clast::study_detail
