#include "study/simulate/detail/member_settings.hpp"

#include <algorithm>
#include <numeric>

#include "core/random.hpp"
#include "core/statistics/statistics.hpp"
#include "study/campaign/calibratable_parameter.hpp"
#include "study/campaign/named_seed.hpp"

namespace clast::study_detail {
namespace {

/// Starts and contact of a campaign, without points and orientations.
Campaign without_points(const Campaign& campaign) {
  Campaign bare;
  bare.stiffness = campaign.stiffness;
  for (const ReleaseSet& release : campaign.releases) {
    ReleaseSet start;
    start.drop_height = release.drop_height;
    start.velocity = release.velocity;
    start.angular_velocity = release.angular_velocity;
    bare.releases.push_back(start);
  }
  return bare;
}

EnsembleMemberSettings settings_of(const Campaign& bare) {
  EnsembleMemberSettings settings{{}, bare.stiffness};
  for (const ReleaseSet& release : bare.releases) {
    settings.starts.push_back({release.drop_height, release.velocity, release.angular_velocity});
  }
  return settings;
}

bool has_settings(const PosteriorDraws& posterior) {
  return !std::all_of(posterior.parameters.begin(), posterior.parameters.end(),
                      is_ground_parameter);
}

EnsembleMemberSettings settings_of(Campaign bare, const PosteriorDraws& posterior,
                                   std::size_t draw) {
  for (std::size_t i = 0; i < posterior.parameters.size(); ++i) {
    if (is_ground_parameter(posterior.parameters[i])) continue;
    set_parameter(bare, posterior.parameters[i], posterior.draws[draw][i]);
  }
  return settings_of(bare);
}

}  // namespace

std::vector<std::size_t> choose_posterior_draw_indices(const Ensemble& ensemble) {
  if (!ensemble.posterior) return {};
  std::vector<std::size_t> order(ensemble.posterior->draws.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(derive_seed(ensemble.seed, "posterior"));
  for (std::uint32_t member = 0; member < ensemble.members; ++member) {
    std::swap(order[member], order[member + random.uniform_index(order.size() - member)]);
  }
  order.resize(ensemble.members);
  return order;
}

PosteriorDraws compute_posterior_medians(const PosteriorDraws& posterior) {
  PosteriorDraws middle{posterior.file, posterior.parameters, {{}}};
  for (std::size_t i = 0; i < posterior.parameters.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<double>& draw : posterior.draws) values.push_back(draw[i]);
    std::sort(values.begin(), values.end());
    middle.draws.front().push_back(quantile(values, 0.5));
  }
  return middle;
}

std::vector<EnsembleMemberSettings> sample_member_settings(const Campaign& campaign) {
  const Campaign bare = without_points(campaign);
  const std::optional<PosteriorDraws>& posterior = campaign.ensemble.posterior;
  if (!posterior || !has_settings(*posterior)) return {settings_of(bare)};
  std::vector<EnsembleMemberSettings> settings;
  for (const std::size_t draw : choose_posterior_draw_indices(campaign.ensemble)) {
    settings.push_back(settings_of(bare, *posterior, draw));
  }
  return settings;
}

EnsembleMemberSettings central_member_settings(const Campaign& campaign) {
  const Campaign bare = without_points(campaign);
  const std::optional<PosteriorDraws>& posterior = campaign.ensemble.posterior;
  return posterior ? settings_of(bare, compute_posterior_medians(*posterior), 0)
                   : settings_of(bare);
}

}  // namespace clast::study_detail
