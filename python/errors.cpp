#include <pybind11/pybind11.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "python/bindings.hpp"

namespace clast::python_detail {

namespace py = pybind11;

void bind_errors(py::module_& module) {
  auto& error = py::register_exception<Error>(module, "Error");
  error.attr("__doc__") =
      "Base class of the errors of clast; the message states what failed, on which item and with "
      "which value.";
  py::register_exception<InputError>(module, "InputError", error).attr("__doc__") =
      "A file, argument or value that can't be used.";
  py::register_exception<GeometryError>(module, "GeometryError", error).attr("__doc__") =
      "A shape lacks a property that an operation needs.";
  py::register_exception<SimulationError>(module, "SimulationError", error).attr("__doc__") =
      "A simulation can't be set up or can't continue, or some of its runs failed with an error.";
  for (const char* name : {"Error", "InputError", "GeometryError", "SimulationError"}) {
    module.attr(name).attr("__module__") = "clast";
  }
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::filesystem::filesystem_error& failure) {
      PyErr_SetString(PyExc_OSError, failure.what());
    }
  });
}

}  // namespace clast::python_detail
