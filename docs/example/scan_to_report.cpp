// From a scan to a report: scan_to_report SCAN CAMPAIGN.toml FOLDER
#include <iostream>

#include "core/error.hpp"
#include "pipeline/scan_batch.hpp"
#include "report/comparison_report.hpp"
#include "study/campaign_runner.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::filesystem::path folder = argv[3], results = folder / "results.h5";
  try {
    // The scan, or a folder of scans, becomes blocks of a library.
    clast::BatchOptions batch;
    batch.library = folder / "blocks.h5";
    batch.scan.block.density = 2650.0;  // kg/m^3
    clast::reconstruct_batch(clast::list_scans({argv[1]}), batch);

    // All of them fall down the terrain of the campaign, in 4 of its orientations.
    clast::Campaign campaign = clast::read_campaign(argv[2]);
    campaign.blocks = {.library = batch.library};
    campaign.releases.front().orientations.resize(4);
    clast::run_campaign(clast::prepare_campaign(campaign), results);

    // Tables, map layers and a page with charts.
    const clast::Comparison comparison = clast::compare({clast::read_results(results)});
    for (const auto& path : clast::write_comparison(comparison, folder / "report")) {
      std::cout << path.string() << "\n";
    }
  } catch (const clast::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
