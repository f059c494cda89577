#pragma once
/// Simulates the members of a calibration at one site.
#include <memory>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// The campaign of a site, loaded and placed once, with the unknowns set for one member after the
/// other. Releases of a member are taken evenly from all runs that the campaign plans, other ones
/// for each member. Where an unknown is of drawn blocks, these are drawn anew for each member, and
/// outcomes name the blocks of the library that they are drawn from.
class SiteMemberSimulator {
 public:
  /// @param unknowns  those that the campaign does not have are left out
  /// @param moments   of the site that are observed
  /// @throws InputError, SimulationError  as `prepare_campaign`; or the campaign has fewer runs
  /// than
  ///                                      the design asks for
  SiteMemberSimulator(const CalibrationSite& site, const std::vector<Unknown>& unknowns,
                const CalibrationDesign& design, const std::vector<Moment>& moments = {});
  ~SiteMemberSimulator();
  SiteMemberSimulator(SiteMemberSimulator&&) noexcept;

  const SiteDescription& facts() const;
  /// Campaign, library, terrain and release files, each "path sha256".
  const std::vector<std::string>& inputs() const;

  /// One member at a time.
  /// @param values   of the unknowns
  /// @param threads  changes no bit of the result
  /// @throws SimulationError  a start inside the ground, or a run that fails: member and reason
  std::vector<ReleaseOutcome> simulate(std::uint32_t member, const std::vector<double>& values,
                                       unsigned threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
