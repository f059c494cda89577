#pragma once
/// Settings of ensemble members that are taken from posterior draws.
#include <cstddef>
#include <vector>

#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// Chooses a random posterior draw for each ensemble member, all different. Empty without a
/// posterior.
std::vector<std::size_t> choose_posterior_draw_indices(const Ensemble& ensemble);

/// Computes the posterior medians of all parameters, returned as a single draw.
PosteriorDraws compute_posterior_medians(const PosteriorDraws& posterior);

struct ReleaseStartSettings {
  std::optional<double> drop_height;     ///< height of the release points above the ground, m
  Vec3 velocity = Vec3::Zero();          ///< initial velocity, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< initial angular velocity, rad/s
};

/// Settings of an ensemble member, without ground parameters.
struct EnsembleMemberSettings {
  std::vector<ReleaseStartSettings> starts;  ///< start settings of each release set
  StiffnessOptions stiffness;
};

/// Returns the settings of all ensemble members; a single entry if they are equal.
std::vector<EnsembleMemberSettings> sample_member_settings(const Campaign& campaign);

/// Returns the settings of the campaign, with posterior medians of calibrated parameters.
EnsembleMemberSettings central_member_settings(const Campaign& campaign);

}  // namespace clast::study_detail
