#include "library/unscaled.hpp"

namespace clast {

std::string explain_unscaled_block() {
  return "its photographs gave no scale: lengths are in units of the cameras' model, shape and "
         "classes are usable, and there is no mass. Make it again with `bars`, `board`, "
         "`marker_side`, `scale_points` or `scale_factor`, and `replace`";
}

}  // namespace clast
