// Populations of blocks: what `clast classify` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/output_folder.hpp"
#include "python/bindings.hpp"
#include "python/options.hpp"
#include "python/values.hpp"
#include "python/watched_call.hpp"
#include "report/json/population_json.hpp"
#include "report/population_reading.hpp"
#include "report/population_report.hpp"
#include "report/tables/population_tables.hpp"
#include "report/text/population_text.hpp"
#include "report/text/scanned_deposit_text.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

PopulationReportRequest population_request(Keywords& given) {
  PopulationReportRequest request;
  request.first.inputs = given.read_texts("inputs");
  request.against.inputs = given.read_texts("against");
  given.read("columns", request.first.columns);
  given.read("units", request.first.units);
  given.read("against_columns", request.against.columns);
  given.read("against_units", request.against.units);
  request.reading.box_given = given.has("box");
  given.read("box", request.reading.box);
  given.read("axis_error", request.reading.axis_error);
  given.read("roundness", request.reading.roundness_edge);
  request.reading.surfaces = request.reading.roundness_edge.has_value();
  given.read("thirds", request.options.limits.sneed_folk_thirds);
  given.read("erdogan_limit", request.options.limits.erdogan_limit);
  given.read("seed", request.options.seed);
  if (given.has("size")) {
    const auto size = py::cast<std::string>(given.given_object("size"));
    if (size != "I" && size != "mean") {
      throw InputError("size = \"" + size + "\" must be \"I\" or \"mean\"");
    }
    request.options.size = size == "I" ? SizeMeasure::kIntermediate : SizeMeasure::kMean;
  }
  for (const std::string& schemes : given.read_texts("scheme")) {
    for (const std::string& scheme : split_comma_separated(schemes)) {
      request.options.schemes.push_back(scheme);
    }
  }
  if (request.options.schemes == std::vector<std::string>{"all"}) request.options.schemes.clear();
  given.check_all_used();
  return request;
}

std::shared_ptr<PopulationReport> classify(const py::dict& keywords) {
  Keywords given(keywords);
  const PopulationReportRequest request = population_request(given);
  return run_without_gil([&] {
    request.check();
    return std::make_shared<PopulationReport>(read_populations(request));
  });
}

std::string words_of(const PopulationReport& report) {
  std::string text;
  for (const ReportedPopulation& reported : report.populations) {
    text += (text.empty() ? "" : "\n") + format_population_summary(reported.summary);
    if (reported.deposit) text += format_scanned_deposit(*reported.deposit);
  }
  return report.comparison ? text + format_population_comparison(*report.comparison) : text;
}

std::vector<std::string> notes_of(const PopulationReport& report) {
  std::vector<std::string> notes;
  for (const ReportedPopulation& one : report.populations) {
    notes.insert(notes.end(), one.notes.begin(), one.notes.end());
  }
  return notes;
}

}  // namespace

void bind_populations(py::module_& module) {
  py::class_<PopulationReport, std::shared_ptr<PopulationReport>>(module, "PopulationReport")
      .def("table",
           [](const PopulationReport& report, const std::string& name) {
             return make_table_dicts(run_without_gil(
                 [&] { return find_report_table(population_tables(), name).values(report); }));
           })
      .def("json",
           [](const PopulationReport& report) {
             std::ostringstream text;
             write_population_json(text, report);
             return text.str();
           })
      .def("words", &words_of)
      .def("notes", &notes_of)
      .def("write",
           [](const PopulationReport& report, const std::filesystem::path& folder, bool replace) {
             run_without_gil([&] {
               OutputFolder output(folder, population_folder_kind(folder), replace);
               write_population_report(report, output.temporary_path());
               output.commit();
             });
           });
  module.attr("population_tables") = table_names(population_tables());
  module.attr("schemes") = scheme_names();
  module.def("classify", &classify);
}

}  // namespace clast::python_detail
