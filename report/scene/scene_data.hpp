#pragma once
/// What the 3-D view of a report draws, as JSON with arrays of numbers in base64.
#include <cstddef>
#include <string>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// Limits that keep a page small and a browser quick. What is beyond them is reduced, and the page
/// says so.
struct SceneLimits {
  std::size_t frames = 100'000;     ///< of all runs together: 32 bytes each
  std::size_t triangles = 120'000;  ///< of a terrain; a larger one is drawn as a grid
  std::size_t grid = 240;           ///< columns of that grid

  void check() const;  ///< throws InputError naming the field and its value
};

struct SceneData {
  std::string json;
  std::size_t runs_drawn = 0;  ///< none: no trajectories are stored
  std::size_t runs = 0;        ///< that could be drawn
};

/// Terrain (of the first file), bodies, barriers and the motion of every n-th run, n as small as
/// the limits allow. Positions are map coordinates less `origin` (the middle of the starts and
/// stops).
///
/// JSON: `origin` [3]; `terrain` {vertices float32 [n][3], triangles uint32 [m][3], zones
/// uint16 [m]}, `tints` of the zones; `bodies` list of {name, group, colour, vertices, triangles};
/// `runs` list of {name, body, first, count}; `frames` float32 [n][8]: t, x, y, z, qw, qx, qy, qz,
/// to 2^-14; `barriers` list of {name, through [n][2]}; `duration` of the longest run, s.
/// @throws InputError  a results file can't be read any more
SceneData scene_data(const Comparison& comparison, const SceneLimits& limits = {});

}  // namespace clast::report_detail
