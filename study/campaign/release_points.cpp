#include "study/campaign/release_points.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/files/number_table.hpp"
#include "core/number_text.hpp"
#include "mesh/coordinate_columns.hpp"
#include "mesh/plan_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/plan_polygon.hpp"

namespace clast {

using namespace study_detail;
namespace {

// Quaternions are often written with four to ten digits; further off is another quantity.
constexpr double kNormTolerance = 1e-3;

}  // namespace

std::vector<Vec3> read_point_table(const std::filesystem::path& file) {
  std::vector<Vec3> points;
  const auto find = [](const std::vector<std::string_view>& headings) {
    const auto found = find_coordinate_columns(headings);
    return found ? std::optional(std::vector<std::size_t>(found->axes.begin(), found->axes.end()))
                 : std::nullopt;
  };
  const NumericTableSpec table{.column_names = {{"x"}, {"y"}, {"z"}},
                               .range = kMapCoordinateRange,
                               .expected_line = "three numbers, x y z",
                               .find_columns = find};
  for (const NumericRow& row : read_numeric_table(file, table)) {
    points.emplace_back(row.values[0], row.values[1], row.values[2]);
  }
  return points;
}

std::vector<Quat> read_orientation_table(const std::filesystem::path& file) {
  std::vector<Quat> orientations;
  constexpr NumberRange kComponent{-2.0, 2.0};
  const NumericTableSpec table{
      {{"w", "qw", "q0"}, {"x", "qx", "q1"}, {"y", "qy", "q2"}, {"z", "qz", "q3"}},
      kComponent,
      "a quaternion, w x y z"};
  for (const NumericRow& row : read_numeric_table(file, table)) {
    Quat orientation(row.values[0], row.values[1], row.values[2], row.values[3]);
    const double norm = orientation.norm();
    if (!(std::abs(norm - 1.0) <= kNormTolerance)) {
      throw InputError(file.string() + ":" + std::to_string(row.line) + ": quaternion of length " +
                       format_significant(norm, 6) + "; a rotation has length 1, written w x y z");
    }
    orientation.normalize();
    orientations.push_back(orientation);
  }
  return orientations;
}

Quat y_up_to_z_up(const Quat& orientation) {
  const double half = std::sqrt(0.5);
  return (Quat(half, half, 0.0, 0.0) * orientation).normalized();
}

std::vector<Vec3> space_points_on_line(std::span<const Vec3> line, std::size_t count) {
  std::vector<double> reached{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    reached.push_back(reached.back() + (line[i] - line[i - 1]).norm());
  }
  std::vector<Vec3> points;
  std::size_t segment = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double distance = share * reached.back();
    while (segment + 1 < line.size() && reached[segment] < distance) ++segment;
    const double length = reached[segment] - reached[segment - 1];
    const double t = length > 0.0 ? (distance - reached[segment - 1]) / length : 0.0;
    points.push_back((1.0 - t) * line[segment - 1] + t * line[segment]);
  }
  return points;
}

std::vector<Vec3> sample_points_in_polygon(std::span<const Vec2> polygon, std::size_t count,
                                           std::uint64_t seed) {
  check_has_area(polygon);
  Bounds box;
  for (const Vec2& corner : polygon) box.include({corner.x(), corner.y(), 0.0});
  Random random(seed);
  // A self-crossing polygon can have area by the formula and yet hold next to nothing; without a
  // bound it would keep the search going for ever.
  const std::size_t most_draws = 1000 + 10'000 * count;
  std::vector<Vec3> points;
  for (std::size_t draw = 0; points.size() < count; ++draw) {
    if (draw == most_draws) {
      throw InputError("the polygon is too thin to draw points from; widen it, or give the points");
    }
    const double x = random.uniform(box.low.x(), box.high.x());
    const double y = random.uniform(box.low.y(), box.high.y());
    if (is_inside(polygon, {x, y})) points.emplace_back(x, y, 0.0);
  }
  return points;
}

std::vector<Quat> sample_random_orientations(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Quat> orientations;
  for (std::size_t i = 0; i < count; ++i) orientations.push_back(random.rotation());
  return orientations;
}

}  // namespace clast
