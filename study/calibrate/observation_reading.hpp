#pragma once
/// Reading of the observations of a study file.
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/campaign/member_table.hpp"

namespace clast::study_detail {

/// Reads the description of a site without its blocks from the campaign.
SiteDescription read_site_path(const CalibrationSite& site);

const MemberTable<Observation>& observation_keys();

/// Reads the tables [[observation]] of a study file, and computes the observed statistics from
/// tables of stops and trajectories.
/// @throws InputError  if `read_calibration_study` would throw
std::vector<Observation> read_observations(const TomlTable& top,
                                           const std::vector<CalibrationSite>& sites);

}  // namespace clast::study_detail
