// [release] and [[release]] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/listed.hpp"
#include "core/number_text.hpp"
#include "core/up_axis.hpp"
#include "study/detail/campaign_ranges.hpp"
#include "study/detail/campaign_reading.hpp"
#include "study/release_points.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kKeys = {
    "name",     "points",       "orientations", "frame",
    "height_m", "velocity_m_s", "seed",         "angular_velocity_rad_s",
    "sequence", "realisations", "order",        "remove"};

std::vector<Vec3> read_release_points(const TomlTable& table, bool y_up, ReleasePlan& plan) {
  const std::string expected =
      "a point file, a list [[x, y, z], ...], { line = [...], count = N } or { polygon = [...], "
      "count = N }";
  const TomlNode& node = table.required("points", expected);
  const bool plan_only = plan.drop_height.has_value();
  const auto point_of = [&](const TomlTable& from, const std::string& key, const TomlNode& row) {
    const std::vector<double> values =
        from.numbers(key, row, plan_only ? 2 : 3, 3,
                     plan_only ? "points of finite numbers, [x, y] or [x, y, z]"
                               : "points of three finite numbers, [x, y, z]; [x, y] needs height_m",
                     kMapCoordinate);
    return Vec3(values[0], values[1], values.size() == 3 ? values[2] : 0.0);
  };
  const auto points_of = [&](const TomlTable& from, const std::string& key, const TomlNode& list,
                             std::size_t least) {
    if (list.kind != TomlNode::Kind::kList || list.list.size() < least) {
      from.refuse(key, list, "must be a list of at least " + std::to_string(least) + " points");
    }
    std::vector<Vec3> points;
    for (const TomlNode& row : list.list) points.push_back(point_of(from, key, row));
    return points;
  };
  if (node.kind == TomlNode::Kind::kString) {
    table.text("points");
    const fs::path file = input_file(table, "points", node);
    std::vector<Vec3> points = read_points(file);
    if (y_up) {
      for (Vec3& point : points) point = turned_z_up(point);
    }
    plan.files.push_back(file);
    return points;
  }
  if (node.kind == TomlNode::Kind::kList) return points_of(table, "points", node, 1);
  if (node.kind != TomlNode::Kind::kTable) table.refuse("points", node, "must be " + expected);

  const TomlTable rule(node, table.file(), "[release] points",
                       {"line", "polygon", "count", "seed"});
  const TomlNode* line = rule.find("line");
  const TomlNode* polygon = rule.find("polygon");
  if (!line == !polygon) rule.refuse("needs either line or polygon");
  rule.required("count", "how many points, a whole number");
  const std::size_t count = *rule.count("count", 1, kMostPerSet);
  if (line) {
    if (const TomlNode* seed = rule.find("seed")) {
      rule.refuse("seed", *seed, "points on a line are evenly spaced and need no seed");
    }
    const std::vector<Vec3> corners = points_of(rule, "line", *line, 2);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](const Vec3& corner) { return corner == corners.front(); })) {
      rule.refuse("line", *line, "all its points are the same, so it has no length");
    }
    return points_on_line(corners, count);
  }
  if (!plan_only) rule.refuse("a polygon gives plan positions and needs height_m");
  std::vector<Vec2> corners;
  for (const Vec3& point : points_of(rule, "polygon", *polygon, 3)) {
    corners.push_back(point.head<2>());
  }
  try {
    return points_in_polygon(corners, count, rule.count("seed", 0, INT64_MAX).value_or(plan.seed));
  } catch (const InputError& error) {
    rule.refuse("polygon", *polygon, error.what());
  }
}

void read_orientation_set(const TomlTable& table, bool y_up, ReleasePlan& plan) {
  const std::string expected = "\"grid-45\", a quaternion file, or { random = N, seed = S }";
  const TomlNode& node = table.required("orientations", expected);
  const std::optional<std::string> frame = choice(table, "frame", {"source", "principal"});
  plan.in_principal_frame = frame == "principal";
  if (node.kind == TomlNode::Kind::kTable) {
    const TomlTable rule(node, table.file(), "[release] orientations", {"random", "seed", "fresh"});
    rule.required("random", "how many orientations, a whole number");
    plan.orientation_source = "random";
    plan.orientation_seed = rule.count("seed", 0, INT64_MAX).value_or(plan.seed);
    plan.orientations =
        random_orientations(*rule.count("random", 1, kMostPerSet), plan.orientation_seed);
    plan.fresh_orientations = rule.boolean("fresh").value_or(false);
    return;
  }
  if (node.kind != TomlNode::Kind::kString)
    table.refuse("orientations", node, "must be " + expected);
  plan.orientation_source = *table.text("orientations");
  if (plan.orientation_source == "grid-45") {
    if (frame == "source") {
      table.refuse("frame", *table.find("frame"),
                   "the orientations of grid-45 turn the principal frame; leave frame out");
    }
    plan.in_principal_frame = true;
    plan.orientations = grid_45_orientations();
    return;
  }
  if (fs::path(plan.orientation_source).extension().empty() &&
      !fs::exists(fs::path(table.file()).parent_path() / plan.orientation_source)) {
    table.refuse("orientations", node, "must be " + expected + "; there is no file of this name");
  }
  const fs::path file = input_file(table, "orientations", node);
  plan.orientations = read_orientations(file);
  if (y_up) {
    for (Quat& orientation : plan.orientations) orientation = turned_z_up(orientation);
  }
  plan.files.push_back(file);
}

Vec3 start_rate(const TomlTable& table, const std::string& key, double most) {
  const Vec3 rate = table.vec3(key, {-most, most}).value_or(Vec3::Zero());
  if (rate.norm() > most) {
    table.refuse(key, *table.find(key),
                 "must be " + with_digits(most, 6) + " in size at most; check the units");
  }
  return rate;
}

ReleasePlan read_release(const TomlTable& table, bool y_up) {
  ReleasePlan plan;
  plan.name = table.text("name").value_or("");
  plan.seed = table.count("seed", 0, INT64_MAX).value_or(plan.seed);
  plan.drop_height = table.number("height_m", kDropHeight);
  plan.velocity = start_rate(table, "velocity_m_s", kMostSpeed);
  plan.angular_velocity = start_rate(table, "angular_velocity_rad_s", kMostSpin);
  plan.points = read_release_points(table, y_up, plan);
  read_orientation_set(table, y_up, plan);
  return plan;
}

}  // namespace

std::vector<ReleasePlan> read_releases(const TomlTable& top, bool y_up) {
  const std::vector<const TomlNode*> nodes = tables_of(top, "release");
  if (nodes.empty()) {
    throw InputError(
        top.file() +
        ": the table [release] is missing; add it with points = FILE or a list of them");
  }
  std::vector<ReleasePlan> releases;
  for (const TomlNode* node : nodes) {
    const TomlTable table(*node, top.file(), "[release]", kKeys);
    if (nodes.size() > 1) table.required("name", "a text in quotes, since there are several");
    releases.push_back(read_release(table, y_up));
    for (std::size_t i = 0; i + 1 < releases.size(); ++i) {
      if (releases[i].name == releases.back().name) {
        table.refuse("name", *table.find("name"), "another release set has this name");
      }
    }
  }
  return releases;
}

namespace {

/// Names of zones in `remove = { zone = ... }`; none without it.
std::vector<std::string> read_cleared_zones(const TomlTable& table, const Campaign& campaign) {
  const TomlNode* node = table.find("remove");
  if (!node) return {};
  if (node->kind != TomlNode::Kind::kTable) {
    table.refuse("remove", *node, "must be { zone = \"NAME\" } or { zone = [\"NAME\", ...] }");
  }
  const TomlTable rule(*node, table.file(), "[release] remove", {"zone"});
  const TomlNode& zone = rule.required("zone", "the name of a ground zone, or a list of names");
  const std::vector<std::string> names = *rule.texts("zone");
  for (const std::string& name : names) {
    if (std::count(names.begin(), names.end(), name) > 1) {
      rule.refuse("zone", zone, "names \"" + name + "\" more than once");
    }
    if (campaign.ground.contains(name)) continue;
    std::vector<std::string> known;
    for (const auto& [of_table, parameters] : campaign.ground) known.push_back(of_table);
    rule.refuse("zone", zone, "\"" + name + "\" is no ground zone; zones are " + listed(known));
  }
  return names;
}

}  // namespace

std::optional<StayPlan> read_stay_plan(const TomlTable& top, const Campaign& campaign) {
  const std::vector<const TomlNode*> nodes = tables_of(top, "release");
  const TomlTable table(*nodes.front(), top.file(), "[release]", kKeys);
  const bool stay = choice(table, "sequence", {"single", "stay"}) == "stay";
  const TomlNode* contact = top.find("contact");
  const TomlNode* between = contact ? contact->find("blocks") : nullptr;
  if (!stay) {
    for (const char* key : {"realisations", "order", "remove"}) {
      if (const TomlNode* node = table.find(key)) {
        table.refuse(key, *node, "is for blocks that stay; add sequence = \"stay\"");
      }
    }
    if (between) {
      throw InputError(top.file() +
                       ": [contact.blocks] is for blocks that stay; add sequence = "
                       "\"stay\" to [release], or leave it out");
    }
    return std::nullopt;
  }
  const TomlNode& sequence = *table.find("sequence");
  if (nodes.size() > 1) {
    table.refuse("sequence", sequence,
                 "blocks that stay come from one [release]; put all points into one");
  }
  if (!campaign.groups.empty()) {
    table.refuse("sequence", sequence,
                 "blocks that stay share one ground; leave the block groups out");
  }
  if (!between) {
    throw InputError(top.file() +
                     ": blocks that stay hit each other; add [contact.blocks] with "
                     "energy_restitution, friction and rolling_friction");
  }
  StayPlan plan;
  plan.realisations =
      static_cast<std::uint32_t>(table.count("realisations", 1, kMostPerSet).value_or(1));
  const std::optional<std::string> order = choice(table, "order", {"random", "listed"});
  plan.random_order = order != "listed";
  if (!plan.random_order && campaign.blocks.draw) {
    table.refuse("order", *table.find("order"),
                 "drawn blocks are in no order; leave it out, or select blocks by their ids");
  }
  plan.cleared_zones = read_cleared_zones(table, campaign);
  const TomlTable parameters(*between, top.file(), "[contact.blocks]",
                             {"energy_restitution", "friction", "rolling_friction"});
  const auto number = [&](const char* key, const NumberRange& range) {
    parameters.required(key, range.words());
    return *parameters.number(key, range);
  };
  plan.between_blocks = {number("energy_restitution", kEnergyRestitution),
                         number("friction", kFriction), number("rolling_friction", kFriction)};
  return plan;
}

}  // namespace clast::study_detail
