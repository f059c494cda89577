#pragma once
/// Settings of ensemble members that are taken from posterior draws.
#include <cstddef>
#include <vector>

#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// Chooses a different random draw of the posterior for each member. Empty without a posterior.
std::vector<std::size_t> choose_posterior_draw_indices(const Ensemble& ensemble);

/// Computes the medians of all parameters. They are returned as a single draw.
PosteriorDraws compute_posterior_medians(const PosteriorDraws& posterior);

struct ReleaseStartSettings {
  std::optional<double> drop_height;     ///< m
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
};

/// Settings of an ensemble member, without ground parameters.
struct EnsembleMemberSettings {
  std::vector<ReleaseStartSettings> starts;  ///< one per release set
  StiffnessOptions stiffness;
};

/// Returns the settings of all members. There is a single entry if they are equal.
std::vector<EnsembleMemberSettings> sample_member_settings(const Campaign& campaign);

/// Returns the settings of the campaign, or the medians of the posterior if there is one.
EnsembleMemberSettings central_member_settings(const Campaign& campaign);

}  // namespace clast::study_detail
