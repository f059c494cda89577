#include "study/calibrate/study_check.hpp"

#include "core/error.hpp"
#include "study/calibrate/detail/study_reading.hpp"
#include "study/calibrate/site_simulator.hpp"
#include "study/simulate/campaign_check.hpp"

namespace clast {

using namespace study_detail;

CalibrationCheck check_calibration_study(const std::filesystem::path& file) {
  CalibrationCheck check;
  const auto find = collect_findings(check.findings);
  const CalibrationStudy study = read_study_by_parts(file, find);
  for (std::size_t i = 0; i < study.sites.size(); ++i) {
    const CalibrationSite& site = study.sites[i];
    const CampaignCheck campaign = check_campaign(site.campaign.file);
    for (const std::string& finding : campaign.findings) {
      find([&] { throw InputError(finding); });
    }
    // The blocks that observations are of are known once a library is loaded.
    if (!check.findings.empty()) continue;
    find([&] {
      const SiteMemberSimulator simulator(site, study.unknowns, study.design,
                                          observed_moments(study.observations, i));
      for (const Observation& observation : study.observations) {
        if (observation.site == i) select_outcomes(observation, simulator.description(), {});
      }
    });
  }
  if (check.findings.empty()) check.study = study;
  return check;
}

}  // namespace clast
