#pragma once
/// What members of an ensemble have from the draws of a posterior.
#include <cstddef>
#include <vector>

#include "study/campaign/campaign.hpp"

namespace clast::study_detail {

/// The number of a different draw for every member, by chance; none without a posterior.
std::vector<std::size_t> choose_posterior_draws(const Ensemble& ensemble);

/// The median of each parameter, as a single draw.
PosteriorDraws middle_of(const PosteriorDraws& posterior);

/// How the blocks of a release set start.
struct ReleaseStart {
  std::optional<double> drop_height;     ///< m
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
};

/// What is not of the ground.
struct MemberSettings {
  std::vector<ReleaseStart> starts;  ///< of each release set
  StiffnessOptions stiffness;
};

/// The settings of all members, in order; a single one where all have the same.
std::vector<MemberSettings> draw_member_settings(const Campaign& campaign);

/// Of blocks in general: the campaign's, or the medians of the posterior.
MemberSettings central_settings(const Campaign& campaign);

}  // namespace clast::study_detail
