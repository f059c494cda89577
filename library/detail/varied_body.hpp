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

VariedBody varied_body(const Block& parent, const StretchTo& wanted);
VariedBody varied_body(const Block& parent, const ConvexityOf& wanted);
VariedBody varied_body(const Block& parent, const RoundingOf& wanted);
VariedBody varied_body(const Block& parent, const VertexCount& wanted);
VariedBody varied_body(const Block& parent, const DetailTimes& wanted);
VariedBody varied_body(const Block& parent, const ReferenceTo& wanted);
VariedBody varied_body(const Block& parent, const InertiaTwin& wanted);
VariedBody varied_body(const Block& parent, const DrawnForm& wanted);

}  // namespace clast::library_detail
