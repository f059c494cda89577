// [blocks], [[block_group]] and [ground.NAME] of a campaign file.
#include <algorithm>
#include <cmath>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/listed.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast::study_detail {
namespace {

// Shares written with three digits add up to one within this.
constexpr double kShareSum = 2e-3;

/// `select` of a table.
BlockFilter read_filter(const TomlTable& table, const std::string& title) {
  BlockFilter filter;
  const TomlNode* select = table.find("select");
  if (!select) return filter;
  if (select->kind == TomlNode::Kind::kTable) {
    const TomlTable by_class(*select, table.file(), title + " select", {"scheme", "class"});
    by_class.required("scheme", "\"garcia\", \"sneed-folk\" or \"zingg\"");
    filter.scheme = *choice(by_class, "scheme", kSelectingSchemes);
    by_class.required("class", "a class of the scheme");
    filter.shape_class = *choice(by_class, "class", class_names(filter.scheme));
    return filter;
  }
  filter.ids = *table.texts("select");
  for (std::size_t i = 0; i < filter.ids.size(); ++i) {
    const auto here = filter.ids.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(filter.ids.begin(), here, *here) != here) {
      table.refuse("select", element(*select, i), "the block is named twice");
    }
  }
  return filter;
}

BlockScale read_scale(const TomlTable& table) {
  const TomlNode* node = table.find("scale");
  if (!node) return {};
  const std::string expected = "must be \"equal-mass\", { mass_kg = M } or { volume_m3 = V }";
  if (node->kind == TomlNode::Kind::kString && node->text == "equal-mass") {
    return {BlockScale::Kind::kEqualMass, 0.0};
  }
  if (node->kind != TomlNode::Kind::kTable || node->table.size() != 1) {
    table.refuse("scale", *node, expected);
  }
  const TomlTable scale(*node, table.file(), "[blocks] scale", {"mass_kg", "volume_m3"});
  if (const std::optional<double> mass = scale.number("mass_kg", kBlockMass)) {
    return {BlockScale::Kind::kMass, *mass};
  }
  return {BlockScale::Kind::kVolume, *scale.number("volume_m3", kBlockVolume)};
}

std::vector<std::pair<std::string, double>> read_shares(const TomlTable& draw,
                                                        const std::string& scheme) {
  const TomlNode* node = draw.find("shares");
  if (!node) return {};
  const TomlTable table(*node, draw.file(), "[blocks] draw shares", class_names(scheme));
  std::vector<std::pair<std::string, double>> shares;
  double sum = 0.0;
  for (const std::string& name : class_names(scheme)) {
    const std::optional<double> share = table.number(name, kClassShare);
    if (!share || *share == 0.0) continue;
    shares.emplace_back(name, *share);
    sum += *share;
  }
  if (!(std::abs(sum - 1.0) <= kShareSum)) {
    draw.refuse("shares", *node, "the shares must add up to 1, not " + with_digits(sum, 6));
  }
  for (auto& [name, share] : shares) share /= sum;
  return shares;
}

BlockDraw read_draw(const TomlTable& blocks, const TomlNode& node) {
  const TomlTable table(node, blocks.file(), "[blocks] draw",
                        {"count", "volume_m3", "seed", "scheme", "shares", "mass_kg"});
  BlockDraw draw;
  draw.volume = table.number("volume_m3", kDrawnVolume);
  if (!draw.volume) {
    table.required("count", "a whole number of blocks; or give volume_m3 instead");
  } else if (const TomlNode* count = table.find("count")) {
    table.refuse("count", *count, "contradicts volume_m3; keep one of the two");
  }
  draw.count = table.count("count", 1, kMostPerSet).value_or(0);
  draw.seed = table.count("seed", 0, INT64_MAX).value_or(draw.seed);
  draw.scheme = choice(table, "scheme", kSelectingSchemes).value_or(draw.scheme);
  draw.shares = read_shares(table, draw.scheme);
  draw.mass = read_uncertain(table, "mass_kg", kBlockMass);
  return draw;
}

template <class Test>
bool any_field(const Test& test) {
  return std::any_of(ground_fields().begin(), ground_fields().end(), test);
}

GroundTable read_ground_table(const TomlTable& table) {
  GroundTable ground;
  for (const GroundField& field : ground_fields()) {
    ground.*field.asked = read_uncertain(table, field.name, field.range);
  }
  return ground;
}

/// The tables of a table [ground], by zone.
std::map<std::string, GroundTable> read_zones(const TomlNode& node, const std::string& file,
                                              const std::string& title, bool complete) {
  std::vector<std::string> names;
  for (const auto& [name, value] : node.table) names.push_back(name);
  const TomlTable all(node, file, "[" + title + "]", names);
  if (names.empty()) all.refuse("empty; write one table [" + title + ".NAME] per zone");
  std::map<std::string, GroundTable> ground;
  for (const auto& [name, value] : node.table) {
    try {
      check_zone_name(name);
    } catch (const InputError& error) {
      all.refuse(printable(name), value, error.what());
    }
    if (value.kind != TomlNode::Kind::kTable) {
      all.refuse(name, value, "must be in the table of a zone, [" + title + ".NAME]");
    }
    const TomlTable table(value, file, "[" + title + "." + name + "]", campaign_keys("ground"));
    for (const GroundField& field : ground_fields()) {
      if (!complete || !field.required) continue;
      table.required(field.name, std::string(field.meaning) + ", " + field.range.words());
    }
    ground[name] = read_ground_table(table);
  }
  return ground;
}

}  // namespace

BlockSelection read_blocks(const TomlTable& top) {
  const TomlTable table = required_table(top, "blocks");
  BlockSelection blocks;
  const TomlNode& library = table.required("library", "a block library made by clast reconstruct");
  table.text("library");
  blocks.library = input_file(table, "library", library);
  blocks.filter = read_filter(table, "[blocks]");
  blocks.scale = read_scale(table);
  blocks.any_size = table.boolean("allow_any_size").value_or(false);
  if (const TomlNode* draw = table.find("draw")) {
    if (const TomlNode* scale = table.find("scale")) {
      table.refuse("scale", *scale, "drawn blocks are scaled by mass_kg of draw; leave scale out");
    }
    blocks.draw = read_draw(table, *draw);
  }
  blocks.vary = read_vary(table);
  return blocks;
}

std::map<std::string, GroundTable> read_ground(const TomlTable& top) {
  const TomlNode* node = top.find("ground");
  if (!node) {
    throw InputError(top.file() + ": no ground: write one table [ground.NAME] per zone");
  }
  return read_zones(*node, top.file(), "ground", true);
}

std::vector<BlockGroup> read_block_groups(const TomlTable& top, const Campaign& campaign) {
  std::vector<BlockGroup> groups;
  for (const TomlNode* node : tables_of(top, "block_group")) {
    const TomlTable table(*node, top.file(), "[[block_group]]", campaign_keys("block_group"));
    table.required("name", "a text in quotes");
    table.required("select", "ids, or { scheme = ..., class = ... }");
    BlockGroup group;
    group.name = *table.text("name");
    for (const BlockGroup& other : groups) {
      if (other.name == group.name) {
        table.refuse("name", *table.find("name"), "another block group has this name");
      }
    }
    group.filter = read_filter(table, "[[block_group]]");
    const TomlNode& ground =
        table.required("ground", "a table of zones, [block_group.ground.NAME]");
    group.ground = read_zones(ground, top.file(), "block_group.ground", false);
    if (std::all_of(group.ground.begin(), group.ground.end(), [](const auto& zone) {
          return !any_field(
              [&](const GroundField& field) { return (zone.second.*field.asked).has_value(); });
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
