#pragma once
/// Simulator of the members of a calibration at one site.
#include <memory>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// Simulator of one site: its campaign is loaded once and the unknowns are set member by member.
/// The releases of a member are spread evenly over all planned runs and differ between members. If
/// an unknown concerns sampled blocks, these are sampled again for each member; outcomes name the
/// library blocks.
class SiteMemberSimulator {
 public:
  /// Prepares the campaign.
  /// @param unknowns  those that the campaign lacks are ignored
  /// @param moments  observed at the site
  /// @throws InputError, SimulationError  as `prepare_campaign`; or if the campaign has fewer runs
  ///                                      than the design requests
  SiteMemberSimulator(const CalibrationSite& site, const std::vector<Unknown>& unknowns,
                      const CalibrationDesign& design, const std::vector<Moment>& moments = {});
  ~SiteMemberSimulator();
  SiteMemberSimulator(SiteMemberSimulator&&) noexcept;

  const SiteDescription& description() const;
  /// Returns campaign, library, terrain and release files, each as "path sha256".
  const std::vector<std::string>& inputs() const;

  /// Simulates one member. Not thread-safe.
  /// @param values  of the unknowns
  /// @param threads  does not affect the result
  /// @throws SimulationError  if a start is inside the ground or a run fails; names member and
  ///                          reason
  std::vector<ReleaseOutcome> simulate(std::uint32_t member, const std::vector<double>& values,
                                       unsigned threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
