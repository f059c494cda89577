#pragma once
/// Series of varied blocks, as JSON.
#include <nlohmann/json.hpp>
#include <optional>

#include "library/block_series.hpp"

namespace clast {

/// Returns a series of varied blocks as JSON (docs/formats.md).
nlohmann::ordered_json series_json(const VariedBlockSeries& series,
                                   const std::optional<CopulaFit>& fit);

}  // namespace clast
