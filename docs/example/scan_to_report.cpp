// Makes a report from scans: scan_to_report SCANS CAMPAIGN.toml FOLDER. The campaign takes its
// blocks from FOLDER/blocks.h5.
#include <iostream>

#include "core/error.hpp"
#include "pipeline/scan_batch.hpp"
#include "report/comparison_report.hpp"
#include "study/simulate/campaign_runner.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::filesystem::path folder = argv[3], results = folder / "results.h5";
  try {
    // A scan, or all of a folder, become blocks of a library.
    clast::ScanBatchOptions batch;
    batch.library = folder / "blocks.h5";
    batch.scan.block.density = 2650.0;  // kg/m^3
    clast::reconstruct_scan_batch(clast::list_scans({argv[1]}), batch);

    // They fall down the terrain of the campaign, in 4 of its orientations.
    clast::Campaign campaign = clast::read_campaign(argv[2]);
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
