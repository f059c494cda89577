#pragma once
/// Observations of a study file, read and checked.
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/bound_table.hpp"

namespace clast::study_detail {

/// What observations need to know of a site before its campaign is prepared: all but its blocks.
SiteDescription read_site_path(const CalibrationSite& site);

/// The keys of [[observation]].
const MemberTable<Observation>& observation_keys();

/// The tables [[observation]], with the figures of the stops that they name.
/// @throws InputError  as `read_calibration_study`
std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites);

}  // namespace clast::study_detail
