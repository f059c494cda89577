#pragma once
/// Reading of the observations of a study file.
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/member_table.hpp"

namespace clast::study_detail {

/// Reads the description of a site without its blocks. This needs no prepared campaign.
SiteDescription read_site_path(const CalibrationSite& site);

const MemberTable<Observation>& observation_keys();

/// Reads the tables [[observation]]. Computes the observed statistics from the tables of stops and
/// trajectories that they name.
/// @throws InputError  as `read_calibration_study`
std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites);

}  // namespace clast::study_detail
