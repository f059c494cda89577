#pragma once
/// Simulator of the members of a calibration at one site.
#include <memory>
#include <string>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/release_outcome.hpp"

namespace clast {

/// Simulates the members of a calibration at one site. The campaign is loaded once, and the unknown
/// parameters are set for each member. Releases are distributed evenly over the planned runs.
/// Sampled blocks are sampled again for each member if a parameter concerns them.
class SiteMemberSimulator {
 public:
  /// Prepares the campaign of the site.
  /// @param unknowns  unknown parameters; those that the campaign lacks are ignored
  /// @param moments  impacts and times at which states are recorded
  /// @throws InputError, SimulationError  if `prepare_campaign` throws, or if the campaign has
  ///                                      fewer runs than the design requests
  SiteMemberSimulator(const CalibrationSite& site, const std::vector<UnknownParameter>& unknowns,
                      const CalibrationDesign& design,
                      const std::vector<ObservedMoment>& moments = {});
  ~SiteMemberSimulator();
  SiteMemberSimulator(SiteMemberSimulator&&) noexcept;

  const SiteDescription& description() const;
  /// Returns the input files (campaign, library, terrain, release sets), each as "path sha256".
  const std::vector<std::string>& inputs() const;

  /// Simulates the releases of one member. Not thread-safe.
  /// @param values  values of the unknowns
  /// @param threads  number of threads; does not affect the result
  /// @throws SimulationError  if a start position is inside the ground or a run fails; names member
  ///                          and reason
  std::vector<ReleaseOutcome> simulate(std::uint32_t member, const std::vector<double>& values,
                                       unsigned threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
