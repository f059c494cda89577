#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "study/comparison.hpp"

namespace clast {

namespace {

struct CompareArgs {
  std::vector<std::string> results;
  std::string folder = "comparison";
};

void compare_results(const CompareArgs& args) {
  if (args.folder.empty()) throw CLI::ValidationError("--output", "names no folder");
  std::vector<CampaignResults> results;
  for (const std::string& file : args.results) results.push_back(read_results(file));
  const Comparison comparison = compare(std::move(results));
  write_comparison(comparison, args.folder);
  for (const std::string& warning : comparison.warnings) {
    std::cerr << "clast: warning: " << warning << "\n";
  }
  for (const char* name : {"runs.csv", "barriers.csv", "crossings.csv", "deposits.csv",
                           "provenance.json", "stops.gpkg", "report.html"}) {
    std::cout << (std::filesystem::path(args.folder) / name).string() << "\n";
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto args = std::make_shared<CompareArgs>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compare shapes and classes: tables, map layers and one HTML report");
  command->add_option("results", args->results, "Results files of one or more campaigns")
      ->required()
      ->type_name("RESULTS");
  command->add_option("-o,--output", args->folder, "Folder, made when missing")
      ->type_name("DIR")
      ->capture_default_str();
  command->footer(
      "Writes runs.csv, barriers.csv, crossings.csv, deposits.csv, provenance.json, stops.gpkg and "
      "report.html, whose path\ncomes last. Units are in the column names.\n"
      "Example:\n  clast compare compact.h5 elongated.h5 -o comparison");
  command->callback([args] { compare_results(*args); });
}

}  // namespace clast
