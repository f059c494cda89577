#pragma once
/// Settings of ensemble members taken from posterior draws.
#include <cstddef>
#include <vector>

#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// Chooses a different random draw for each member; empty without a posterior.
std::vector<std::size_t> choose_posterior_draws(const Ensemble& ensemble);

/// Returns the medians of all parameters as a single draw.
PosteriorDraws compute_posterior_medians(const PosteriorDraws& posterior);

struct ReleaseStart {
  std::optional<double> drop_height;     ///< m
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
};

/// Settings of a member other than ground parameters.
struct MemberSettings {
  std::vector<ReleaseStart> starts;  ///< one per release set
  StiffnessOptions stiffness;
};

/// Returns the settings of all members; a single entry if they are equal.
std::vector<MemberSettings> sample_member_settings(const Campaign& campaign);

/// Returns the campaign's settings, or the medians of the posterior.
MemberSettings central_settings(const Campaign& campaign);

}  // namespace clast::study_detail
