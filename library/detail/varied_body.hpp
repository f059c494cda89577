#pragma once
/// The bodies of variations, before they get their size.
#include <optional>
#include <string>

#include "library/block_variation.hpp"

namespace clast::library_detail {

struct VariedBody {
  SpheroPolyhedron body;
  std::string figures;  ///< "key=value" pairs beyond those of the variation
};

VariedBody vary_body(const Block& parent, const StretchVariation& wanted);
VariedBody vary_body(const Block& parent, const ConvexityVariation& wanted);
VariedBody vary_body(const Block& parent, const RoundingVariation& wanted);
VariedBody vary_body(const Block& parent, const VertexCountVariation& wanted);
VariedBody vary_body(const Block& parent, const DetailVariation& wanted);
VariedBody vary_body(const Block& parent, const ReferenceVariation& wanted);
VariedBody vary_body(const Block& parent, const InertiaVariation& wanted);
VariedBody vary_body(const Block& parent, const SampledFormVariation& wanted);

}  // namespace clast::library_detail
