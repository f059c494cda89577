#include "study/campaign.hpp"

#include <algorithm>
#include <cstdlib>

#include "classify/schemes.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "study/release_points.hpp"
#include "study/toml_reader.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

// Far above any study, and low enough that a slip of the keyboard does not fill the memory.
constexpr std::uint64_t kMostPerSet = 1'000'000;

std::string data_folder() {
  const char* variable = std::getenv("CLAST_DATA");
  const fs::path folder = variable && *variable ? fs::path(variable) : fs::path("../shared/data");
  return fs::absolute(folder).lexically_normal().string();
}

// A file named in the campaign, which must be there.
fs::path input_file(const TomlTable& table, const std::string& key, const TomlNode& node,
                    std::string text) {
  const std::string variable = "${CLAST_DATA}";
  for (std::size_t at; (at = text.find(variable)) != std::string::npos;) {
    text.replace(at, variable.size(), data_folder());
  }
  if (text.find("${") != std::string::npos) {
    table.refuse(key, node, "only " + variable + " is replaced in paths");
  }
  const fs::path path = (fs::path(table.file()).parent_path() / text).lexically_normal();
  std::error_code code;
  if (!fs::exists(path, code)) table.refuse(key, node, "no such file: " + path.string());
  if (!fs::is_regular_file(path, code)) table.refuse(key, node, "must be a file: " + path.string());
  return path;
}

fs::path input_file(const TomlTable& table, const std::string& key, const TomlNode& node) {
  return input_file(table, key, node, node.text);
}

const TomlNode& element(const TomlNode& node, std::size_t index) {
  return node.kind == TomlNode::Kind::kList ? node.list[index] : node;
}

// One of a few words.
std::optional<std::string> choice(const TomlTable& table, const std::string& key,
                                  const std::vector<std::string>& words) {
  const std::optional<std::string> text = table.text(key);
  if (text && std::find(words.begin(), words.end(), *text) == words.end()) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + ("\"" + words[i] + "\"");
    }
    table.refuse(key, *table.find(key), "must be " + list);
  }
  return text;
}

TomlTable required_table(const TomlTable& top, const std::string& name,
                         std::vector<std::string> known_keys) {
  const TomlNode* node = top.find(name);
  if (!node) {
    throw InputError(top.file() + ": the table [" + name + "] is missing");
  }
  return {*node, top.file(), "[" + name + "]", std::move(known_keys)};
}

BlockSelection read_blocks(const TomlTable& top) {
  const TomlTable table = required_table(top, "blocks", {"library", "select"});
  BlockSelection blocks;
  const TomlNode& library = table.required("library", "a block library made by clast reconstruct");
  table.text("library");
  blocks.library = input_file(table, "library", library);
  const TomlNode* select = table.find("select");
  if (!select) return blocks;
  if (select->kind == TomlNode::Kind::kTable) {
    const TomlTable by_class(*select, top.file(), "[blocks] select", {"scheme", "class"});
    by_class.required("scheme", "\"garcia\", \"sneed-folk\" or \"zingg\"");
    blocks.scheme = *choice(by_class, "scheme", {"garcia", "sneed-folk", "zingg"});
    by_class.required("class", "a class of the scheme");
    blocks.shape_class = *choice(by_class, "class", class_names(blocks.scheme));
    return blocks;
  }
  blocks.ids = *table.texts("select");
  for (std::size_t i = 0; i < blocks.ids.size(); ++i) {
    const auto here = blocks.ids.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(blocks.ids.begin(), here, *here) != here) {
      table.refuse("select", element(*select, i), "the block is named twice");
    }
  }
  return blocks;
}

std::optional<ZoneFile> named_zone_file(const TomlTable& table, const TomlNode& node,
                                        const std::vector<std::string>& zones) {
  try {
    return zone_file(zones);
  } catch (const InputError& error) {
    table.refuse("zones", node, error.what());
  }
}

/// How the surface files are gridded, checked and mended.
void read_terrain_checks(const TomlTable& table, Campaign& campaign) {
  constexpr NumberRange kPercentile{0.0, true, 100.0, "from 0 to 100"};
  constexpr std::uint64_t kMostRounds = 1000;
  TerrainOptions& terrain = campaign.terrain;
  terrain.resolution = table.number("resolution_m", kPositive);
  terrain.percentile = table.number("percentile", kPercentile);
  terrain.outliers = table.number("outliers_m", kPositive);
  terrain.fill = table.number("fill_m", kNotNegative);
  terrain.crack = table.number("crack_m", kNotNegative).value_or(terrain.crack);
  terrain.spike_steepness =
      table.number("spike_steepness", kNotNegative).value_or(terrain.spike_steepness);
  terrain.smoothing = static_cast<int>(table.count("smoothing", 0, kMostRounds).value_or(0));
  terrain.tolerance = table.number("tolerance_m", kPositive);
  if (const TomlNode* lines = table.find("breaklines")) {
    const std::size_t count = table.texts("breaklines")->size();
    for (std::size_t i = 0; i < count; ++i) {
      terrain.breaklines.push_back(input_file(table, "breaklines", element(*lines, i)));
    }
  }
  if (const TomlNode* cut = table.find("cut_zones")) {
    if (cut->kind != TomlNode::Kind::kBoolean) {
      table.refuse("cut_zones", *cut, "must be true or false");
    }
    terrain.cut_zones = cut->boolean;
  }
  campaign.border_distance = table.number("border_distance_m", kPositive);
}

void read_terrain_table(const TomlTable& top, Campaign& campaign) {
  const TomlTable table =
      required_table(top, "terrain",
                     {"surface", "zones", "up", "radius_m", "resolution_m", "percentile",
                      "outliers_m", "fill_m", "crack_m", "spike_steepness", "smoothing",
                      "tolerance_m", "breaklines", "cut_zones", "border_distance_m"});
  const TomlNode& surface = table.required("surface", "a file or a list of files");
  const std::vector<std::string> files = *table.texts("surface");
  for (std::size_t i = 0; i < files.size(); ++i) {
    campaign.terrain.surface.push_back(input_file(table, "surface", element(surface, i)));
  }
  if (const std::optional<std::vector<std::string>> zones = table.texts("zones")) {
    const TomlNode& node = *table.find("zones");
    campaign.terrain.zones = *zones;
    if (std::optional<ZoneFile> file = named_zone_file(table, node, *zones)) {
      file->path = input_file(table, "zones", element(node, 0), file->path.string());
      campaign.terrain.zones = file->zones();
    } else if (zones->size() != files.size() && !are_zone_rules(*zones)) {
      table.refuse("zones", node,
                   "must name one zone per surface file (" + std::to_string(files.size()) +
                       "), or one zone raster or GeoJSON file, or rules by slope and height");
    }
  }
  campaign.terrain.up = choice(table, "up", {"z", "y"}).value_or("z");
  read_terrain_checks(table, campaign);
  campaign.terrain_radius = table.number("radius_m", kNotNegative).value_or(0.0);
}

std::map<std::string, GroundParameters> read_ground(const TomlTable& top) {
  const TomlNode* node = top.find("ground");
  if (!node) {
    throw InputError(top.file() + ": no ground: write one table [ground.NAME] per zone");
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : node->table) names.push_back(name);
  const TomlTable all(*node, top.file(), "[ground]", names);
  if (names.empty()) all.refuse("empty; write one table [ground.NAME] per zone");
  std::map<std::string, GroundParameters> ground;
  for (const auto& [name, value] : node->table) {
    if (value.kind != TomlNode::Kind::kTable) {
      all.refuse(name, value, "must be in the table of a zone, [ground.NAME]");
    }
    const TomlTable table(value, top.file(), "[ground." + name + "]",
                          {"energy_restitution", "friction", "rolling_friction"});
    table.required("energy_restitution", "e_n^2, more than zero and at most 1");
    table.required("friction", "mu, zero or more");
    table.required("rolling_friction", "mu_R, zero or more");
    ground[name] = {.energy_restitution = *table.number("energy_restitution", kShare),
                    .friction = *table.number("friction", kNotNegative),
                    .rolling_friction = *table.number("rolling_friction", kNotNegative)};
  }
  return ground;
}

std::vector<Vec3> read_release_points(const TomlTable& table, bool y_up, ReleasePlan& plan) {
  const std::string expected =
      "a point file, a list [[x, y, z], ...], { line = [...], count = N } or { polygon = [...], "
      "count = N }";
  const TomlNode& node = table.required("points", expected);
  const bool plan_only = plan.drop_height.has_value();
  const auto point_of = [&](const TomlTable& from, const std::string& key, const TomlNode& row) {
    const std::vector<double> values = from.numbers(
        key, row, plan_only ? 2 : 3, 3,
        plan_only ? "points of finite numbers, [x, y] or [x, y, z]"
                  : "points of three finite numbers, [x, y, z]; [x, y] needs height_m");
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
    return points_on_line(points_of(rule, "line", *line, 2), count);
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
    const TomlTable rule(node, table.file(), "[release] orientations", {"random", "seed"});
    rule.required("random", "how many orientations, a whole number");
    plan.orientation_source = "random";
    plan.orientations = random_orientations(*rule.count("random", 1, kMostPerSet),
                                            rule.count("seed", 0, INT64_MAX).value_or(plan.seed));
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
  const fs::path file = input_file(table, "orientations", node);
  plan.orientations = read_orientations(file);
  if (y_up) {
    for (Quat& orientation : plan.orientations) orientation = turned_z_up(orientation);
  }
  plan.files.push_back(file);
}

ReleasePlan read_release(const TomlTable& top, bool y_up) {
  const TomlTable table = required_table(top, "release",
                                         {"points", "orientations", "frame", "height_m",
                                          "velocity_m_s", "angular_velocity_rad_s", "seed"});
  ReleasePlan plan;
  plan.seed = table.count("seed", 0, INT64_MAX).value_or(plan.seed);
  plan.drop_height = table.number("height_m", kNotNegative);
  plan.velocity = table.vec3("velocity_m_s").value_or(Vec3::Zero());
  plan.angular_velocity = table.vec3("angular_velocity_rad_s").value_or(Vec3::Zero());
  plan.points = read_release_points(table, y_up, plan);
  read_orientation_set(table, y_up, plan);
  return plan;
}

void read_contact(const TomlTable& top, Campaign& campaign) {
  const TomlNode* node = top.find("contact");
  if (!node) return;
  const TomlTable table(*node, top.file(), "[contact]",
                        {"law", "weights", "stiffness", "stiffness_n_m", "tangential_stiffness_n_m",
                         "rolling_stiffness_n_m_rad", "time_step_s"});
  const std::optional<std::string> law = choice(table, "law", contact_law_names());
  if (const auto weights = choice(table, "weights", {"patch", "overlap", "count", "none"})) {
    campaign.weights = contact_weights(*weights);
  }
  const TomlNode* automatic = table.find("stiffness");
  if (automatic && (automatic->kind != TomlNode::Kind::kString || automatic->text != "auto")) {
    table.refuse("stiffness", *automatic, "must be \"auto\"; a value is written stiffness_n_m");
  }
  campaign.stiffness = {.normal = table.number("stiffness_n_m", kPositive),
                        .tangential = table.number("tangential_stiffness_n_m", kPositive),
                        .rolling = table.number("rolling_stiffness_n_m_rad", kPositive),
                        .time_step = table.number("time_step_s", kPositive),
                        .law = law ? contact_law(*law) : ContactLaw()};
  if (automatic && campaign.stiffness.normal) {
    table.refuse("stiffness_n_m", *table.find("stiffness_n_m"),
                 "contradicts stiffness = \"auto\"; keep one of the two");
  }
}

std::vector<Barrier> read_barriers(const TomlTable& top) {
  std::vector<Barrier> barriers;
  const TomlNode* all = top.find("barrier");
  if (!all) return barriers;
  if (all->kind != TomlNode::Kind::kList) {
    top.refuse("barrier", *all, "each barrier is a table [[barrier]]");
  }
  for (const TomlNode& node : all->list) {
    const TomlTable table(node, top.file(), "[[barrier]]", {"name", "from", "to"});
    table.required("name", "a text in quotes");
    table.required("from", "two numbers, [x, y]");
    table.required("to", "two numbers, [x, y]");
    const Barrier barrier{*table.text("name"), *table.vec2("from"), *table.vec2("to")};
    if (!((barrier.to - barrier.from).norm() > 0.0)) {
      table.refuse("to", *table.find("to"), "must differ from from");
    }
    for (const Barrier& other : barriers) {
      if (other.name == barrier.name) {
        table.refuse("name", *table.find("name"), "another barrier has this name");
      }
    }
    barriers.push_back(barrier);
  }
  return barriers;
}

void read_run(const TomlTable& top, Campaign& campaign) {
  const TomlNode* node = top.find("run");
  if (!node) return;
  const TomlTable table(*node, top.file(), "[run]",
                        {"max_time_s", "rest_energy_j_kg", "rest_duration_s", "gravity_m_s2",
                         "downslope", "trajectory_interval_s"});
  campaign.max_time = table.number("max_time_s", kPositive).value_or(campaign.max_time);
  campaign.rest_energy = table.number("rest_energy_j_kg", kPositive).value_or(campaign.rest_energy);
  campaign.rest_duration =
      table.number("rest_duration_s", kPositive).value_or(campaign.rest_duration);
  campaign.gravity = table.number("gravity_m_s2", kPositive).value_or(campaign.gravity);
  campaign.trajectory_interval =
      table.number("trajectory_interval_s", kNotNegative).value_or(campaign.trajectory_interval);
  campaign.downslope = table.vec2("downslope");
  if (campaign.downslope && !(campaign.downslope->norm() > 0.0)) {
    table.refuse("downslope", *table.find("downslope"), "must point somewhere");
  }
}

}  // namespace

Campaign read_campaign(const fs::path& file) {
  Campaign campaign;
  campaign.file = file;
  campaign.text = read_text_file(file);
  campaign.sha256 = sha256(campaign.text);
  const TomlNode root = parse_toml(campaign.text, file.string());
  const TomlTable top(root, file.string(), "",
                      {"blocks", "terrain", "ground", "release", "contact", "barrier", "run"});
  campaign.blocks = read_blocks(top);
  read_terrain_table(top, campaign);
  campaign.ground = read_ground(top);
  campaign.release = read_release(top, campaign.terrain.up == "y");
  read_contact(top, campaign);
  campaign.barriers = read_barriers(top);
  read_run(top, campaign);
  return campaign;
}

std::vector<Quat> grid_45_orientations() {
  std::vector<Quat> orientations;
  const auto turn = [](int steps, const Vec3& axis) {
    return Quat(Eigen::AngleAxisd(steps * kPi / 4.0, axis));
  };
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      for (int c = 0; c < 4; ++c) {
        orientations.push_back(turn(c, Vec3::UnitZ()) * turn(b, Vec3::UnitY()) *
                               turn(a, Vec3::UnitX()));
      }
    }
  }
  return orientations;
}

}  // namespace clast
