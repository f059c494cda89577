#include "pipeline/detail/crossing_warning.hpp"

#include "core/number_text.hpp"
#include "mesh/self_intersection.hpp"

namespace clast::pipeline_detail {

void warn_of_crossings(Block& block, const TriangleMesh& surface) {
  const std::size_t pairs = crossing_triangles(surface).size();
  if (pairs == 0) return;
  block.warnings.push_back("the surface passes through itself at " + counted(pairs, "pair") +
                           " of triangles: what lies inside twice counts twice in its volume; "
                           "repair it in MeshLab or CloudCompare");
}

}  // namespace clast::pipeline_detail
