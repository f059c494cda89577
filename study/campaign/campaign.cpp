#include "study/campaign/campaign.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "core/files/up_axis.hpp"
#include "study/campaign/barrier_line.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

std::optional<ZoneFile> named_zone_file(const TomlTable& table, const TomlNode& node,
                                        const std::vector<std::string>& zones) {
  try {
    return zone_file(zones);
  } catch (const InputError& error) {
    table.refuse("zones", node, error.what());
  }
}

/// How the surface files are gridded, checked and repaired.
void read_terrain_checks(const TomlTable& table, Campaign& campaign) {
  TerrainOptions& terrain = campaign.terrain;
  if (const auto columns = table.texts("columns")) terrain.columns = *columns;
  terrain.resolution = table.number("resolution_m", kCellSize);
  terrain.percentile = table.number("percentile", kPercentile);
  terrain.outliers = table.number("outliers_m", kOutlierDistance);
  terrain.fill = table.number("fill_m", kHoleWidth);
  terrain.crack = table.number("crack_m", kCrackWidth).value_or(terrain.crack);
  terrain.spike_steepness =
      table.number("spike_steepness", kSpikeSteepness).value_or(terrain.spike_steepness);
  terrain.smoothing = static_cast<int>(table.count("smoothing", 0, kMostSmoothing).value_or(0));
  terrain.tolerance = table.number("tolerance_m", kSurfaceTolerance);
  if (const TomlNode* lines = table.find("breaklines")) {
    const std::size_t count = table.texts("breaklines")->size();
    for (std::size_t i = 0; i < count; ++i) {
      terrain.breaklines.push_back(input_file(table, "breaklines", element(*lines, i)));
    }
  }
  terrain.cut_zones = table.boolean("cut_zones").value_or(false);
  campaign.border_distance = table.number("border_distance_m", kBorderDistance);
}

void read_terrain_table(const TomlTable& top, Campaign& campaign) {
  const TomlTable table = required_table(top, "terrain");
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
  campaign.terrain.up = campaign_choice(table, "terrain", "up").value_or("auto");
  read_terrain_checks(table, campaign);
  campaign.terrain_radius = table.number("radius_m", kGroundRadius).value_or(0.0);
}

void read_contact(const TomlTable& top, Campaign& campaign) {
  const TomlNode* node = top.find("contact");
  if (!node) return;
  const TomlTable table(*node, top.file(), "[contact]", campaign_keys("contact"));
  const std::optional<std::string> law = campaign_choice(table, "contact", "law");
  if (const auto weights = campaign_choice(table, "contact", "weights")) {
    campaign.weights = contact_weights(*weights);
  }
  const TomlNode* automatic = table.find("stiffness");
  if (automatic && (automatic->kind != TomlNode::Kind::kString || automatic->text != "auto")) {
    table.refuse("stiffness", *automatic, "must be \"auto\"; a value is written stiffness_n_m");
  }
  campaign.stiffness = {.normal = table.number("stiffness_n_m", kStiffness),
                        .tangential = table.number("tangential_stiffness_n_m", kStiffness),
                        .rolling = table.number("rolling_stiffness_n_m_rad", kRollingStiffness),
                        .time_step = table.number("time_step_s", kTimeStep),
                        .law = law ? contact_law(*law) : ContactLaw()};
  if (automatic && campaign.stiffness.normal) {
    table.refuse("stiffness_n_m", *table.find("stiffness_n_m"),
                 "contradicts stiffness = \"auto\"; keep one of the two");
  }
}

/// `from` and `to`, or all points of a line as `through`.
std::vector<Vec2> read_barrier_line(const TomlTable& table) {
  const std::string expected = "a list of two points or more, [[x, y], [x, y], ...]";
  const TomlNode* line = table.find("through");
  if (!line) {
    table.required("from", "two numbers, [x, y]");
    table.required("to", "two numbers, [x, y]");
    const std::vector<Vec2> ends = {*table.vec2("from", kMapCoordinate),
                                    *table.vec2("to", kMapCoordinate)};
    if (!((ends[1] - ends[0]).norm() > 0.0)) {
      table.refuse("to", *table.find("to"), "must differ from from");
    }
    return ends;
  }
  for (const char* end : {"from", "to"}) {
    if (table.find(end)) {
      table.refuse(end, *table.find(end), "contradicts through, which has all points of the line");
    }
  }
  if (line->kind != TomlNode::Kind::kList || line->list.size() < 2) {
    table.refuse("through", *line, "must be " + expected);
  }
  std::vector<Vec2> points;
  for (const TomlNode& point : line->list) {
    const std::vector<double> xy =
        table.numbers("through", point, 2, 2, "points [x, y]", kMapCoordinate);
    points.emplace_back(xy[0], xy[1]);
    if (points.size() > 1 && !((points.back() - points[points.size() - 2]).norm() > 0.0)) {
      table.refuse("through", point, "two points after each other must differ");
    }
  }
  try {
    check_barrier_line(points);
  } catch (const InputError& error) {
    table.refuse("through", *line, "barrier " + *table.text("name") + ": " + error.what());
  }
  return points;
}

std::vector<Barrier> read_campaign_barriers(const TomlTable& top) {
  std::vector<Barrier> barriers;
  const TomlNode* all = top.find("barrier");
  if (!all) return barriers;
  if (all->kind != TomlNode::Kind::kList) {
    top.refuse("barrier", *all, "each barrier is a table [[barrier]]");
  }
  for (const TomlNode& node : all->list) {
    const TomlTable table(node, top.file(), "[[barrier]]", campaign_keys("barrier"));
    table.required("name", "a text in quotes");
    Barrier barrier{*table.text("name"), read_barrier_line(table)};
    if (const std::optional<std::string> direction = table.text("direction")) {
      const TomlNode& given = *table.find("direction");
      if (is_ring(barrier.through)) {
        table.refuse("direction", given, "is not for a ring, whose entries and exits both count");
      }
      try {
        barrier.counted = counted_crossings(*direction);
      } catch (const InputError& error) {
        table.refuse("direction", given, error.what());
      }
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
  const TomlTable table(*node, top.file(), "[run]", campaign_keys("run"));
  campaign.max_time = table.number("max_time_s", kRunTime).value_or(campaign.max_time);
  campaign.rest_energy =
      table.number("rest_energy_j_kg", kRestEnergy).value_or(campaign.rest_energy);
  campaign.rest_duration =
      table.number("rest_duration_s", kRestDuration).value_or(campaign.rest_duration);
  campaign.gravity = table.number("gravity_m_s2", kGravity).value_or(campaign.gravity);
  campaign.trajectory_interval = table.number("trajectory_interval_s", kTrajectoryInterval)
                                     .value_or(campaign.trajectory_interval);
  campaign.downslope = table.vec2("downslope", kDirectionComponent);
  if (campaign.downslope && !kDirectionLength.holds(campaign.downslope->norm())) {
    table.refuse("downslope", *table.find("downslope"),
                 "must point somewhere, with a length " + kDirectionLength.words());
  }
}

/// Those at the top of the file.
std::vector<std::string> campaign_table_names() {
  std::vector<std::string> names;
  for (const KeyTable& table : campaign_tables()) {
    if (table.name.find('.') == std::string::npos) names.push_back(table.name);
  }
  return names;
}

}  // namespace

namespace study_detail {

Campaign read_by_parts(const fs::path& file, const std::optional<std::string>& text,
                       const PartReader& read) {
  Campaign campaign;
  campaign.file = file;
  TomlNode root;
  const bool is_toml = read([&] {
    campaign.text = text ? *text : read_text_file(file);
    campaign.sha256 = sha256(campaign.text);
    root = parse_toml(campaign.text, file.string());
  });
  if (!is_toml) return campaign;
  read([&] { TomlTable(root, file.string(), "", campaign_table_names()); });
  std::vector<std::string> tables = campaign_table_names();
  for (const auto& [name, table] : root.table) tables.push_back(name);
  const TomlTable top(root, file.string(), "", tables);

  const bool blocks = read([&] { campaign.blocks = read_blocks(top); });
  const bool terrain = read([&] {
    Campaign with_terrain = campaign;
    read_terrain_table(top, with_terrain);
    campaign = std::move(with_terrain);
  });
  const bool ground = read([&] { campaign.ground = read_ground(top); });
  const bool groups = ground && read([&] { campaign.groups = read_block_groups(top, campaign); });
  const bool ensemble = groups && read([&] { campaign.ensemble = read_ensemble(top, campaign); });
  const bool releases = terrain && read([&] {
                          const std::string up =
                              up_axis(campaign.terrain.up, campaign.terrain.surface.front());
                          campaign.releases = read_releases(top, up == "y");
                        });
  if (blocks && groups && releases) {
    const bool stay = read([&] { campaign.stay = read_stay_plan(top, campaign); });
    if (stay && ensemble) read([&] { check_posterior_starts(top, campaign); });
  }
  read([&] { read_contact(top, campaign); });
  read([&] { campaign.barriers = read_campaign_barriers(top); });
  read([&] { read_run(top, campaign); });
  return campaign;
}

}  // namespace study_detail

namespace {

Campaign read_or_parse(const fs::path& file, const std::optional<std::string>& text) {
  return read_by_parts(file, text, [](const std::function<void()>& part) {
    part();
    return true;
  });
}

}  // namespace

Campaign read_campaign(const fs::path& file) { return read_or_parse(file, std::nullopt); }

Campaign parse_campaign(const std::string& text, const fs::path& file) {
  return read_or_parse(file, text);
}

double StayPlan::last_release() const {
  double last = 0.0;
  for (const MassPlan& mass : masses) {
    const double faces = mass.face_interval * static_cast<double>(mass.polygon.size());
    last = std::max(last, mass.release_time + faces);
  }
  return last;
}

double StayPlan::settling_time() const {
  double longest = 0.0;
  for (const MassPlan& mass : masses) {
    if (mass.settle) longest = std::max(longest, mass.settle_time);
  }
  return longest;
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
