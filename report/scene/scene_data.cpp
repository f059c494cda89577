#include "report/scene/scene_data.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "report/charts/palette.hpp"
#include "report/html/packed_numbers.hpp"
#include "report/scene/stored_runs.hpp"
#include "terrain/relief.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

/// A radius of less than this share of the longest axis is not drawn: nobody would see it.
constexpr double kSeenRadius = 0.03;

/// Rounds to 2^-14 (0.06 mm): invisible bits would be most of what a page cannot compress.
double visible_digits(double value) { return std::round(value * 16384.0) / 16384.0; }

void append_vector(std::vector<float>& flat, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) flat.push_back(static_cast<float>(v[axis]));
}

Json scene_mesh_json(const TriangleMesh& mesh, const Vec3& shift) {
  std::vector<float> vertices;
  for (const Vec3& vertex : mesh.vertices) append_vector(vertices, vertex + shift);
  std::vector<std::uint32_t> corners;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
  }
  return {{"vertices", encode_packed_array<float>(vertices)},
          {"triangles", encode_packed_array<std::uint32_t>(corners)}};
}

/// The middle of starts and stops, on the map.
Vec3 scene_origin(const Comparison& comparison) {
  Bounds box;
  for (const RunRow& row : comparison.rows) {
    box.include(row.start);
    if (row.stop.allFinite()) box.include(row.stop);
  }
  return (0.5 * (box.low + box.high)).array().round();
}

/// A grid in place of a terrain with too many triangles: its top, over the extent of the terrain.
Terrain resampled(const Terrain& terrain, std::size_t columns) {
  Bounds box = bounds(terrain.surface);
  const Relief relief = sample_relief(terrain, {box.low.head<2>(), box.high.head<2>()},
                                      static_cast<std::uint32_t>(columns));
  Terrain grid;
  grid.zone_names = terrain.zone_names;
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> vertex(relief.height.size(), kNone);
  for (std::uint32_t r = 0; r < relief.rows; ++r) {
    for (std::uint32_t c = 0; c < relief.columns; ++c) {
      const std::size_t at = std::size_t{r} * relief.columns + c;
      if (std::isnan(relief.height[at])) continue;
      vertex[at] = static_cast<std::uint32_t>(grid.surface.vertices.size());
      grid.surface.vertices.emplace_back(box.low.x() + (c + 0.5) * relief.cell,
                                         box.high.y() - (r + 0.5) * relief.cell, relief.height[at]);
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t zone) {
    if (a == kNone || b == kNone || c == kNone) return;
    grid.surface.triangles.push_back({a, b, c});
    grid.zone.push_back(zone);
  };
  for (std::uint32_t r = 0; r + 1 < relief.rows; ++r) {
    for (std::uint32_t c = 0; c + 1 < relief.columns; ++c) {
      const std::size_t at = std::size_t{r} * relief.columns + c, below = at + relief.columns;
      add(vertex[at], vertex[below], vertex[below + 1], relief.zone[at]);
      add(vertex[at], vertex[below + 1], vertex[at + 1], relief.zone[at]);
    }
  }
  return grid;
}

Json terrain_json(const Terrain& terrain, const Vec3& shift, const SceneLimits& limits) {
  if (terrain.surface.triangles.size() > limits.triangles) {
    return terrain_json(resampled(terrain, limits.grid), shift, {.triangles = SIZE_MAX});
  }
  Json json = scene_mesh_json(terrain.surface, shift);
  json["zones"] = encode_packed_array<std::uint16_t>(terrain.zone);
  return json;
}

TriangleMesh drawn_body(const CampaignResults& results, const BlockSummary& block) {
  const SpheroPolyhedron body = scaled(results.shapes[block.shape], block.scale);
  if (body.faces.empty()) return rounded_surface_mesh(body);  // a ball or a capsule
  return body.radius < kSeenRadius * block.axes.L ? core_mesh(body) : rounded_surface_mesh(body, 1);
}

/// Bodies of all files one after the other, and where those of each file begin.
struct Bodies {
  Json json = Json::array();
  std::vector<std::size_t> first;
};

Bodies bodies_of(const Comparison& comparison) {
  Bodies bodies;
  for (const CampaignResults& results : comparison.results) {
    bodies.first.push_back(bodies.json.size());
    for (const BlockSummary& block : results.blocks) {
      Json json = {
          {"name", block.id}, {"group", block.garcia}, {"colour", class_colour(block.garcia)}};
      json.update(scene_mesh_json(drawn_body(results, block), Vec3::Zero()));
      bodies.json.push_back(std::move(json));
    }
  }
  return bodies;
}

std::string run_name(const Comparison& comparison, const RunRow& row) {
  std::string name =
      comparison.results.size() > 1 ? "file " + std::to_string(row.file + 1) + ", " : std::string();
  return name + "run " + std::to_string(row.record->run) + ", " + row.block->id;
}

/// Runs as the page draws them.
struct SceneRuns {
  Json runs = Json::array();
  std::vector<float> frames;  ///< eight numbers each: time, place, orientation
  double duration = 0.0;      ///< s, of the longest
};

SceneRuns scene_runs(const Comparison& comparison, const RunsWithTrajectories& all,
                     const Bodies& bodies, const Vec3& origin, std::size_t most_frames) {
  SceneRuns scene;
  const std::size_t every = (all.frames + most_frames - 1) / most_frames;
  for (std::size_t i = 0; i < all.rows.size(); i += every) {
    const RunRow& row = comparison.rows[all.rows[i]];
    const CampaignResults& results = comparison.results[row.file];
    const Trajectory trajectory = all.trajectory(row);
    scene.runs.push_back({{"name", run_name(comparison, row)},
                          {"body", bodies.first[row.file] + row.record->block},
                          {"first", scene.frames.size() / 8},
                          {"count", trajectory.time.size()}});
    for (std::size_t k = 0; k < trajectory.time.size(); ++k) {
      const RigidState& state = trajectory.states[k];
      scene.frames.push_back(static_cast<float>(trajectory.time[k]));
      const Vec3 place = results.frame.to_map(state.position) - origin;
      append_vector(scene.frames, Vec3(visible_digits(place.x()), visible_digits(place.y()),
                                       visible_digits(place.z())));
      for (const double q : {state.orientation.w(), state.orientation.x(), state.orientation.y(),
                             state.orientation.z()}) {
        scene.frames.push_back(static_cast<float>(visible_digits(q)));
      }
    }
    scene.duration = std::max(scene.duration, trajectory.time.back());
  }
  return scene;
}

Json tints_json(const std::vector<std::string>& zone_names) {
  Json tints = Json::array();
  for (std::size_t zone = 0; zone < std::max<std::size_t>(zone_names.size(), 1); ++zone) {
    tints.push_back(
        format_colour(zone_colour(zone < zone_names.size() ? zone_names[zone] : "", zone)));
  }
  return tints;
}

Json barriers_json(const std::vector<BarrierLine>& lines, const Vec3& origin) {
  Json barriers = Json::array();
  for (const BarrierLine& line : lines) {
    Json through = Json::array();
    for (const Vec2& point : line.vertices) {
      through.push_back({point.x() - origin.x(), point.y() - origin.y()});
    }
    barriers.push_back({{"name", line.name}, {"through", through}});
  }
  return barriers;
}

}  // namespace

void SceneLimits::check() const {
  if (frames == 0) throw InputError("frames = 0: a scene needs at least one");
  if (triangles == 0) throw InputError("triangles = 0: a terrain needs at least one");
  if (grid < 2) throw InputError("grid = " + std::to_string(grid) + ": must be 2 columns or more");
}

SceneData make_scene_data(const Comparison& comparison, const SceneLimits& limits) {
  limits.check();
  const Vec3 origin = scene_origin(comparison);
  const CampaignResults& first = comparison.results.front();
  const RunsWithTrajectories all = find_runs_with_trajectories(comparison);
  SceneData scene;
  scene.runs = all.rows.size();
  if (all.rows.empty()) return scene;
  const Bodies bodies = bodies_of(comparison);
  const SceneRuns drawn = scene_runs(comparison, all, bodies, origin, limits.frames);
  scene.runs_drawn = drawn.runs.size();
  scene.json = Json{{"origin", {origin.x(), origin.y(), origin.z()}},
                    {"terrain", terrain_json(first.terrain, first.frame.origin - origin, limits)},
                    {"tints", tints_json(first.zone_names)},
                    {"bodies", bodies.json},
                    {"runs", drawn.runs},
                    {"frames", encode_packed_array<float>(drawn.frames)},
                    {"barriers", barriers_json(comparison.lines, origin)},
                    {"duration", drawn.duration}}
                   .dump();
  return scene;
}

}  // namespace clast::report_detail
