// [release] and [[release]] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/release_points.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

const char* const kPoints =
    "a point file, a list [[x, y, z], ...], { line = [...], count = N } or { polygon = [...], "
    "count = N }";
const char* const kOrientations = "\"grid-45\", a quaternion file, or { random = N, seed = S }";

std::vector<Vec3> read_release_points(const DeclaredTable& table, bool y_up, ReleaseSet& plan) {
  const TomlNode& node = *table.find("points");
  const bool plan_only = plan.drop_height.has_value();
  const auto point_of = [&](const TomlTable& from, const std::string& key, const TomlNode& row) {
    const std::vector<double> values = from.read_numbers(
        key, row, plan_only ? 2 : 3, 3,
        plan_only ? "points of finite numbers, [x, y] or [x, y, z]"
                  : "points of three finite numbers, [x, y, z]; [x, y] needs height_m",
        kMapCoordinateRange);
    return Vec3(values[0], values[1], values.size() == 3 ? values[2] : 0.0);
  };
  const auto points_of = [&](const TomlTable& from, const std::string& key, const TomlNode& list,
                             std::size_t minimum) {
    if (list.kind != TomlNode::Kind::kList || list.list.size() < minimum) {
      from.refuse(key, list, "must be a list of at least " + std::to_string(minimum) + " points");
    }
    std::vector<Vec3> points;
    for (const TomlNode& row : list.list) points.push_back(point_of(from, key, row));
    return points;
  };
  if (node.kind == TomlNode::Kind::kString) {
    const fs::path file = *table.value<fs::path>("points");
    std::vector<Vec3> points = read_point_table(file);
    if (y_up) {
      for (Vec3& point : points) point = y_up_to_z_up(point);
    }
    plan.files.push_back(file);
    return points;
  }
  if (node.kind == TomlNode::Kind::kList) return points_of(table, "points", node, 1);
  if (node.kind != TomlNode::Kind::kTable) {
    table.refuse("points", node, std::string("must be ") + kPoints);
  }

  const DeclaredTable rule = table.inner_table("points");
  const TomlNode* line = rule.find("line");
  const TomlNode* polygon = rule.find("polygon");
  if (!line == !polygon) rule.refuse("needs either line or polygon");
  rule.require_key("count");
  const std::size_t count = *rule.value<std::size_t>("count");
  if (line) {
    rule.refuse_if_present("seed", "points on a line are evenly spaced and need no seed");
    const std::vector<Vec3> corners = points_of(rule, "line", *line, 2);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](const Vec3& corner) { return corner == corners.front(); })) {
      rule.refuse("line", *line, "all points of the line are the same, so it has no length");
    }
    return space_points_on_line(corners, count);
  }
  if (!plan_only) rule.refuse("a polygon gives plan positions and needs height_m");
  const std::vector<Vec2> corners = *rule.value<std::vector<Vec2>>("polygon");
  return rule.run_check("polygon", [&] {
    return sample_points_in_polygon(corners, count,
                                    rule.value<std::uint64_t>("seed").value_or(plan.seed));
  });
}

void read_orientation_set(const DeclaredTable& table, bool y_up, ReleaseSet& plan) {
  const TomlNode& node = *table.find("orientations");
  const std::optional<std::string> frame = table.value<std::string>("frame");
  plan.in_principal_frame = frame == "principal";
  if (node.kind == TomlNode::Kind::kTable) {
    const DeclaredTable rule = table.inner_table("orientations");
    rule.check_required_keys();
    plan.orientation_source = "random";
    plan.orientation_seed = plan.seed;
    rule.read("seed", plan.orientation_seed);
    plan.orientations =
        sample_random_orientations(*rule.value<std::size_t>("random"), plan.orientation_seed);
    rule.read("fresh", plan.fresh_orientations);
    return;
  }
  const std::string expected = std::string("must be ") + kOrientations;
  if (node.kind != TomlNode::Kind::kString) table.refuse("orientations", node, expected);
  plan.orientation_source = *table.read_text("orientations");
  if (plan.orientation_source == "grid-45") {
    if (frame == "source") {
      table.refuse("frame",
                   "the orientations of grid-45 turn the principal frame; leave frame out");
    }
    plan.in_principal_frame = true;
    plan.orientations = orientations_in_45_degree_grid();
    return;
  }
  if (fs::path(plan.orientation_source).extension().empty() &&
      !fs::exists(fs::path(table.file()).parent_path() / plan.orientation_source)) {
    table.refuse("orientations", node, expected + "; there is no file of this name");
  }
  const fs::path file = resolve_input_file(table, "orientations", node);
  plan.orientations = read_orientation_table(file);
  if (y_up) {
    for (Quat& orientation : plan.orientations) orientation = y_up_to_z_up(orientation);
  }
  plan.files.push_back(file);
}

void check_rate(const DeclaredTable& table, const std::string& key, const Vec3& rate,
                double maximum) {
  if (rate.norm() > maximum) {
    table.refuse(key,
                 "must be " + format_significant(maximum, 6) + " in size or less; check the units");
  }
}

ReleaseSet read_release(const DeclaredTable& table, bool y_up) {
  ReleaseSet plan;
  release_keys().read(table, plan);
  check_rate(table, "velocity_m_s", plan.velocity, kMaxInitialSpeed);
  check_rate(table, "angular_velocity_rad_s", plan.angular_velocity, kMaxInitialSpin);
  plan.points = read_release_points(table, y_up, plan);
  read_orientation_set(table, y_up, plan);
  return plan;
}

}  // namespace

const MemberTable<ReleaseSet>& release_keys() {
  using Plan = ReleaseSet;
  static const TableKey how_many{
      "count", "", "number of points",
      required_format("a whole number of points", count_format(1, kMaxItemsPerSet))};
  static const ValueFormat points = alternative_formats(
      {text_format(), list_format(point_format(), 1),
       table_format({{"line", "m", "line along which points are spaced evenly",
                      required_format("a list of points", list_format(point_format(), 2))},
                     how_many}),
       table_format({{"polygon", "m", "polygon in which points are drawn",
                      required_format("a list of points", list_format(point_format(), 3))},
                     how_many,
                     {"seed", "", "seed of the points", seed_format()}})});
  static const ValueFormat orientations = alternative_formats(
      {text_format(),
       table_format(
           {{"random", "", "number of orientations",
             required_format("a whole number of orientations", count_format(1, kMaxItemsPerSet))},
            {"seed", "", "seed of the orientations", seed_format()},
            {"fresh", "", "different orientations for every block and point", flag_format()}})});
  static const MemberTable<Plan> keys(
      {"release", "Start positions, orientations and velocities of blocks",
       KeyTable::Repeat::kEither},
      {{"name", "", "name of the release set, required if there are several", text_format(),
        &Plan::name},
       {"points", "m", "positions of centres of mass: a file, a list, along a line or in a polygon",
        required_format(kPoints, points)},
       {"orientations", "", "\"grid-45\", a file of quaternions, or random ones",
        required_format(kOrientations, orientations)},
       {"frame", "", "frame to which the rotations of a file apply",
        word_format({"source", "principal"})},
       {"height_m", "m", "drop height above the ground; points are then plan positions",
        number_format(kDropHeightRange), &Plan::drop_height},
       {"velocity_m_s", "m/s", "velocity of the centre of mass at the start",
        list_format(number_format({-kMaxInitialSpeed, kMaxInitialSpeed}), 3, 3), &Plan::velocity},
       {"angular_velocity_rad_s", "rad/s", "angular velocity at the start, along the map axes",
        list_format(number_format({-kMaxInitialSpin, kMaxInitialSpin}), 3, 3),
        &Plan::angular_velocity},
       {"seed", "", "seed of points and orientations without a seed of their own", seed_format(),
        &Plan::seed},
       {"sequence", "", "every block alone, or persistent blocks", word_format({"single", "stay"})},
       {"realisations", "", "number of releases of all blocks, if blocks are persistent",
        count_format(1, kMaxItemsPerSet)},
       {"order", "", "release order of persistent blocks", word_format({"random", "listed"})},
       {"remove", "", "removes blocks that come to rest in a ground zone",
        table_format({{"zone", "", "name of a zone, or a list of names",
                       required_format("the name of a ground zone, or a list of names",
                                       texts_format())}})}});
  return keys;
}

std::vector<ReleaseSet> read_releases(const TomlTable& top, bool y_up) {
  if (std::vector<ReleaseSet> masses = read_mass_releases(top); !masses.empty()) return masses;
  const std::vector<DeclaredTable> tables = find_tables(top, release_keys());
  if (tables.empty()) {
    throw InputError(
        top.file() +
        ": the table [release] is missing; add it with points = FILE or a list of them, or [mass] "
        "with the polygon of a rock mass");
  }
  std::vector<ReleaseSet> releases;
  for (const DeclaredTable& table : tables) {
    if (tables.size() > 1) table.require_key("name", "a text in quotes, since there are several");
    ReleaseSet release = read_release(table, y_up);
    check_unique_name(table, release.name, releases, "release set");
    releases.push_back(std::move(release));
  }
  return releases;
}

}  // namespace clast::study_detail
