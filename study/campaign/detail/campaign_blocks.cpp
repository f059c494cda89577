// [blocks], [[block_group]] and [ground.NAME] of a campaign file.
#include <algorithm>
#include <cmath>

#include "classify/schemes.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast::study_detail {
namespace {

// Shares written with three digits add up to one within this.
constexpr double kShareSum = 2e-3;

/// `select` of a table.
ValueFormat selection() {
  return alternative_formats(
      {text_format(), list_format(text_format(), 1),
       table_format({{"scheme", "", "scheme of shape classes",
                      required_format("\"garcia\", \"sneed-folk\" or \"zingg\"",
                                      word_format(kSelectingSchemes))},
                     {"class", "", "a class of the scheme",
                      required_format("a class of the scheme", text_format())}})});
}

BlockFilter read_filter(const DeclaredTable& table) {
  BlockFilter filter;
  const TomlNode& select = *table.find("select");
  if (select.kind == TomlNode::Kind::kTable) {
    const DeclaredTable by_class = table.inner_table("select");
    by_class.check_required_keys();
    by_class.read("scheme", filter.scheme);
    filter.shape_class = *read_choice(by_class, "class", class_names(filter.scheme));
    return filter;
  }
  filter.ids = *table.read_text_list("select");
  for (std::size_t i = 0; i < filter.ids.size(); ++i) {
    const auto here = filter.ids.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(filter.ids.begin(), here, *here) != here) {
      table.refuse("select", element(select, i), "the block is named twice");
    }
  }
  return filter;
}

BlockScaling read_scale(const DeclaredTable& table) {
  const TomlNode& node = *table.find("scale");
  if (node.kind == TomlNode::Kind::kString && node.text == "equal-mass") {
    return {BlockScaling::Kind::kEqualMass, 0.0};
  }
  if (node.kind != TomlNode::Kind::kTable || node.table.size() != 1) {
    table.refuse("scale", node, "must be \"equal-mass\", { mass_kg = M } or { volume_m3 = V }");
  }
  const DeclaredTable scale = table.inner_table("scale");
  if (const std::optional<double> mass = scale.value<double>("mass_kg")) {
    return {BlockScaling::Kind::kMass, *mass};
  }
  return {BlockScaling::Kind::kVolume, *scale.value<double>("volume_m3")};
}

/// @param draw  with its scheme
void read_shares(const DeclaredTable& table, BlockSampling& draw) {
  const TomlNode& node = *table.find("shares");
  const TomlTable shares(node, table.file(), "[blocks] draw shares", class_names(draw.scheme));
  double sum = 0.0;
  for (const std::string& name : class_names(draw.scheme)) {
    const std::optional<double> share = shares.read_number(name, kClassFractionRange);
    if (!share || *share == 0.0) continue;
    draw.shares.emplace_back(name, *share);
    sum += *share;
  }
  if (!(std::abs(sum - 1.0) <= kShareSum)) {
    table.refuse("shares", node,
                 "the fractions must add up to 1, not " + format_significant(sum, 6));
  }
  for (auto& [name, share] : draw.shares) share /= sum;
}

const MemberTable<BlockSampling>& draw_keys() {
  static const MemberTable<BlockSampling> keys(
      {"blocks.draw", "Blocks drawn from those selected"},
      {{"count", "", "number of drawn blocks", count_format(1, kMaxItemsPerSet),
        &BlockSampling::count},
       {"volume_m3", "m^3", "mean total volume of rock; replaces count", number_format({1e-9, 1e9}),
        &BlockSampling::volume},
       {"seed", "", "seed of the draw", seed_format(), &BlockSampling::seed},
       {"scheme", "", "scheme of the classes in shares", word_format(kSelectingSchemes),
        &BlockSampling::scheme},
       {"shares", "", "fraction of each class; the sum must be 1",
        named_table_format(number_format(kClassFractionRange)), &read_shares},
       {"mass_kg", "kg", "mass of a drawn block; default: that of its library block",
        uncertain_number_format(kBlockMassRange), &BlockSampling::mass}});
  return keys;
}

BlockSampling read_draw(const DeclaredTable& blocks) {
  blocks.refuse_if_present("scale", "drawn blocks are scaled by mass_kg of draw; leave scale out");
  const DeclaredTable table = blocks.inner_table("draw");
  BlockSampling draw;
  draw_keys().read(table, draw);
  if (!draw.volume) {
    table.require_key("count", "a whole number of blocks; or give volume_m3 instead");
  } else {
    table.refuse_if_present("count", "contradicts volume_m3; keep one of the two");
  }
  return draw;
}

/// Keys of a ground zone.
/// @param complete  what every zone must have is required
MemberTable<GroundDistributions> zone_keys(bool complete) {
  std::vector<MemberKey<GroundDistributions>> keys;
  for (const GroundParameterField& field : ground_parameter_fields()) {
    ValueFormat form = uncertain_number_format(field.range);
    if (complete && field.required) {
      form = required_format(field.meaning + (", " + field.range.describe()), std::move(form));
    }
    keys.push_back(
        {field.name, field.unit, field.explanation(), std::move(form), field.distribution});
  }
  return {{"ground", "Contact parameters of a ground zone", KeyTable::Repeat::kNamed, {}, true},
          std::move(keys)};
}

const MemberTable<GroundDistributions>& group_ground_keys() {
  static const MemberTable<GroundDistributions> keys = zone_keys(false);
  return keys;
}

template <class Test>
bool any_field(const Test& test) {
  return std::any_of(ground_parameter_fields().begin(), ground_parameter_fields().end(), test);
}

/// The tables of a table [ground], by zone.
std::map<std::string, GroundDistributions> read_zones(
    const TomlNode& node, const std::string& file, const std::string& title,
    const MemberTable<GroundDistributions>& keys) {
  std::vector<std::string> names;
  for (const auto& [name, value] : node.table) names.push_back(name);
  const TomlTable all(node, file, "[" + title + "]", names);
  if (names.empty()) all.refuse("empty; write one table [" + title + ".NAME] per zone");
  std::map<std::string, GroundDistributions> ground;
  for (const auto& [name, value] : node.table) {
    all.run_check(name, [&] { check_zone_name(name); });
    if (value.kind != TomlNode::Kind::kTable) {
      all.refuse(name, value, "must be in the table of a zone, [" + title + ".NAME]");
    }
    keys.read(DeclaredTable(value, file, "[" + title + "." + name + "]", keys), ground[name]);
  }
  return ground;
}

}  // namespace

const MemberTable<BlockSelection>& blocks_keys() {
  static const MemberTable<BlockSelection> keys(
      {.name = "blocks", .meaning = "Blocks that are simulated, and their size", .required = true},
      {{"library", "", "block library (HDF5)",
        required_format("a block library made by clast reconstruct", text_format()),
        &BlockSelection::library},
       {"select", "", "ids, simulated in this order, or a class; default: all blocks", selection(),
        &read_filter, &BlockSelection::filter},
       {"scale", "", "size to which every block is scaled; shape and density stay the same",
        alternative_formats(
            {word_format({"equal-mass"}),
             table_format({{"mass_kg", "kg", "mass of every block",
                            required_format("a mass", number_format(kBlockMassRange))}}),
             table_format({{"volume_m3", "m^3", "volume of every block",
                            required_format("a volume", number_format(kBlockVolumeRange))}})}),
        &read_scale, &BlockSelection::scale},
       {"allow_any_size", "", "also accept blocks of unusual size", flag_format(),
        &BlockSelection::any_size},
       {"draw", "", "blocks drawn from those selected", table_format(draw_keys().keys), &read_draw,
        &BlockSelection::draw},
       {"vary", "", "bodies made from the selected blocks, which replace them",
        table_format(vary_keys().keys), &read_variation_request, &BlockSelection::vary}});
  return keys;
}

const MemberTable<GroundDistributions>& ground_keys() {
  static const MemberTable<GroundDistributions> keys = zone_keys(true);
  return keys;
}

const MemberTable<BlockGroup>& block_group_keys() {
  static const MemberTable<BlockGroup> keys(
      {"block_group", "Blocks with other ground parameters", KeyTable::Repeat::kEither},
      {{"name", "", "name of the group", required_format("a text in quotes", text_format()),
        &BlockGroup::name},
       {"select", "", "ids, or a class",
        required_format("ids, or { scheme = ..., class = ... }", selection()), &read_filter,
        &BlockGroup::filter},
       {"ground", "", "the parameters that differ, for each zone",
        required_format("a table of zones, [block_group.ground.NAME]",
                        named_table_format(table_format(group_ground_keys().keys)))}});
  return keys;
}

BlockSelection read_block_selection(const TomlTable& top) {
  BlockSelection blocks;
  blocks_keys().read(find_required_table(top, blocks_keys()), blocks);
  return blocks;
}

std::map<std::string, GroundDistributions> read_ground_distributions(const TomlTable& top) {
  const TomlNode* node = top.find("ground");
  if (!node) {
    throw InputError(top.file() + ": no ground: write one table [ground.NAME] per zone");
  }
  return read_zones(*node, top.file(), "ground", ground_keys());
}

std::vector<BlockGroup> read_block_groups(const TomlTable& top, const Campaign& campaign) {
  std::vector<BlockGroup> groups;
  for (const DeclaredTable& table : find_tables(top, block_group_keys())) {
    BlockGroup group;
    block_group_keys().read(table, group);
    check_unique_name(table, group.name, groups, "block group");
    const TomlNode& ground = *table.find("ground");
    group.ground = read_zones(ground, top.file(), "block_group.ground", group_ground_keys());
    if (std::all_of(group.ground.begin(), group.ground.end(), [](const auto& zone) {
          return !any_field([&](const GroundParameterField& field) {
            return (zone.second.*field.distribution).has_value();
          });
        })) {
      table.refuse(
          "ground names no parameter that differs; write for example ground.scree = { friction = "
          "0.5 }");
    }
    for (const auto& [zone, parameters] : group.ground) {
      if (!campaign.ground.contains(zone)) {
        table.refuse("ground." + zone, *ground.find(zone),
                     "the zone has no table [ground." + zone + "]");
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace clast::study_detail
