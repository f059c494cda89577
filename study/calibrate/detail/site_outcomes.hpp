#pragma once
/// What members of a calibration did at one site, in its HDF5 file. Schema: docs/formats.md.
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/checked_group.hpp"

namespace clast::study_detail {

using Outcomes = std::vector<std::vector<ReleaseOutcome>>;  ///< of each member

/// @param done  of each member: is it simulated?
void write_site(Hdf5Group group, const SiteDescription& site, const Outcomes& members,
                const std::vector<bool>& done);

/// @throws InputError  damaged, as what follows
SiteDescription read_facts(const CheckedGroup& site);
/// @param runs     the group of the site's releases
/// @param members  that there are
Outcomes read_release_outcomes(const CheckedGroup& runs, const SiteDescription& facts, std::size_t members);

}  // namespace clast::study_detail
