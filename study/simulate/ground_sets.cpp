#include "study/simulate/ground_sets.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/random.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/campaign/named_seed.hpp"
#include "study/simulate/detail/member_settings.hpp"

namespace clast::study_detail {
namespace {

using Values = std::map<std::string, GroundParameters>;  ///< by zone

void check_zone_parameters(const Campaign& campaign, const std::vector<std::string>& zones) {
  std::vector<std::string> tables;
  for (const auto& [name, parameters] : campaign.ground) tables.push_back("[ground." + name + "]");
  for (const std::string& zone : zones) {
    if (campaign.ground.contains(zone)) continue;
    throw InputError(campaign.file.string() + ": terrain zone \"" + zone +
                     "\" has no parameters; add [ground." + zone + "] to " +
                     comma_separated(tables));
  }
  for (const auto& [name, parameters] : campaign.ground) {
    if (std::find(zones.begin(), zones.end(), name) != zones.end()) continue;
    throw InputError(campaign.file.string() + ": [ground." + name +
                     "] belongs to no zone of the terrain; its zones are " +
                     comma_separated(zones));
  }
}

// Puts the values of all that the tables name over `values`, each taken from its law by `take`.
void put(const std::map<std::string, GroundDistributions>& tables,
         const std::function<double(const Distribution&)>& take, Values& values) {
  for (const auto& [zone, table] : tables) {
    GroundParameters& parameters = values[zone];
    for (const GroundParameterField& field : ground_parameter_fields()) {
      if (table.*field.distribution) parameters.*field.value = take(*(table.*field.distribution));
    }
  }
}

/// Puts the values of a draw over those that the campaign has.
void put(const PosteriorDraws& posterior, std::size_t draw, Values& values) {
  for (std::size_t i = 0; i < posterior.parameters.size(); ++i) {
    for (auto& [zone, parameters] : values) {
      for (const GroundParameterField& field : ground_parameter_fields()) {
        if (posterior.parameters[i] != "ground." + zone + "." + field.name) continue;
        parameters.*field.value = posterior.draws[draw][i];
      }
    }
  }
}

/// One coordinate for each uncertain parameter, of blocks in no group first; none where members
/// are drawn by chance.
std::optional<SobolSequence> sobol_design(const Campaign& campaign) {
  if (campaign.ensemble.design != Ensemble::Design::kSobol) return std::nullopt;
  std::size_t coordinates = 0;
  const auto count = [&](const Distribution& number) {
    coordinates += number.is_fixed() ? 0 : 1;
    return 0.0;
  };
  Values values;
  put(campaign.ground, count, values);
  for (const BlockGroup& group : campaign.groups) put(group.ground, count, values);
  if (coordinates == 0) return std::nullopt;
  return SobolSequence(coordinates, campaign.ensemble.seed);
}

/// Soil remembers from one release to the next, and only what a law leaves in it.
/// @throws InputError  there is nothing to remember
void check_soil_memory(const Campaign& campaign) {
  const bool stays = campaign.persistent_blocks.has_value();
  if (stays && std::holds_alternative<ElastoplasticLaw>(campaign.stiffness.law)) return;
  throw InputError(
      stays ? "soil_memory_m needs [contact] law = \"elastoplastic\", which leaves residual "
              "indentations"
            : "soil_memory_m applies to blocks that follow each other; add [release] sequence = "
              "\"stay\", where remove = { zone = ... } removes stopped blocks");
}

/// @throws InputError  values that do not go together, such as a friction below the smallest
std::vector<GroundParameters> in_order(const Campaign& campaign, const Values& values,
                                       const std::vector<std::string>& zones) {
  std::vector<GroundParameters> ordered;
  for (const std::string& zone : zones) {
    with_error_context(campaign.file.string(), [&] {
      values.at(zone).check(zone);
      if (values.at(zone).soil_memory > 0.0) check_soil_memory(campaign);
    });
    ordered.push_back(values.at(zone));
  }
  return ordered;
}

}  // namespace

std::vector<GroundParameterSet> sample_ground_sets(const Campaign& campaign,
                                                   const std::vector<std::string>& zones) {
  check_zone_parameters(campaign, zones);
  const std::size_t groups = 1 + campaign.groups.size();
  const std::uint32_t members = campaign.ensemble.members;
  std::vector<GroundParameterSet> sets(groups * members);
  std::optional<SobolSequence> design = sobol_design(campaign);
  const std::vector<std::size_t> chosen = choose_posterior_draw_indices(campaign.ensemble);
  // Every group draws from a sequence of its own, so that no group changes what others get.
  std::vector<Random> random = {Random(campaign.ensemble.seed)};
  for (const BlockGroup& group : campaign.groups) {
    random.emplace_back(derive_seed(campaign.ensemble.seed, group.name));
  }
  for (std::uint32_t member = 0; member < members; ++member) {
    const std::vector<double> shares = design ? design->next_point() : std::vector<double>();
    auto share = shares.begin();
    Values base;
    for (std::size_t g = 0; g < groups; ++g) {
      const auto draw = [&](const Distribution& number) {
        if (!design || number.is_fixed()) return number.draw(random[g]);
        return number.quantile(*share++);
      };
      if (g == 0) {
        put(campaign.ground, draw, base);
        if (!chosen.empty()) put(*campaign.ensemble.posterior, chosen[member], base);
      }
      Values values = base;
      if (g > 0) put(campaign.groups[g - 1].ground, draw, values);
      sets[g * members + member] = {g > 0 ? campaign.groups[g - 1].name : "", member,
                                    in_order(campaign, values, zones)};
    }
  }
  return sets;
}

std::vector<GroundParameters> compute_median_ground(const Campaign& campaign,
                                                    const std::vector<std::string>& zones) {
  Values values;
  put(
      campaign.ground, [](const Distribution& number) { return number.central_value(); }, values);
  if (campaign.ensemble.posterior)
    put(compute_posterior_medians(*campaign.ensemble.posterior), 0, values);
  return in_order(campaign, values, zones);
}

}  // namespace clast::study_detail
