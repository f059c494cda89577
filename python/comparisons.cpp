// Results of campaigns, and what `clast compare` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/files/output_folder.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/comparison_report.hpp"
#include "report/json/campaign_json.hpp"
#include "report/page_pdf.hpp"
#include "report/tables/comparison_tables.hpp"
#include "report/text/effects_text.hpp"
#include "report/text/key_results_text.hpp"
#include "report/text/measured_text.hpp"
#include "report/text/trends_text.hpp"

namespace clast::python_detail {

namespace py = pybind11;
using namespace pybind11::literals;
namespace fs = std::filesystem;

namespace {

using SharedResults = std::shared_ptr<CampaignResults>;

struct ComparisonHolder {
  explicit ComparisonHolder(Comparison compared) : comparison(std::move(compared)) {}

  Comparison comparison;
  ComparisonAnalyses analyses{comparison};
};

SharedResults load_results(const fs::path& path) {
  return run_without_gil([&] { return std::make_shared<CampaignResults>(read_results(path)); });
}

/// Numbers of every state, in columns.
template <class Numbers>
py::array_t<double> rows_of_states(const Trajectory& trajectory, py::ssize_t columns,
                                   const Numbers& numbers) {
  py::array_t<double> rows({static_cast<py::ssize_t>(trajectory.states.size()), columns});
  double* cell = rows.mutable_data();
  for (const RigidState& state : trajectory.states) {
    for (const double number : numbers(state)) *cell++ = number;
  }
  return rows;
}

std::array<double, 3> numbers_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Positions on the map.
py::dict trajectory_of(const CampaignResults& results, std::uint32_t run) {
  Trajectory found = run_without_gil([&] { return read_trajectory(results.file, run); });
  const py::array position = rows_of_states(found, 3, [&](const RigidState& state) {
    return numbers_of(results.frame.to_map(state.position));
  });
  const py::array orientation = rows_of_states(found, 4, [](const RigidState& state) {
    const Quat& q = state.orientation;
    return std::array<double, 4>{q.w(), q.x(), q.y(), q.z()};
  });
  const py::array velocity =
      rows_of_states(found, 3, [](const RigidState& state) { return numbers_of(state.velocity); });
  const py::array spin = rows_of_states(
      found, 3, [](const RigidState& state) { return numbers_of(state.angular_velocity); });
  return py::dict("time_s"_a = make_owning_array(std::move(found.time)), "position_m"_a = position,
                  "orientation"_a = orientation, "velocity_m_s"_a = velocity,
                  "angular_velocity_rad_s"_a = spin);
}

std::shared_ptr<ComparisonHolder> compare_all(const std::vector<SharedResults>& results,
                                              const std::vector<std::string>& by,
                                              const std::optional<fs::path>& measured,
                                              const std::optional<double>& margin) {
  return run_with_progress(py::none(), [&](const ProgressCallback&) {
    std::vector<CampaignResults> copies;
    for (const SharedResults& one : results) copies.push_back(*one);
    return std::make_shared<ComparisonHolder>(
        compare(std::move(copies), {.by = by, .measured = measured, .margin = margin}));
  });
}

std::vector<std::string> sentences(const ComparisonHolder& of) {
  std::vector<std::string> lines = describe_key_results(of.comparison, of.analyses.key_results());
  const std::vector<std::string> observed = describe_measured_stops(of.comparison);
  lines.insert(lines.end(), observed.begin(), observed.end());
  return lines;
}

/// The files that were written; the report is the last.
std::vector<std::string> write(const ComparisonHolder& of, const fs::path& folder,
                               const py::dict& keywords) {
  Keywords given(keywords);
  ComparisonReportOptions extras;
  bool replace = false, pdf = false;
  given.read("animate", extras.animated_runs);
  given.read("replace", replace);
  given.read("pdf", pdf);
  given.check_all_used();
  return run_with_progress(py::none(), [&](const ProgressCallback&) {
    if (pdf) extras.browser = find_browser();
    OutputFolder output(folder, comparison_folder_kind(), replace);
    const WrittenReport filled = write_report_folder(output, of.analyses, extras);
    if (filled.pdf_failure) {
      throw InputError(folder.string() + " holds the report, but report.pdf could not be made: " +
                       *filled.pdf_failure);
    }
    std::vector<std::string> files;
    for (const fs::path& file : filled.files) files.push_back((folder / file).string());
    return files;
  });
}

}  // namespace

void bind_comparisons(py::module_& module) {
  py::class_<CampaignResults, SharedResults>(module, "ResultsData")
      .def_property_readonly("file", [](const CampaignResults& r) { return r.file.string(); })
      .def_readonly("campaign_text", &CampaignResults::campaign_text)
      .def_readonly("campaign_sha256", &CampaignResults::campaign_sha256)
      .def_readonly("inputs", &CampaignResults::inputs)
      .def_readonly("program_version", &CampaignResults::program_version)
      .def_readonly("engine", &CampaignHeader::engine)
      .def_readonly("zone_names", &CampaignResults::zone_names)
      .def_readonly("warnings", &CampaignResults::warnings)
      .def_readonly("planned_runs", &CampaignResults::planned_runs)
      .def("summary", [](const CampaignResults& r) { return to_python_object(outcome_json(r)); })
      .def("trajectory", &trajectory_of);
  py::class_<ComparisonHolder, std::shared_ptr<ComparisonHolder>>(module, "ComparisonData")
      .def("table",
           [](const ComparisonHolder& of, const std::string& name) {
             return make_table_dicts(run_without_gil(
                 [&] { return find_report_table(comparison_tables(), name).values(of.analyses); }));
           })
      .def_property_readonly("warnings",
                             [](const ComparisonHolder& of) { return of.comparison.warnings; })
      .def("sentences", &sentences)
      .def("first_screen",
           [](const ComparisonHolder& of) {
             return describe_results_and_warnings(of.comparison, of.analyses.key_results());
           })
      .def("effects",
           [](const ComparisonHolder& of) {
             std::vector<std::string> lines = describe_effects(of.analyses.design_effects());
             for (std::string& line :
                  describe_trends(of.analyses.shape_trends(), of.comparison.margin)) {
               lines.push_back(std::move(line));
             }
             return lines;
           })
      .def("write", &write);
  module.attr("comparison_tables") = table_names(comparison_tables());
  module.def("results_read", &load_results);
  module.def("compare", &compare_all);
}

}  // namespace clast::python_detail
