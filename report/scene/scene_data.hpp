#pragma once
/// Data of the 3-D view of a report, as JSON with base64 arrays.
#include <cstddef>
#include <string>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// Limits of the amount of data of the 3-D view of a report. Larger data are reduced.
struct SceneLimits {
  std::size_t frames = 100'000;  ///< maximum number of states of all runs, 32 bytes each
  /// Maximum number of terrain triangles; larger terrains are drawn as a grid.
  std::size_t triangles = 120'000;
  std::size_t grid = 240;  ///< number of columns of that grid

  void check() const;  ///< throws InputError naming the field and its value
};

struct SceneData {
  std::string json;
  std::size_t runs_drawn = 0;  ///< number of drawn runs; 0 if no trajectories are stored
  std::size_t runs = 0;        ///< number of runs with a stored trajectory
};

/// Makes the data of the 3-D view of a report: terrain, bodies, barriers and as many trajectories
/// as the limits allow. Positions are map coordinates minus `origin`.
///
/// JSON: `origin` [3]; `terrain` {vertices float32 [n][3], triangles uint32 [m][3], zones uint16
/// [m]}, `tints` of the zones; `bodies` list of {name, group, colour, vertices, triangles}; `runs`
/// list of {name, body, first, count}; `frames` float32 [n][8]: t, x, y, z, qw, qx, qy, qz, to
/// 2^-14; `barriers` list of {name, through [n][2]}; `duration`, that of the longest run, s.
/// @throws InputError  if a results file can no longer be read
SceneData make_scene_data(const Comparison& comparison, const SceneLimits& limits = {});

}  // namespace clast::report_detail
