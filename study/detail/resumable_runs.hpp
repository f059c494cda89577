#pragma once
/// Runs of a campaign, and what is kept of realisations under way, which can take hours.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/campaign_runner.hpp"

namespace clast::study_detail {

class ResumableRuns {
 public:
  /// Sees now and then how far a realisation has come. What it throws ends the realisation, once a
  /// checkpoint is kept.
  using Report = std::function<void(const std::string& what)>;

  /// All must outlive it.
  /// @param target  of the results, beside which checkpoints are kept
  ResumableRuns(const PreparedCampaign& prepared, const std::filesystem::path& target,
                const RunOptions& options)
      : prepared_(prepared), target_(target), options_(options) {}

  /// To be called before the first runs.
  /// @param firsts  of those that are computed together
  /// @throws InputError  one of their checkpoints, to resume, is not fit to go on from
  void check(const std::vector<std::uint32_t>& firsts) const;
  /// Those that are computed together from `first` on; to resume, from their checkpoint if there is
  /// one.
  /// @param threads  that a realisation may use
  /// @throws InputError  as `check`; or a checkpoint can't be written
  std::vector<StoredRun> compute(std::uint32_t first, unsigned threads,
                                 const Report& report = {}) const;
  /// Removes the checkpoint of those runs, once they are kept.
  void forget(std::uint32_t first) const;

 private:
  const PreparedCampaign& prepared_;
  const std::filesystem::path& target_;
  const RunOptions& options_;
};

}  // namespace clast::study_detail
