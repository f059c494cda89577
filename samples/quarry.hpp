#pragma once
/// A quarry slope with a cliff, benches and three ground zones, after the sections of a real
/// quarry. x runs down the slope, y along the face, z up, m.
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A lane: its section is straight for 60 m along the face.
struct QuarryLane {
  std::string name;
  double axis = 0.0;            ///< y of its middle
  double release_height = 0.0;  ///< z of the release points
  std::vector<Vec2> section;    ///< (x, height), broken lines
  /// Zone up to x, in order; the last goes on to the end.
  std::vector<std::pair<double, std::string>> zones;
};

const std::vector<QuarryLane>& list_quarry_lanes();

/// One mesh of the surface per zone; shared vertices are equal to the bit.
struct QuarryZone {
  std::string name;
  TriangleMesh mesh;
};
std::vector<QuarryZone> quarry_zones();

/// Corners of a 4 x 4 m square at the head of a lane, as lines "x y z".
std::string release_points(const QuarryLane& lane);

}  // namespace clast
