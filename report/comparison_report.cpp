#include "report/comparison_report.hpp"

#include <set>
#include <string>

#include "core/error.hpp"
#include "core/files/text_file.hpp"
#include "report/charts/form_responses.hpp"
#include "report/gdal/geopackage.hpp"
#include "report/html/html_page.hpp"
#include "report/maps/raster_files.hpp"
#include "report/page_pdf.hpp"
#include "report/pages/comparison_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/scene/vtk_animation.hpp"
#include "report/tables/comparison_provenance.hpp"
#include "report/tables/comparison_tables.hpp"

namespace clast {

using namespace report_detail;

OutputFolderKind comparison_folder_kind() {
  const auto is_own_file = [](const std::filesystem::path& file) {
    static const std::set<std::string> kFiles = {"stops.gpkg", "provenance.json", "report.html",
                                                 "report.pdf",
                                                 // written by clast 0.2 and before
                                                 "fabric.csv", "neighbours.csv", "sorting.csv"};
    const std::string folder = file.parent_path().string(), extension = file.extension().string();
    if (folder == "rasters") return extension == ".tif" || extension == ".qml";
    if (folder == "animation") return extension == ".vtp" || extension == ".pvd";
    if (folder.empty() && extension == ".svg") return file.string().starts_with("response_");
    return kFiles.contains(file.string()) || is_table_file(comparison_tables(), file.string());
  };
  return {"comparison", "provenance.json", "\"downslope_from\"", is_own_file};
}

std::vector<std::filesystem::path> write_comparison(const ComparisonAnalyses& analyses,
                                                    const std::filesystem::path& folder) {
  std::error_code code;
  if (std::filesystem::exists(folder, code) && !std::filesystem::is_directory(folder, code)) {
    throw InputError(folder.string() + ": is a file; name a folder for the tables and the report");
  }
  const Comparison& comparison = analyses.comparison();
  std::vector<std::filesystem::path> written;
  const auto write = [&](const std::string& name, const std::string& text) {
    written.push_back(folder / name);
    write_text_file(written.back(), text);
  };
  for (const ComparisonTable& table : comparison_tables()) {
    if (table.name == "measured" && !comparison.measured) continue;
    write(table.name + ".csv", table.csv(analyses));
  }
  for (const ResponseDiagram& picture :
       draw_response_diagrams(analyses.shape_outcomes(), has_several_files(comparison))) {
    write(picture.file, make_svg_file(picture.svg));
  }
  write("provenance.json", make_provenance_json(analyses));
  written.push_back(folder / "stops.gpkg");
  write_geopackage(written.back(), comparison);
  for (const MapRasterSet* rasters :
       {&analyses.path_rasters(), &analyses.deposit_results().rasters}) {
    const std::vector<std::filesystem::path> files =
        write_rasters(folder / "rasters", *rasters, comparison.results.front().frame.crs);
    written.insert(written.end(), files.begin(), files.end());
  }
  write("report.html", make_comparison_page(analyses));
  return written;
}

namespace {

/// The report as PDF beside the page; where that fails, why.
std::optional<std::string> print_report(const std::filesystem::path& folder,
                                        const std::filesystem::path& browser) {
  try {
    print_page_to_pdf(folder / "report.html", folder / "report.pdf", browser);
  } catch (const InputError& error) {
    return error.what();
  }
  return std::nullopt;
}

}  // namespace

WrittenReport write_report_folder(OutputFolder& folder, const ComparisonAnalyses& analyses,
                                  const ComparisonReportOptions& extras) {
  std::vector<std::filesystem::path> written = write_comparison(analyses, folder.temporary_path());
  if (extras.animated_runs > 0) {
    const std::filesystem::path animation = write_animation(
        folder.temporary_path() / "animation", analyses.comparison(), extras.animated_runs);
    if (animation.empty()) {
      throw InputError(
          "no trajectory is stored, so nothing can be animated; set [run] "
          "trajectory_interval_s above zero");
    }
    written.insert(written.begin(), animation);
  }
  WrittenReport filled;
  if (!extras.browser.empty()) {
    filled.pdf_failure = print_report(folder.temporary_path(), extras.browser);
    if (!filled.pdf_failure)
      written.insert(written.end() - 1, folder.temporary_path() / "report.pdf");
  }
  folder.commit();
  for (const std::filesystem::path& file : written) {
    filled.files.push_back(file.lexically_relative(folder.temporary_path()));
  }
  return filled;
}

}  // namespace clast
