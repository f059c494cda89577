#pragma once
/// Storage of the simulated releases at one site in the posterior file (docs/formats.md).
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/checked_group.hpp"

namespace clast::study_detail {

/// Simulated releases of each member.
using MemberOutcomes = std::vector<std::vector<ReleaseOutcome>>;

/// Writes the simulated releases of all members at one site.
/// @param done  for each member: true if it was simulated
void write_site_outcomes(Hdf5Group group, const SiteDescription& site,
                         const MemberOutcomes& members, const std::vector<bool>& done);

/// Reads the description of a site.
/// @throws InputError  if the file is damaged
SiteDescription read_site_description(const CheckedGroup& site);
/// Reads the simulated releases of all members at one site.
/// @param runs  group of the releases in the file
/// @param members  number of members
/// @throws InputError  if the file is damaged
MemberOutcomes read_release_outcomes(const CheckedGroup& runs, const SiteDescription& facts,
                                     std::size_t members);

}  // namespace clast::study_detail
