#pragma once
/// Repair of damaged rocks over seeds and intensities, as a table.
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// One repair of one damaged rock.
struct Trial {
  bool valid = false;            ///< closed 2-manifold in one piece, outward, without crossings
  double volume_error = 0.0;     ///< relative to the undamaged rock
  double hausdorff = 0.0;        ///< both ways, at the vertices, m
  double largest_hole = 0.0;     ///< radius, m
  double lost_share = 0.0;       ///< of the area
  double filled_fraction = 0.0;  ///< as reported
  std::string refusal;           ///< empty: it was repaired
};

Trial mend_damaged(const TriangleMesh& rock, double intensity, std::uint64_t seed);

/// Largest distance of a vertex of one mesh from the other, both ways.
double vertex_hausdorff(const TriangleMesh& a, const TriangleMesh& b);

/// A line of the table: name, trials, valid ones, worst errors, and distances over hole radii.
std::string table_line(const std::string& name, const std::vector<Trial>& trials);

}  // namespace clast
