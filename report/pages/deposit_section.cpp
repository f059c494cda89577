#include <cmath>
#include <functional>

#include "core/angle.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"

namespace clast::report_detail {
namespace {

struct Quantity {
  const char* name;
  int decimals;
  std::function<double(const RealisationDeposit&)> value;
};

const std::vector<Quantity>& quantities() {
  using Row = RealisationDeposit;
  const auto distance = [](const Vec3& from, const Vec3& to) {
    return (to - from).head<2>().norm();
  };
  static const std::vector<Quantity> kQuantities = {
      {"blocks that lie there", 1, [](const Row& row) { return static_cast<double>(row.lying); }},
      {"blocks that left the terrain", 1,
       [](const Row& row) { return static_cast<double>(row.left_terrain); }},
      {"volume of the blocks, m\xC2\xB3", 2, &Row::volume},
      {"centre of mass: distance, m", 2,
       [=](const Row& row) { return distance(row.first_centre, row.centre); }},
      {"centre of mass: drop, m", 2,
       [](const Row& row) { return row.first_centre.z() - row.centre.z(); }},
      {"centre of mass: drop / distance", 3,
       [](const Row& row) { return drop_ratio(row.first_centre, row.centre); }},
      {"crest to toe: distance L, m", 2,
       [=](const Row& row) { return distance(row.crest, row.toe); }},
      {"crest to toe: drop H, m", 2, [](const Row& row) { return row.crest.z() - row.toe.z(); }},
      {"crest to toe: H / L", 3, [](const Row& row) { return drop_ratio(row.crest, row.toe); }},
      {"crest to toe: travel angle, \xC2\xB0", 1,
       [](const Row& row) {
         return kDegreesPerRadian * std::atan(drop_ratio(row.crest, row.toe));
       }},
      {"area, m\xC2\xB2", 1, &Row::area},
      {"bulk volume, m\xC2\xB3", 2, &Row::bulk_volume},
      {"largest thickness, m", 2, &Row::thickness}};
  return kQuantities;
}

}  // namespace

std::string deposit_section(const Comparison& comparison, const RealisationDeposits& deposits) {
  if (deposits.realisations.empty()) return "";
  std::vector<std::string> heads = {"quantity"};
  std::vector<std::uint32_t> files;
  for (const RealisationDeposit& deposit : deposits.realisations) {
    if (files.empty() || files.back() != deposit.file) files.push_back(deposit.file);
  }
  for (const std::uint32_t file : files) {
    const std::string of_file =
        several_files(comparison) ? "file " + std::to_string(file + 1) + ": " : "";
    for (const char* head : {"mean and std", "least", "most"}) heads.push_back(of_file + head);
  }
  HtmlTable table(heads, 1);
  for (const Quantity& quantity : quantities()) {
    std::vector<std::string> cells = {quantity.name};
    for (const std::uint32_t file : files) {
      std::vector<double> values;
      double least = INFINITY;
      for (const RealisationDeposit& deposit : deposits.realisations) {
        const double value = quantity.value(deposit);
        if (deposit.file != file || !std::isfinite(value)) continue;
        values.push_back(value);
        least = std::min(least, value);
      }
      const Summary summary = summarise(values);
      cells.push_back(mean_and_std(summary, quantity.decimals));
      cells.push_back(measured(least, summary, quantity.decimals));
      cells.push_back(measured(summary.max, summary, quantity.decimals));
    }
    table.row(std::move(cells));
  }
  return section(
      "The deposit",
      paragraph("Mean thickness of the deposit over the realisations" +
                std::string(several_files(comparison) ? " of all files" : "") + ", m.") +
          deposit_map(comparison, deposits.rasters) +
          folded(
              "Figures of the deposit",
              paragraph("Blocks that came to rest and were not removed. The crest is the highest "
                        "start, the toe the stop farthest from it; H / L between them is the "
                        "tangent of the travel angle. The bulk volume holds the gaps between "
                        "blocks. Each realisation is a row of realisations.csv.") +
                  table.html()));
}

}  // namespace clast::report_detail
