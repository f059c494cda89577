#pragma once
/// Shape diagrams with class boundaries: Sneed-Folk triangle and Zingg plot.
#include <string>
#include <vector>

#include "classify/population_summary.hpp"

namespace clast::report_detail {

/// Maximum number of blocks that are drawn as single marks. More blocks are drawn as a density.
inline constexpr std::size_t kMaxSingleBlocks = 2000;

/// Formats the tooltip of a block: name, axes, classes, and classes close to a limit.
std::string format_block_tooltip(const MeasuredBlock& block, const PopulationOptions& options);

/// Draws the Sneed-Folk triangle of a population: compact blocks at the top, platy left, elongate
/// right. The height is S/L, the position from left to right (L - I)/(L - S).
/// @param number  index of the population in its report
std::string draw_sneed_folk_diagram(const Population& population, std::size_t number,
                                    const PopulationOptions& options = {});

/// Draws the Zingg plot of a population: I/L over S/I, with class limits at 2/3.
std::string draw_zingg_diagram(const Population& population, std::size_t number,
                               const PopulationOptions& options = {});

/// Returns the HTML attribute by which a page highlights a block in all diagrams.
std::string block_highlight_attribute(std::size_t number, std::size_t block);

}  // namespace clast::report_detail
