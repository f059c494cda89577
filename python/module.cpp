// The extension clast._core: everything but what needs PCL and OpenCV.
#include "core/version.hpp"
#include "python/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace clast::python_detail;
  module.doc() = "Internal extension of the package clast; use import clast.";
  module.attr("version") = clast::version();
  bind_errors(module);
  bind_blocks(module);
  bind_libraries(module);
  bind_populations(module);
  bind_rock_masses(module);
  bind_variations(module);
  bind_terrains(module);
  bind_calibrations(module);
  bind_campaigns(module);
  bind_comparisons(module);
  bind_worlds(module);
}
