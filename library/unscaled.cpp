#include "library/unscaled.hpp"

namespace clast {

std::string explain_unscaled_block() {
  return "its photographs gave no scale: lengths are in units of the camera model; shape and "
         "classes are usable, but the mass is unknown. Make the block again with `bars`, `board`, "
         "`marker_side`, `scale_points` or `scale_factor`, and `replace`";
}

}  // namespace clast
