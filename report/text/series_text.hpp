#pragma once
/// Terminal output of series of varied blocks.
#include <span>
#include <string>

#include "core/text_table.hpp"
#include "library/block_series.hpp"

namespace clast {

/// Makes a text table of varied blocks, one row per block.
TextTable make_series_table(std::span<const Block> blocks);

/// Describes the agreement of sampled bodies with their population, one line per correlation.
std::string describe_copula_fit(const CopulaFit& fit);

}  // namespace clast
