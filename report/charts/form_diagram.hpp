#pragma once
/// Diagrams that place blocks by the proportions of their axes, with the fields of the classes.
#include <string>
#include <vector>

#include "classify/population_summary.hpp"

namespace clast::report_detail {

/// More blocks than this are drawn as a density: their marks would cover each other, and a page
/// would no longer answer the pointer.
inline constexpr std::size_t kMostSingleBlocks = 2000;

/// What is said of a block where its mark is: name, axes, classes, and which of them are near a
/// limit.
std::string format_block_title(const MeasuredBlock& block, const PopulationOptions& options);

/// The triangle of Sneed and Folk: compact q at the top, platy (1 - q)(1 - d) left, elongate (1 -
/// q) d right, with q = S/L and d = (L - I)/(L - S).
/// @param number  of the population in its report, for `page`'s data-block
std::string sneed_folk_diagram(const Population& population, std::size_t number,
                               const PopulationOptions& options = {});

/// Zingg's plot: I/L over S/I with limits of 2/3.
std::string zingg_diagram(const Population& population, std::size_t number,
                          const PopulationOptions& options = {});

/// data-block of a block, see `page`.
std::string block_element_id(std::size_t number, std::size_t block);

}  // namespace clast::report_detail
