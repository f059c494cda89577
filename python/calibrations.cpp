// Ground parameters from observations: what `clast calibrate` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/calibration_report.hpp"
#include "report/json/calibration_json.hpp"
#include "report/text/calibration_text.hpp"

namespace clast::python_detail {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

/// A column of draws per unknown, in its unit, and how well each draw explains the observations.
TableValues draws_of(const Calibration& calibration) {
  TableValues table;
  const CalibrationPosterior& posterior = calibration.posterior;
  for (std::size_t i = 0; i < calibration.study.unknowns.size(); ++i) {
    const std::string& name = calibration.study.unknowns[i].parameter;
    const Eigen::VectorXd row = posterior.draws.row(static_cast<Eigen::Index>(i)).transpose();
    table.push_back({name, parameter_range(name).unit, unknown_in_words(name),
                     std::vector<double>(row.begin(), row.end())});
  }
  table.push_back(
      {"log_likelihood", "", "logarithm of the likelihood of the observations",
       std::vector<double>(posterior.log_likelihood.begin(), posterior.log_likelihood.end())});
  return table;
}

/// (page, table of draws, what `clast calibrate --json` prints)
py::tuple calibrate_study(const fs::path& study, const fs::path& output, const py::dict& keywords,
                          const py::object& progress) {
  Keywords given(keywords);
  CalibrateOptions options;
  given.take("threads", options.threads);
  given.take("resume", options.resume);
  given.take("replace", options.replace);
  given.done();
  const Calibration found = watched(progress, [&](const Progress& step) {
    options.progress = step;
    return calibrate_with_page(read_calibration_study(study), output, options);
  });
  return py::make_tuple(calibration_page_file(output).string(), table_of(draws_of(found)),
                        object_of(calibration_json(found)));
}

}  // namespace

void bind_calibrations(py::module_& module) { module.def("calibrate", &calibrate_study); }

}  // namespace clast::python_detail
