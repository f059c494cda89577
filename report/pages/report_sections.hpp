#pragma once
/// The sections of the HTML report, in the order they are read.
#include <string>

#include "study/compare/comparison_analyses.hpp"

namespace clast::report_detail {

/// Title, answer, large numbers, and what could turn the answer round.
std::string format_head_section(const Comparison& comparison, const KeyResults& answer);
/// Classes side by side: the figures the study is about.
std::string format_class_section(const Comparison& comparison);
/// The rasters of deposits over the relief; empty without layers.
std::string format_deposit_map(const Comparison& comparison, const MapRasterSet& rasters);
/// Where the blocks of a realisation lie as a whole: how far the mass of them came, how large and
/// thick the deposit is; empty where no block stayed.
std::string format_deposit_section(const ComparisonAnalyses& analyses);
/// Kinetic energy and what it becomes, against time, of blocks that stay; empty where the results
/// don't know.
std::string format_energy_section(const ComparisonAnalyses& analyses);
/// How blocks that stay were hit and moved on by later ones, by class; empty where none was
/// released after another.
std::string format_persistent_blocks_section(const Comparison& comparison);
/// A row per block (and file) with its shape, its runs and how they ended.
std::string format_block_section(const Comparison& comparison);
/// Stops, and the rasters of paths and deposits, one at a time over the relief.
std::string format_map_section(const Comparison& comparison, const MapRasterSet& paths,
                        const MapRasterSet& deposits);
/// Distributions of runout and lateral angle.
std::string format_runout_section(const Comparison& comparison);
/// Energy and passing heights against distance, and the ground under the mean path.
std::string format_slope_section(const Comparison& comparison, const std::vector<ProfileBin>& bins);
/// How large and how sure the differences between classes are, and how they were tested.
std::string format_differences_section(const Comparison& comparison);
/// Measured stops against simulated ones; empty without.
std::string format_measured_section(const Comparison& comparison);
/// What drawn ground parameters do to runout and barriers; empty without ensembles.
std::string format_ensemble_section(const ComparisonAnalyses& analyses);
/// What the variance of outcomes is due to; empty where no campaign runs every combination.
std::string format_effects_section(const ComparisonAnalyses& analyses);
/// A table and exceedance curves for every barrier.
std::string format_barrier_section(const ComparisonAnalyses& analyses);
/// Energy balance, penetration, and every run that did not come to rest.
std::string format_quality_section(const Comparison& comparison);
/// Settings, ground, inputs with hashes, the campaign files, and the lesser warnings.
std::string format_provenance_section(const Comparison& comparison);

}  // namespace clast::report_detail
