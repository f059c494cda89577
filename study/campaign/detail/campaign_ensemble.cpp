// [ensemble] of a campaign file.
#include <algorithm>
#include <set>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/statistics/sobol_sequence.hpp"
#include "study/campaign/calibratable_parameter.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast::study_detail {
namespace {

std::size_t uncertain_numbers(const std::map<std::string, GroundDistributions>& ground) {
  std::size_t count = 0;
  for (const auto& [zone, table] : ground) {
    for (const GroundParameterField& field : ground_parameter_fields()) {
      const std::optional<Distribution>& asked = table.*field.distribution;
      if (asked && !asked->is_fixed()) ++count;
    }
  }
  return count;
}

std::size_t uncertain_numbers(const Campaign& campaign) {
  std::size_t count = uncertain_numbers(campaign.ground);
  for (const BlockGroup& group : campaign.groups) count += uncertain_numbers(group.ground);
  return count;
}

/// "release" of "release.height_m".
std::string make_table(const std::string& parameter) {
  return parameter.substr(0, parameter.find('.'));
}

std::vector<std::string> quoted_names(const std::set<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back("\"" + name + "\"");
  return all;
}

/// The tables whose values come from the posterior: those of `take`, or the ground where the
/// posterior has nothing else.
std::set<std::string> taken_tables(const DeclaredTable& table, const PosteriorDraws& posterior) {
  std::set<std::string> there;  // that members can take
  for (const std::string& parameter : posterior.parameters) {
    if (!is_block_parameter(parameter)) there.insert(make_table(parameter));
  }
  const std::string same_blocks =
      "members of an ensemble have the same blocks; write the calibrated values into [blocks] "
      "draw, and leave ";
  if (there.empty()) {
    table.refuse("posterior", *table.find("posterior"),
                 "has " + comma_separated(posterior.parameters) + " alone, and " + same_blocks +
                     "posterior out");
  }
  const std::optional<std::vector<std::string>> take = table.read_text_list("take");
  if (!take) {
    for (const std::string& parameter : posterior.parameters) {
      if (is_ground_parameter(parameter)) continue;
      table.refuse("posterior",
                   "was calibrated with " + parameter +
                       " too; name the tables whose parameters come from it: take = [" +
                       comma_separated(quoted_names(there)) +
                       "], or fewer; the other tables remain as in the campaign");
    }
    return there;
  }
  const TomlNode& node = *table.find("take");
  const std::vector<std::string>& known = table.value_format("take").innermost_format().words;
  for (const std::string& name : *take) {
    if (name == "blocks") {
      table.refuse("take", node, same_blocks + "\"blocks\" out");
    }
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      table.refuse("take", node, "\"" + name + "\" is none of " + comma_separated(known));
    }
    if (!there.contains(name)) {
      table.refuse("take", node,
                   "the posterior has no parameter of \"" + name + "\", but " +
                       comma_separated(posterior.parameters));
    }
  }
  return {take->begin(), take->end()};
}

/// The parameters of these tables alone.
PosteriorDraws only(const std::set<std::string>& tables, const PosteriorDraws& all) {
  PosteriorDraws taken{all.file, {}, std::vector<std::vector<double>>(all.draws.size())};
  for (std::size_t i = 0; i < all.parameters.size(); ++i) {
    if (!tables.contains(make_table(all.parameters[i]))) continue;
    taken.parameters.push_back(all.parameters[i]);
    for (std::size_t draw = 0; draw < all.draws.size(); ++draw) {
      taken.draws[draw].push_back(all.draws[draw][i]);
    }
  }
  return taken;
}

/// @throws InputError  a value that no campaign may have
void check_values(const TomlTable& table, const PosteriorDraws& posterior) {
  for (std::size_t i = 0; i < posterior.parameters.size(); ++i) {
    const std::string& parameter = posterior.parameters[i];
    const auto check = [&] {
      const NumberRange allowed = calibratable_range(parameter);
      for (const std::vector<double>& draw : posterior.draws) {
        if (allowed.contains(draw[i])) continue;
        throw InputError("has a draw of " + format_significant(draw[i], 6) + ", which must be " +
                         allowed.describe());
      }
    };
    table.run_check("posterior", check, parameter + " ");
  }
}

PosteriorDraws read_posterior(const DeclaredTable& table, const Campaign& campaign,
                              const Ensemble& ensemble) {
  const TomlNode& node = *table.find("posterior");
  const PosteriorDraws all = read_posterior_draws(*table.value<std::filesystem::path>("posterior"));
  PosteriorDraws taken = only(taken_tables(table, all), all);
  check_values(table, taken);
  const auto is_in_campaign = [&](const std::string& parameter) {
    return !is_ground_parameter(parameter) || has_parameter(campaign, parameter);
  };
  if (std::none_of(taken.parameters.begin(), taken.parameters.end(), is_in_campaign)) {
    table.refuse("posterior", node,
                 "has no parameter of this ground, but " + comma_separated(all.parameters));
  }
  if (ensemble.members > taken.draws.size()) {
    table.refuse("members", *table.find("members"),
                 "exceeds the " + std::to_string(taken.draws.size()) + " draws of the posterior");
  }
  return taken;
}

Ensemble::Design design_named(const std::string& word) {
  return word == "sobol" ? Ensemble::Design::kSobol : Ensemble::Design::kRandom;
}

}  // namespace

const MemberTable<Ensemble>& ensemble_keys() {
  static const ValueFormat taken = word_format({"ground", "contact", "release"});
  static const MemberTable<Ensemble> keys(
      {.name = "ensemble", .meaning = "Number of draws of uncertain parameters"},
      {{"members", "", "number of draws",
        required_format("a whole number of draws", count_format(1, kMaxItemsPerSet)),
        &Ensemble::members},
       {"seed", "", "seed of the draws", seed_format(), &Ensemble::seed},
       {"design", "", "random draws, or an even distribution over the parameter space",
        word_format({"random", "sobol"}), &design_named, &Ensemble::design},
       {"posterior", "", "posterior file from which the members take their draws", text_format()},
       {"take", "", "tables whose parameters come from the posterior", one_or_more_format(taken)}});
  return keys;
}

Ensemble read_ensemble(const TomlTable& top, const Campaign& campaign) {
  const bool anything = uncertain_numbers(campaign) > 0;
  if (!top.find("ensemble")) {
    if (anything) {
      throw InputError(top.file() +
                       ": ground parameters are uncertain; give the number of draws with "
                       "[ensemble] members = N");
    }
    return {};
  }
  const DeclaredTable table = find_required_table(top, ensemble_keys());
  Ensemble ensemble;
  ensemble_keys().read(table, ensemble);
  if (!anything && !table.find("posterior")) {
    table.refuse(
        "no ground parameter is uncertain; write for example friction = { uniform = [0.5, 0.8] }");
  }
  if (table.find("take") && !table.find("posterior")) {
    table.refuse("take", "applies to a posterior; name its file as posterior");
  }
  if (ensemble.design == Ensemble::Design::kSobol) {
    const std::size_t numbers = uncertain_numbers(campaign);
    if (numbers > kMaxSobolDimensions) {
      table.refuse("design", "distributes at most " + std::to_string(kMaxSobolDimensions) +
                                 " uncertain parameters evenly, but there are " +
                                 std::to_string(numbers) + "; fix some, or leave design out");
    }
  }
  if (table.find("posterior")) ensemble.posterior = read_posterior(table, campaign, ensemble);
  return ensemble;
}

void check_posterior_parameters(const TomlTable& top, const Campaign& campaign) {
  if (!campaign.ensemble.posterior) return;
  const DeclaredTable table = find_required_table(top, ensemble_keys());
  for (const std::string& parameter : campaign.ensemble.posterior->parameters) {
    if (!is_release_parameter(parameter)) continue;
    if (campaign.persistent_blocks && !campaign.persistent_blocks->masses.empty()) {
      table.refuse("take", "the blocks of a mass start at rest, but the posterior has " +
                               parameter + "; leave \"release\" out");
    }
    if (has_parameter(campaign, parameter)) continue;
    table.refuse("take",
                 "the posterior has " + parameter +
                     ", but a release of this campaign has fixed start heights; give it height_m, "
                     "or leave \"release\" out");
  }
}

}  // namespace clast::study_detail
