#pragma once
/// Sections of the HTML report, in reading order.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast::report_detail {

/// Formats the head of the report: title, key results, key figures and warnings.
std::string format_head_section(const Comparison& comparison, const KeyResults& answer);
std::string format_class_section(const Comparison& comparison);
/// Formats the map of deposit rasters. Empty if there are no layers.
std::string format_deposit_map(const Comparison& comparison, const MapRasterSet& rasters);
/// Formats position, size and thickness of the deposits. Empty if no blocks stay on the terrain.
std::string format_deposit_section(const ComparisonAnalyses& analyses);
/// Formats the energies of all blocks that stay on the terrain, against time; empty without data.
std::string format_energy_section(const ComparisonAnalyses& analyses);
/// Formats how often later blocks hit and displace blocks at rest, by shape class. Empty if no
/// block was released after another.
std::string format_persistent_blocks_section(const Comparison& comparison);
/// Formats a table with one row per block and file: shape, runs and stop reasons.
std::string format_block_section(const Comparison& comparison);
/// Formats the map of stops with selectable path and deposit rasters.
std::string format_map_section(const Comparison& comparison, const MapRasterSet& paths,
                               const MapRasterSet& deposits);
/// Formats the distributions of runout and lateral angle.
std::string format_runout_section(const Comparison& comparison);
/// Formats energy and passing height against distance, with the ground profile of the mean path.
std::string format_slope_section(const Comparison& comparison, const std::vector<ProfileBin>& bins);
/// Formats the differences between classes with intervals and tests.
std::string format_differences_section(const Comparison& comparison);
/// Formats the comparison of observed and simulated stops; empty without observations.
std::string format_measured_section(const Comparison& comparison);
/// Formats the effect of uncertain ground parameters on runout and barriers; empty without
/// ensembles.
std::string format_ensemble_section(const ComparisonAnalyses& analyses);
/// Formats the fractions of the variance of outcomes that are due to shape, mass, orientation,
/// release point and ground. Empty if the campaigns vary at most one of them.
std::string format_effects_section(const ComparisonAnalyses& analyses);
/// Formats a table and exceedance curves for each barrier.
std::string format_barrier_section(const ComparisonAnalyses& analyses);
/// Formats the section on the quality of the runs: energy balance, penetration, and runs that did
/// not come to rest.
std::string format_quality_section(const Comparison& comparison);
/// Formats the section on provenance: settings, ground parameters, inputs with digests, and
/// campaign files.
std::string format_provenance_section(const Comparison& comparison);

}  // namespace clast::report_detail
