#pragma once
/// Parts of the extension clast._core. Each function adds its classes and functions to the module.
#include <pybind11/pybind11.h>

namespace clast::python_detail {

void bind_errors(pybind11::module_& module);
void bind_blocks(pybind11::module_& module);
void bind_libraries(pybind11::module_& module);
void bind_populations(pybind11::module_& module);
void bind_rock_masses(pybind11::module_& module);
void bind_variations(pybind11::module_& module);
void bind_terrains(pybind11::module_& module);
void bind_calibrations(pybind11::module_& module);
void bind_campaigns(pybind11::module_& module);
void bind_comparisons(pybind11::module_& module);
void bind_worlds(pybind11::module_& module);

}  // namespace clast::python_detail
