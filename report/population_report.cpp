#include "report/population_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "core/version.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/population_page.hpp"
#include "report/tables/population_tables.hpp"
#include "report/tables/scanned_deposit_tables.hpp"

namespace clast {

using namespace report_detail;
namespace {

nlohmann::ordered_json provenance(const PopulationReport& report,
                                  const PopulationDiagrams& diagrams) {
  nlohmann::ordered_json json;
  json["program_version"] = version();
  json["options"] = {{"size", name_of(report.options.size)},
                     {"seed", report.options.seed},
                     {"schemes", report.options.selected_schemes()},
                     {"sneed_folk_thirds", report.options.limits.sneed_folk_thirds},
                     {"erdogan_limit", report.options.limits.erdogan_limit}};
  json["populations"] = nlohmann::ordered_json::array();
  const auto or_null = [](const auto& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  for (const ReportedPopulation& reported : report.populations) {
    const AppliedMeasuringOptions& reading = reported.reading;
    auto inputs = nlohmann::ordered_json::array();
    for (const InputFile& input : reported.inputs) {
      inputs.push_back({{"file", input.file}, {"sha256", input.sha256}});
    }
    json["populations"].push_back({{"name", reported.population.name},
                                   {"blocks", reported.population.blocks.size()},
                                   {"axes", reported.measured},
                                   {"box", or_null(reading.box)},
                                   {"columns", or_null(reading.columns)},
                                   {"units", or_null(reading.units)},
                                   {"axis_error_m", or_null(reading.axis_error)},
                                   {"inputs", inputs},
                                   {"notes", reported.notes}});
  }
  json["diagrams"] = nlohmann::ordered_json::array();
  for (const auto& [name, svg] : diagrams) json["diagrams"].push_back(name + ".svg");
  return json;
}

/// Returns the names of the diagrams in the folder's provenance.json; empty if there is none.
std::set<std::string> earlier_diagrams(const std::filesystem::path& folder) {
  std::error_code code;
  const std::filesystem::path path = folder / "provenance.json";
  if (!std::filesystem::is_regular_file(path, code)) return {};
  const auto json = nlohmann::json::parse(read_text_file(path), nullptr, false);
  std::set<std::string> names;
  if (!json.is_object() || !json.contains("diagrams")) return names;
  for (const auto& name : json["diagrams"]) {
    if (name.is_string()) names.insert(name.get<std::string>());
  }
  return names;
}

}  // namespace

OutputFolderKind population_folder_kind(const std::filesystem::path& folder) {
  const auto is_own_file = [diagrams =
                                earlier_diagrams(folder)](const std::filesystem::path& file) {
    const std::string name = file.string();
    if (is_table_file(population_tables(), name)) return true;
    // Whatever someone wrote into that list: nothing but a picture in the folder is ours.
    const bool picture = file == file.filename() && file.extension() == ".svg";
    return name == "provenance.json" || name == "report.html" ||
           (picture && diagrams.contains(name));
  };
  return {"classification", "provenance.json", "\"populations\"", is_own_file};
}

void write_population_report(const PopulationReport& report, const std::filesystem::path& folder) {
  std::error_code code;
  if (std::filesystem::exists(folder, code) && !std::filesystem::is_directory(folder, code)) {
    throw InputError(folder.string() + ": is a file; name a folder for the tables and the report");
  }
  const PopulationDiagrams diagrams = draw_population_diagrams(report);
  write_classes_csv(report, folder / "classes.csv");
  const bool has_deposit =
      std::any_of(report.populations.begin(), report.populations.end(),
                  [](const ReportedPopulation& reported) { return reported.deposit.has_value(); });
  for (const PopulationTable& table : population_tables()) {
    if (table.name == "classes") continue;  // written above, never whole in memory
    if (!has_deposit && is_table_file(scanned_deposit_tables(), table.name + ".csv")) continue;
    write_text_file(folder / (table.name + ".csv"), table.csv(report));
  }
  for (const auto& [name, svg] : diagrams) {
    write_text_file(folder / (name + ".svg"), make_svg_file(svg));
  }
  write_text_file(folder / "report.html", make_population_page(report, diagrams));
  // Names may hold bytes that are not UTF-8; they must not stop it.
  write_text_file(folder / "provenance.json",
                  provenance(report, diagrams)
                          .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                      "\n");
}

}  // namespace clast
