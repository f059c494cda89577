#include "terrain/released_mass.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/reference_system.hpp"
#include "mesh/self_intersection.hpp"
#include "mesh/triangle_geometry.hpp"
#include "terrain/detail/surface_overlay.hpp"
#include "terrain/gdal/gdal_raster.hpp"
#include "terrain/input/resampling.hpp"
#include "terrain/plan_index.hpp"
#include "terrain/terrain_ranges.hpp"

namespace clast {
namespace {

using terrain_detail::BodyBetweenSurfaces;
using terrain_detail::ZonePolygon;

/// Walls higher than the least thickness by more are noted, m.
constexpr double kWallSlack = 1e-3;
/// Distance from a vertical triangle at which the mass is searched, m.
constexpr double kBeside = 1e-3;

/// Places in the order of volume; none: all of them.
std::set<std::size_t> chosen_numbers(const std::string& bodies) {
  if (bodies == "largest") return {1};
  std::set<std::size_t> numbers;
  if (bodies == "all") return numbers;
  for (const std::string& each : split_comma_separated(bodies)) {
    const std::optional<double> number = parse_number(each);
    if (!number || *number < 1.0 || *number > 1e9 || *number != std::floor(*number)) {
      numbers.clear();
      break;
    }
    numbers.insert(static_cast<std::size_t>(*number));
  }
  if (!numbers.empty()) return numbers;
  throw InputError("`bodies` = \"" + bodies +
                   "\": must be largest, all, or numbers in the order of volume, such as 1,3");
}

/// Both surfaces in the local frame of `after`.
struct Surfaces {
  TriangleMesh before, after;
  MapFrame frame;
};

void check_systems(const std::string& before, const std::string& after,
                   std::vector<std::string>& notes) {
  if (before.empty() != after.empty()) {
    notes.push_back(std::string(before.empty() ? "`before`" : "`after`") +
                    " has no map system; it is assumed to be that of the other");
  }
  if (before.empty() || after.empty() || terrain_detail::is_same_crs(before, after)) return;
  throw InputError("`before` is in the map system " + reference_system_name(before) +
                   ", `after` in " + reference_system_name(after) +
                   "; convert both to one, for example with gdalwarp");
}

std::string extent_on_map(const TriangleMesh& mesh, const MapFrame& frame) {
  const Bounds box = bounds(mesh);
  const Vec3 low = frame.to_map(box.low), high = frame.to_map(box.high);
  return "x " + format_decimals(low.x(), 1) + " to " + format_decimals(high.x(), 1) + ", y " +
         format_decimals(low.y(), 1) + " to " + format_decimals(high.y(), 1);
}

void check_overlap(const Surfaces& surfaces) {
  const Bounds one = bounds(surfaces.before), two = bounds(surfaces.after);
  const Vec2 low = one.low.cwiseMax(two.low).head<2>();
  const Vec2 high = one.high.cwiseMin(two.high).head<2>();
  if ((low.array() < high.array()).all()) return;
  throw InputError("`before` and `after` do not overlap: one has " +
                   extent_on_map(surfaces.before, surfaces.frame) + ", the other " +
                   extent_on_map(surfaces.after, surfaces.frame) +
                   "; check their map systems and upward axes");
}

Surfaces read_surfaces(const Terrain& before, const Terrain& after,
                       const ReleasedMassOptions& options) {
  Surfaces surfaces{before.surface, after.surface, after.frame};
  const Vec3 shift = before.frame.origin - after.frame.origin;
  for (Vec3& vertex : surfaces.before.vertices) vertex += shift;
  check_overlap(surfaces);
  if (!options.resolution) return surfaces;
  surfaces.before =
      terrain_detail::grid_highest_surface(surfaces.before, *options.resolution, "`before`");
  surfaces.after =
      terrain_detail::grid_highest_surface(surfaces.after, *options.resolution, "`after`");
  return surfaces;
}

std::vector<ZonePolygon> outlines_of(const ReleasedMassOptions& options, const MapFrame& frame,
                                     const std::string& crs) {
  if (!options.polygon) return {};
  std::vector<ZonePolygon> outlines = terrain_detail::read_outline_polygons(*options.polygon, crs);
  for (ZonePolygon& outline : outlines) {
    for (std::vector<Vec2>& ring : outline.rings) {
      for (Vec2& corner : ring) corner -= frame.origin.head<2>();
    }
    outline.low -= frame.origin.head<2>();
    outline.high -= frame.origin.head<2>();
  }
  return outlines;
}

[[noreturn]] void refuse_nothing(const Surfaces& surfaces, const ReleasedMassOptions& options) {
  const std::string inside =
      options.polygon ? " within " + options.polygon->string() : std::string();
  const terrain_detail::HeightDifferenceRange range =
      terrain_detail::height_difference_range(surfaces.before, surfaces.after);
  if (range.low > range.high) {
    throw InputError("`before` and `after` have no common area with ground in both");
  }
  const auto at = [&](const Vec3& place) { return format_map_point(surfaces.frame.to_map(place)); };
  std::string text = "`before` is nowhere" + inside + " more than " +
                     format_significant(options.min_thickness, 4) + " m above `after`; ";
  if (range.high > options.min_thickness) {
    text += "outside the polygon it is, by up to " + format_significant(range.high, 3) + " m at " +
            at(range.high_position) + ": check the polygon and its map system, or `least_volume`";
  } else if (range.high > 0.0) {
    text += "the largest difference is " + format_significant(range.high, 3) + " m at " +
            at(range.high_position) + ": give a smaller `min_thickness`";
  } else {
    text += "`before` is above `after` nowhere";
  }
  if (-range.low > std::max(options.min_thickness, range.high)) {
    text += "; `before` is up to " + format_significant(-range.low, 3) + " m below `after` at " +
            at(range.low_position) + ": check that the two are not swapped";
  }
  throw InputError(text);
}

/// True if a position is below the top of a body.
class Cover {
 public:
  explicit Cover(const std::vector<const BodyBetweenSurfaces*>& bodies) {
    for (const BodyBetweenSurfaces* body : bodies) {
      TriangleMesh top = body->mesh;
      top.triangles.resize(body->top_triangles);
      tops_ = merged(std::move(tops_), top);
    }
    index_.emplace(terrain_detail::plan_boxes(tops_));
  }

  bool holds(const Vec2& place) const {
    const auto near = index_->boxes_near(place);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t t) {
      return terrain_detail::height_on_triangle(tops_, t, place).has_value();
    });
  }

 private:
  TriangleMesh tops_;
  std::optional<terrain_detail::PlanIndex> index_;
};

/// Beside an upright triangle the mass may end, as at the back of a sawn niche; inside it may not.
bool stands_inside(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle,
                   const Cover& cover) {
  const Vec3 area = doubled_area_vector(mesh, triangle);
  const Vec2 middle = centroid(mesh, triangle).head<2>();
  if (area.z() < 0.0) return cover.holds(middle);
  const double across = area.head<2>().norm();
  if (across == 0.0) return false;
  const Vec2 beside = kBeside / across * area.head<2>();
  return cover.holds(middle + beside) && cover.holds(middle - beside);
}

void check_mass_heights(const TriangleMesh& mesh, const char* name, const Cover& cover,
                        const MapFrame& frame) {
  std::size_t count = 0;
  Vec3 first = Vec3::Zero();
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    if (doubled_area_vector(mesh, triangle).z() > 0.0 || !stands_inside(mesh, triangle, cover))
      continue;
    if (count++ == 0) first = centroid(mesh, triangle);
  }
  if (count == 0) return;
  throw GeometryError(std::string(name) + ": " + format_count(count, "triangle") +
                      " within the mass are vertical or overhang, the first at " +
                      format_map_point(frame.to_map(first)) +
                      "; the mass between such surfaces is not defined. Give `resolution`, which "
                      "uses the highest point of each cell, or cut a closed mesh of the mass");
}

ReleasedBody body_of(const BodyBetweenSurfaces& pair, const MapFrame& frame) {
  const Bounds box = bounds(pair.mesh);
  return {.mesh = {},
          .volume = signed_volume(pair.mesh),
          .plan_area = pair.plan_area,
          .max_thickness = pair.max_thickness,
          .centre = frame.to_map((box.low + box.high) / 2.0)};
}

TriangleMesh solid_on_map(const BodyBetweenSurfaces& pair, const ReleasedBody& body,
                          const MapFrame& frame) {
  TriangleMesh mesh = pair.mesh;
  for (Vec3& vertex : mesh.vertices) vertex = frame.to_map(vertex);
  const MeshReport report = inspect_mesh(mesh);
  const std::string where = "the body of " + format_significant(body.volume, 4) + " m3 around " +
                            format_map_point(body.centre);
  const char* const kWayOut = "; give a `polygon` around the mass, or a `resolution`";
  if (!report.is_closed() || !report.is_oriented()) {
    throw GeometryError(where + " is not closed (" + report.summary() + ")" + kWayOut);
  }
  if (const std::size_t crossings = find_self_intersections(mesh).size()) {
    throw GeometryError(where + " crosses itself, " + format_count(crossings, "pair") +
                        " of triangles do" + kWayOut);
  }
  return mesh;
}

void note_wall(const BodyBetweenSurfaces& pair, const ReleasedBody& body,
               const ReleasedMassOptions& options, const MapFrame& frame,
               std::vector<std::string>& notes) {
  if (pair.max_wall_height <= options.min_thickness + kWallSlack) return;
  notes.push_back("body " + std::to_string(body.rank) + " ends at a vertical wall of up to " +
                  format_significant(pair.max_wall_height, 3) + " m, for example at " +
                  format_map_point(frame.to_map(pair.wall_position)) +
                  ": the border of a surface or of the polygon, or a step of a surface; the mass "
                  "beyond the wall is not included");
}

double sum_of_volumes(const std::vector<ReleasedBody>& bodies) {
  return std::accumulate(bodies.begin(), bodies.end(), 0.0,
                         [](double sum, const ReleasedBody& body) { return sum + body.volume; });
}

}  // namespace

void ReleasedMassOptions::check() const {
  const auto check_range = [](const char* field, double value, const NumberRange& range) {
    if (range.contains(value)) return;
    throw InputError("`" + std::string(field) + "` = " + format_significant(value, 6) +
                     ": must be " + range.describe());
  };
  check_range("min_thickness", min_thickness, kMassThicknessRange);
  if (resolution) check_range("resolution", *resolution, kCellSizeRange);
  chosen_numbers(bodies);
}

double ReleasedMass::volume() const { return sum_of_volumes(bodies); }
double ReleasedMass::excluded_volume() const { return sum_of_volumes(excluded); }

ReleasedMass find_released_mass(const Terrain& before, const Terrain& after,
                                const ReleasedMassOptions& options) {
  options.check();
  ReleasedMass mass;
  check_systems(before.frame.crs, after.frame.crs, mass.notes);
  mass.crs = after.frame.crs.empty() ? before.frame.crs : after.frame.crs;
  const Surfaces surfaces = read_surfaces(before, after, options);
  const MapFrame& frame = surfaces.frame;
  mass.median_edge_before = median_edge_length(surfaces.before);
  mass.median_edge_after = median_edge_length(surfaces.after);
  std::vector<BodyBetweenSurfaces> pairs = terrain_detail::extract_bodies_between(
      terrain_detail::overlay_surfaces(surfaces.before, surfaces.after, options.min_thickness,
                                       outlines_of(options, frame, mass.crs)),
      options.min_thickness);
  std::vector<std::pair<double, const BodyBetweenSurfaces*>> order;
  for (const BodyBetweenSurfaces& pair : pairs) order.emplace_back(signed_volume(pair.mesh), &pair);
  std::erase_if(order, [&](const auto& each) { return each.first < options.min_volume; });
  if (order.empty()) refuse_nothing(surfaces, options);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  const std::set<std::size_t> numbers = chosen_numbers(options.bodies);
  if (!numbers.empty() && *numbers.rbegin() > order.size()) {
    throw InputError("`bodies` = " + options.bodies + ": there " +
                     (order.size() == 1 ? "is " : "are ") +
                     format_count(order.size(), "body", "bodies") + "; choose among them");
  }
  std::vector<const BodyBetweenSurfaces*> chosen;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (numbers.empty() || numbers.contains(i + 1)) chosen.push_back(order[i].second);
  }
  const Cover cover(chosen);
  check_mass_heights(surfaces.before, "`before`", cover, frame);
  check_mass_heights(surfaces.after, "`after`", cover, frame);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const BodyBetweenSurfaces& pair = *order[i].second;
    ReleasedBody body = body_of(pair, frame);
    body.rank = i + 1;
    if (!numbers.empty() && !numbers.contains(i + 1)) {
      mass.excluded.push_back(std::move(body));
      continue;
    }
    note_wall(pair, body, options, frame, mass.notes);
    body.mesh = solid_on_map(pair, body, frame);
    mass.bodies.push_back(std::move(body));
  }
  return mass;
}

}  // namespace clast
