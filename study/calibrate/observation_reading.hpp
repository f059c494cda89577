#pragma once
/// Reading of the observations of a study file.
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/member_table.hpp"

namespace clast::study_detail {

/// Reads what observations need of a site before its campaign is prepared: all but its blocks.
SiteDescription read_site_path(const CalibrationSite& site);

const MemberTable<Observation>& observation_keys();

/// Reads the tables [[observation]] and computes the statistics of the stops that they name.
/// @throws InputError  as `read_calibration_study`
std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites);

}  // namespace clast::study_detail
