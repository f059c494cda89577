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
#include "report/json/key_schema.hpp"
#include "report/text/calibration_text.hpp"
#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/study_check.hpp"
#include "study/simulate/results_place.hpp"

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
    table.push_back({name, calibratable_range(name).unit, describe_unknown(name),
                     std::vector<double>(row.begin(), row.end())});
  }
  table.push_back(
      {"log_likelihood", "", "logarithm of the likelihood of the observations",
       std::vector<double>(posterior.log_likelihood.begin(), posterior.log_likelihood.end())});
  return table;
}

CalibrationOptions common_options(Keywords& given) {
  CalibrationOptions options;
  given.read("threads", options.threads);
  given.read("resume", options.resume);
  given.read("replace", options.replace);
  return options;
}

/// (page, table of draws, what `clast calibrate --json` prints)
py::tuple calibrate_study(const fs::path& study, const fs::path& output, const py::dict& keywords,
                          const py::object& progress) {
  Keywords given(keywords);
  CalibrationOptions options = common_options(given);
  given.read("parts", options.parts);
  given.check_all_used();
  const Calibration found = run_with_progress(progress, [&](const ProgressCallback& step) {
    options.progress = step;
    return calibrate_and_report(read_calibration_study(study), output, options);
  });
  return py::make_tuple(calibration_page_file(output).string(), make_table_dicts(draws_of(found)),
                        to_python_object(calibration_json(found)));
}

/// The file of the shard.
std::string calibrate_shard(const fs::path& study, const fs::path& output,
                            const std::pair<std::uint32_t, std::uint32_t>& shard,
                            const py::dict& keywords, const py::object& progress) {
  Keywords given(keywords);
  CalibrationOptions options = common_options(given);
  given.check_all_used();
  options.shard = {shard.first, shard.second};
  options.shard.check();
  const fs::path target = shard_results_path(output, options.shard);
  run_with_progress(progress, [&](const ProgressCallback& step) {
    options.progress = step;
    return run_calibration(read_calibration_study(study), target, options);
  });
  return target.string();
}

std::vector<std::string> check_study(const fs::path& study) {
  return run_without_gil([&] { return check_calibration_study(study).findings; });
}

}  // namespace

void bind_calibrations(py::module_& module) {
  module.attr("calibration_tables") = key_tables_to_dict(calibration_key_tables());
  module.def("calibrate", &calibrate_study);
  module.def("calibrate_shard", &calibrate_shard);
  module.def("check_calibration", &check_study);
  module.def("calibration_schema", [] { return to_python_object(calibration_schema()); });
}

}  // namespace clast::python_detail
