#include "pipeline/detail/crossing_warning.hpp"

#include "core/number_text.hpp"
#include "mesh/self_intersection.hpp"

namespace clast::pipeline_detail {

void add_self_intersection_warning(Block& block, const TriangleMesh& surface) {
  const std::size_t pairs = find_self_intersections(surface).size();
  if (pairs == 0) return;
  block.warnings.push_back("the surface passes through itself at " + format_count(pairs, "pair") +
                           " of triangles: overlapping parts count twice in its volume; "
                           "repair it in MeshLab or CloudCompare");
}

}  // namespace clast::pipeline_detail
