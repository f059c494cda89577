#pragma once
/// Series of varied blocks as text.
#include <span>
#include <string>

#include "core/text_table.hpp"
#include "library/block_series.hpp"

namespace clast {

/// A row per body: id, what was varied, I/L, S/L, convexity, volume, mass, class.
TextTable make_series_table(std::span<const Block> blocks);

/// How well drawn bodies stand for their population, a line for each correlation.
std::string describe_copula_fit(const CopulaFit& fit);

}  // namespace clast
