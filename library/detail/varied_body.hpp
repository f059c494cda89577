#pragma once
/// Varied bodies before they are scaled to their size.
#include <optional>
#include <string>

#include "library/block_variation.hpp"

namespace clast::library_detail {

/// Body of a variation before it is scaled to its size.
struct VariationResult {
  SpheroPolyhedron body;
  std::string record;  ///< additional "key=value" pairs for `BlockSource::options`
};

VariationResult apply_variation(const Block& parent, const StretchVariation& target);
VariationResult apply_variation(const Block& parent, const ConvexityVariation& target);
VariationResult apply_variation(const Block& parent, const RoundingVariation& target);
VariationResult apply_variation(const Block& parent, const VertexCountVariation& target);
VariationResult apply_variation(const Block& parent, const DetailVariation& target);
VariationResult apply_variation(const Block& parent, const ReferenceVariation& target);
VariationResult apply_variation(const Block& parent, const InertiaVariation& target);
VariationResult apply_variation(const Block& parent, const SampledFormVariation& target);

}  // namespace clast::library_detail
