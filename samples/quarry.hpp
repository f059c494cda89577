#pragma once
/// A quarry slope with a cliff, benches and three ground zones, after the sections of a real
/// quarry. x runs down the slope, y along the face, z up, m.
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Lane of the slope; its section is constant over 60 m along the face.
struct QuarryLane {
  std::string name;
  double axis = 0.0;            ///< y of its middle
  double release_height = 0.0;  ///< z of the release points
  std::vector<Vec2> section;    ///< (x, height), broken lines
  /// Zones by their upper limit in x, in order; the last one is unlimited.
  std::vector<std::pair<double, std::string>> zones;
};

const std::vector<QuarryLane>& list_quarry_lanes();

/// Returns one surface mesh per zone; shared vertices are bit-identical.
struct QuarryZone {
  std::string name;
  TriangleMesh mesh;
};
std::vector<QuarryZone> quarry_zones();

/// Formats the corners of a 4 m x 4 m release area at the top of a lane as lines "x y z".
std::string release_points(const QuarryLane& lane);

}  // namespace clast
