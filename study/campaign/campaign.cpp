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

namespace fs = std::filesystem;

namespace study_detail {

namespace {

/// A name per surface file, the file of zones, or rules.
/// @param campaign  with its surface files
void read_zone_names(const DeclaredTable& table, Campaign& campaign) {
  TerrainOptions& terrain = campaign.terrain;
  table.read("zones", terrain.zones);
  if (std::optional<ZoneFile> file =
          table.run_check("zones", [&] { return parse_zone_file(terrain.zones); })) {
    file->path =
        resolve_input_file(table, "zones", element(*table.find("zones"), 0), file->path.string());
    terrain.zones = file->zone_option_values();
  } else if (terrain.zones.size() != terrain.surface.size() && !are_zone_rules(terrain.zones)) {
    table.refuse("zones",
                 "must name one zone per surface file (" + std::to_string(terrain.surface.size()) +
                     "), or one zone raster or GeoJSON file, or rules by slope and height");
  }
}

}  // namespace

const MemberTable<Campaign>& terrain_keys() {
  using Options = TerrainOptions;
  constexpr auto kTerrain = &Campaign::terrain;
  static const MemberTable<Campaign> keys(
      {.name = "terrain", .meaning = "The ground surface", .required = true},
      {{"surface", "", "TIN, raster, cloud or terrain file; or a list of files",
        required_format("a file or a list of files", texts_format()), kTerrain, &Options::surface},
       {"zones", "", "a name per mesh, one zone file, or rules by slope and height", texts_format(),
        &read_zone_names},
       {"up", "", "axis that points up in surface, point and quaternion files",
        word_format({"z", "y", "auto"}), kTerrain, &Options::up},
       {"columns", "", "names or numbers of the columns x, y, z of a cloud in text", texts_format(),
        kTerrain, &Options::columns},
       {"radius_m", "m", "Minkowski radius by which the ground surface is raised",
        number_format(kGroundRadiusRange), &Campaign::terrain_radius},
       {"resolution_m", "m", "cell size of clouds and resampled rasters",
        number_format(kCellSizeRange), kTerrain, &Options::resolution},
       {"percentile", "", "height of a cloud's cell: percentile of its points",
        number_format(kPercentileRange), kTerrain, &Options::percentile},
       {"outliers_m", "m",
        "points of a cloud at a larger distance from the surrounding ground are left out",
        number_format(kOutlierDistanceRange), kTerrain, &Options::outliers},
       {"fill_m", "m", "holes up to this width are filled", number_format(kHoleWidthRange),
        kTerrain, &Options::fill},
       {"crack_m", "m", "cracks between tiles up to this width are closed",
        number_format(kCrackWidthRange), kTerrain, &Options::crack},
       {"spike_steepness", "",
        "single vertices are levelled if they protrude by more than this many times the distance "
        "to their neighbours",
        number_format(kSpikeSteepnessRange), kTerrain, &Options::spike_steepness},
       {"smoothing", "", "number of smoothing rounds", count_format(0, kMaxSmoothing), kTerrain,
        &Options::smoothing},
       {"tolerance_m", "m",
        "vertices are removed if the surface moves up or down by no more than this",
        number_format(kSurfaceToleranceRange), kTerrain, &Options::tolerance},
       {"breaklines", "", "files with lines that become edges of the surface", texts_format(),
        kTerrain, &Options::breaklines},
       {"cut_zones", "", "cut the borders of zone polygons into the triangles", flag_format(),
        kTerrain, &Options::cut_zones},
       {"border_distance_m", "m", "release points nearer to the border give a warning",
        number_format(kBorderDistanceRange), &Campaign::border_distance}});
  return keys;
}

const MemberTable<Campaign>& contact_keys() {
  using Options = StiffnessOptions;
  constexpr auto kStiffnesses = &Campaign::stiffness;
  static const MemberTable<Campaign> keys(
      {.name = "contact", .meaning = "Contact law, stiffness and time step"},
      {{"law", "", "law of the normal force", word_format(contact_law_names()), &parse_contact_law,
        kStiffnesses, &Options::law},
       {"weights", "", "weights by which contact points share the stiffness",
        word_format({"patch", "overlap", "count", "none"}), &parse_contact_weighting,
        &Campaign::weighting},
       {"stiffness", "", "chosen for each block, ground and start", word_format({"auto"})},
       {"stiffness_n_m", "N/m", "normal stiffness k_n", number_format(kStiffnessRange),
        kStiffnesses, &Options::normal},
       {"tangential_stiffness_n_m", "N/m", "tangential stiffness k_t",
        number_format(kStiffnessRange), kStiffnesses, &Options::tangential},
       {"rolling_stiffness_n_m_rad", "N m/rad",
        "rolling stiffness k_r on zones without rolling_length_m",
        number_format(kRollingStiffnessRange), kStiffnesses, &Options::rolling},
       {"time_step_s", "s", "time step, kept throughout", number_format({1e-9, 1.0}), kStiffnesses,
        &Options::time_step},
       {"blocks", "", "contacts between two blocks, if blocks are persistent",
        table_format(between_blocks_keys().keys)}});
  return keys;
}

const MemberTable<Barrier>& barrier_keys() {
  static const ValueFormat plan = list_format(number_format(kMapCoordinateRange), 2, 2);
  static const MemberTable<Barrier> keys(
      {"barrier", "A line at which passing blocks are recorded", KeyTable::Repeat::kMany},
      {{"name", "", "name of the barrier", required_format("a text in quotes", text_format()),
        &Barrier::name},
       {"from", "m", "first end, [x, y]", plan},
       {"to", "m", "second end, [x, y]", plan},
       {"through", "m", "all points of a line or ring; replaces from and to", list_format(plan, 2)},
       {"direction", "", "which crossings count", word_format({"either", "forward"})}});
  return keys;
}

const MemberTable<Campaign>& run_keys() {
  static const MemberTable<Campaign> keys(
      {.name = "run", .meaning = "When a run ends, and what is stored"},
      {{"max_time_s", "s", "longest time of a run", number_format(kRunTimeRange),
        &Campaign::max_time},
       {"rest_energy_j_kg", "J/kg",
        "a block is at rest if its kinetic energy per mass stays below this for rest_duration_s",
        number_format({1e-12, 1e3}), &Campaign::rest_energy},
       {"rest_duration_s", "s",
        "time for which a block must stay below rest_energy_j_kg to be at rest",
        number_format({1e-6, 1e4}), &Campaign::rest_duration},
       {"gravity_m_s2", "m/s^2", "gravity, downwards", number_format({1e-2, 1e3}),
        &Campaign::gravity},
       {"downslope", "", "downslope direction [dx, dy], along which runout is measured",
        list_format(number_format({-1e6, 1e6}), 2, 2), &Campaign::downslope},
       // The minimum is a time step; shorter intervals need more storage and show nothing more.
       {"trajectory_interval_s", "s", "interval between stored states of trajectories",
        number_format({1e-4, 1e5, "s", "none is stored"}), &Campaign::trajectory_interval}});
  return keys;
}

namespace {

void read_terrain_table(const TomlTable& top, Campaign& campaign) {
  terrain_keys().read(find_required_table(top, terrain_keys()), campaign);
}

void read_contact(const TomlTable& top, Campaign& campaign) {
  for (const DeclaredTable& table : find_tables(top, contact_keys())) {
    contact_keys().read(table, campaign);
    const TomlNode* automatic = table.find("stiffness");
    if (automatic && (automatic->kind != TomlNode::Kind::kString || automatic->text != "auto")) {
      table.refuse("stiffness", *automatic, "must be \"auto\"; a value is written stiffness_n_m");
    }
    if (automatic && campaign.stiffness.normal) {
      table.refuse("stiffness_n_m", "contradicts stiffness = \"auto\"; keep one of the two");
    }
  }
}

/// `from` and `to`, or all points of a line as `through`.
std::vector<Vec2> read_barrier_line(const DeclaredTable& table, const std::string& name) {
  const TomlNode* line = table.find("through");
  if (!line) {
    table.require_key("from", "two numbers, [x, y]");
    table.require_key("to", "two numbers, [x, y]");
    const std::vector<Vec2> ends = {*table.value<Vec2>("from"), *table.value<Vec2>("to")};
    if (!((ends[1] - ends[0]).norm() > 0.0)) {
      table.refuse("to", "must differ from the point in from");
    }
    return ends;
  }
  for (const char* end : {"from", "to"}) {
    if (table.find(end)) {
      table.refuse(end,
                   "contradicts through, which already gives all points of the line; leave it out");
    }
  }
  if (line->kind != TomlNode::Kind::kList || line->list.size() < 2) {
    table.refuse("through", *line, "must be a list of two points or more, [[x, y], [x, y], ...]");
  }
  std::vector<Vec2> points;
  for (const TomlNode& point : line->list) {
    const std::vector<double> xy =
        table.read_numbers("through", point, 2, 2, "points [x, y]", kMapCoordinateRange);
    points.emplace_back(xy[0], xy[1]);
    if (points.size() > 1 && !((points.back() - points[points.size() - 2]).norm() > 0.0)) {
      table.refuse("through", point, "consecutive points must differ");
    }
  }
  table.run_check(
      "through", [&] { check_barrier_line(points); }, "barrier " + name + ": ");
  return points;
}

std::vector<Barrier> read_campaign_barriers(const TomlTable& top) {
  std::vector<Barrier> barriers;
  for (const DeclaredTable& table : find_tables(top, barrier_keys())) {
    Barrier barrier;
    barrier_keys().read(table, barrier);
    barrier.vertices = read_barrier_line(table, barrier.name);
    if (const std::optional<std::string> direction = table.read_text("direction")) {
      if (is_ring(barrier.vertices)) {
        table.refuse("direction", "is not for a ring, whose entries and exits both count");
      }
      barrier.counted =
          table.run_check("direction", [&] { return parse_counted_direction(*direction); });
    }
    check_unique_name(table, barrier.name, barriers, "barrier");
    barriers.push_back(barrier);
  }
  return barriers;
}

void read_run(const TomlTable& top, Campaign& campaign) {
  for (const DeclaredTable& table : find_tables(top, run_keys())) {
    run_keys().read(table, campaign);
    if (campaign.downslope && !kDirectionLengthRange.contains(campaign.downslope->norm())) {
      table.refuse("downslope",
                   "must be a direction with a length " + kDirectionLengthRange.describe());
    }
  }
}

}  // namespace

Campaign read_campaign_by_parts(const fs::path& file, const std::optional<std::string>& text,
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
  const TomlTable top = parse_top_level_table(root, file, campaign_key_tables(), read);
  const bool blocks = read([&] { campaign.blocks = read_block_selection(top); });
  const bool terrain = read([&] {
    Campaign with_terrain = campaign;
    read_terrain_table(top, with_terrain);
    campaign = std::move(with_terrain);
  });
  const bool ground = read([&] { campaign.ground = read_ground_distributions(top); });
  const bool groups = ground && read([&] { campaign.groups = read_block_groups(top, campaign); });
  const bool ensemble = groups && read([&] { campaign.ensemble = read_ensemble(top, campaign); });
  const bool releases = terrain && read([&] {
                          const std::string up = resolve_up_axis(campaign.terrain.up,
                                                                 campaign.terrain.surface.front());
                          campaign.releases = read_releases(top, up == "y");
                        });
  if (blocks && groups && releases) {
    const bool stay =
        read([&] { campaign.persistent_blocks = read_persistent_blocks_plan(top, campaign); });
    if (stay && ensemble) read([&] { check_posterior_parameters(top, campaign); });
  }
  read([&] { read_contact(top, campaign); });
  read([&] { campaign.barriers = read_campaign_barriers(top); });
  read([&] { read_run(top, campaign); });
  return campaign;
}

}  // namespace study_detail

using namespace study_detail;

Campaign read_campaign(const fs::path& file) {
  return read_campaign_by_parts(file, std::nullopt, read_without_catching);
}

Campaign parse_campaign(const std::string& text, const fs::path& file) {
  return read_campaign_by_parts(file, text, read_without_catching);
}

double PersistentBlocksPlan::last_release_time() const {
  double last = 0.0;
  for (const MultiBlockRelease& mass : masses) {
    const double faces = mass.face_interval * static_cast<double>(mass.polygon.size());
    last = std::max(last, mass.release_time + faces);
  }
  return last;
}

double PersistentBlocksPlan::settling_time() const {
  double longest = 0.0;
  for (const MultiBlockRelease& mass : masses) {
    if (mass.settle) longest = std::max(longest, mass.settle_time);
  }
  return longest;
}

std::vector<Quat> orientations_in_45_degree_grid() {
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
