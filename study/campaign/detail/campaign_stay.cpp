// Blocks that stay: `sequence = "stay"` of [release], and [contact.blocks] of a campaign file.
#include <algorithm>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast::study_detail {

namespace {

/// Names of zones in `remove = { zone = ... }`; none without it.
std::vector<std::string> read_cleared_zones(const DeclaredTable& table, const Campaign& campaign) {
  const TomlNode* node = table.find("remove");
  if (!node) return {};
  if (node->kind != TomlNode::Kind::kTable) {
    table.refuse("remove", *node, "must be { zone = \"NAME\" } or { zone = [\"NAME\", ...] }");
  }
  const DeclaredTable rule = table.inner_table("remove");
  const TomlNode& zone = rule.require_key("zone");
  const std::vector<std::string> names = *rule.read_text_list("zone");
  for (const std::string& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1) {
      rule.refuse("zone", zone, "names \"" + name + "\" more than once");
    }
    if (campaign.ground.contains(name)) continue;
    std::vector<std::string> known;
    for (const auto& [of_table, parameters] : campaign.ground) known.push_back(of_table);
    rule.refuse("zone", zone,
                "\"" + name + "\" is not a ground zone; zones are " + comma_separated(known));
  }
  return names;
}

/// [contact.blocks]; none when it is absent.
const TomlNode* contact_of_blocks(const TomlTable& top) {
  const TomlNode* contact = top.find("contact");
  return contact ? contact->find("blocks") : nullptr;
}

}  // namespace

std::uint32_t read_realisations(const DeclaredTable& table) {
  return table.value<std::uint32_t>("realisations").value_or(1);
}

const MemberTable<GroundParameters>& between_blocks_keys() {
  static const MemberTable<GroundParameters> keys = [] {
    std::vector<MemberKey<GroundParameters>> all;
    for (const GroundParameterField& field : ground_parameter_fields()) {
      if (field.is_soil_parameter) continue;
      ValueFormat form = number_format(field.range);
      if (field.required) form = required_format(field.range.describe(), std::move(form));
      all.push_back({field.name, field.unit, field.explanation(), std::move(form), field.value});
    }
    return MemberTable<GroundParameters>(
        {.name = "contact.blocks", .meaning = "Contacts between two blocks"}, std::move(all));
  }();
  return keys;
}

GroundParameters read_between_blocks(const TomlTable& top, const std::string& who) {
  const TomlNode* between = contact_of_blocks(top);
  if (!between) {
    throw InputError(top.file() + ": " + who +
                     " hit each other; add [contact.blocks] with energy_restitution, friction and "
                     "rolling_friction");
  }
  GroundParameters between_blocks;
  between_blocks_keys().read(
      DeclaredTable(*between, top.file(), "[contact.blocks]", between_blocks_keys()),
      between_blocks);
  return between_blocks;
}

std::optional<PersistentBlocksPlan> read_persistent_blocks_plan(const TomlTable& top,
                                                                const Campaign& campaign) {
  if (std::optional<PersistentBlocksPlan> masses = read_multi_block_releases(top, campaign))
    return masses;
  const std::vector<DeclaredTable> tables = find_tables(top, release_keys());
  const DeclaredTable& table = tables.front();
  const bool stay = table.value<std::string>("sequence") == "stay";
  if (!stay) {
    for (const char* key : {"realisations", "order", "remove"}) {
      table.refuse_if_present(key, "applies to persistent blocks; add sequence = \"stay\"");
    }
    if (contact_of_blocks(top)) {
      throw InputError(top.file() +
                       ": [contact.blocks] applies to persistent blocks; add sequence = \"stay\" "
                       "to [release], or leave it out");
    }
    return std::nullopt;
  }
  const TomlNode& sequence = *table.find("sequence");
  if (tables.size() > 1) {
    table.refuse("sequence", sequence,
                 "persistent blocks come from one [release]; put all points into one");
  }
  if (!campaign.groups.empty()) {
    table.refuse("sequence", sequence,
                 "persistent blocks share one ground; leave the block groups out");
  }
  PersistentBlocksPlan plan;
  plan.realisations = read_realisations(table);
  plan.random_order = table.value<std::string>("order") != "listed";
  if (!plan.random_order && campaign.blocks.draw) {
    table.refuse("order",
                 "drawn blocks have no order; leave it out, or select blocks by their ids");
  }
  plan.cleared_zones = read_cleared_zones(table, campaign);
  plan.between_blocks = read_between_blocks(top, "persistent blocks");
  return plan;
}

}  // namespace clast::study_detail
