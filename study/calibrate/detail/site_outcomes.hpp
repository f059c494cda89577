#pragma once
/// Outcomes of the members at one site in the posterior file. Schema: docs/formats.md.
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/checked_group.hpp"

namespace clast::study_detail {

using MemberOutcomes = std::vector<std::vector<ReleaseOutcome>>;  ///< by member

/// Writes the outcomes of one site.
/// @param done  by member: true if simulated
void write_site_outcomes(Hdf5Group group, const SiteDescription& site,
                         const MemberOutcomes& members, const std::vector<bool>& done);

/// Reads the description of a site.
/// @throws InputError  if the file is damaged
SiteDescription read_site_description(const CheckedGroup& site);
/// Reads the outcomes of a site.
/// @param runs  group of the site's releases
/// @param members  number of members
/// @throws InputError  if the file is damaged
MemberOutcomes read_release_outcomes(const CheckedGroup& runs, const SiteDescription& facts,
                                     std::size_t members);

}  // namespace clast::study_detail
