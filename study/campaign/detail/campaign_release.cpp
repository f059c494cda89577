// [release] and [[release]] of a campaign file.
#include <algorithm>

#include "core/error.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/release_points.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

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
  const std::vector<Vec2> corners = read_polygon(rule, "polygon", *polygon);
  try {
    return points_in_polygon(corners, count, rule.count("seed", 0, INT64_MAX).value_or(plan.seed));
  } catch (const InputError& error) {
    rule.refuse("polygon", *polygon, error.what());
  }
}

void read_orientation_set(const TomlTable& table, bool y_up, ReleasePlan& plan) {
  const std::string expected = "\"grid-45\", a quaternion file, or { random = N, seed = S }";
  const TomlNode& node = table.required("orientations", expected);
  const std::optional<std::string> frame = campaign_choice(table, "release", "frame");
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
  if (std::vector<ReleasePlan> masses = read_mass_releases(top); !masses.empty()) return masses;
  const std::vector<const TomlNode*> nodes = tables_of(top, "release");
  if (nodes.empty()) {
    throw InputError(
        top.file() +
        ": the table [release] is missing; add it with points = FILE or a list of them, or [mass] "
        "with the polygon of a rock mass");
  }
  std::vector<ReleasePlan> releases;
  for (const TomlNode* node : nodes) {
    const TomlTable table(*node, top.file(), "[release]", campaign_keys("release"));
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

}  // namespace clast::study_detail
