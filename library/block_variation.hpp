#pragma once
/// Variations of a block in a single property.
#include <optional>
#include <string>
#include <variant>

#include "library/block.hpp"
#include "shapes/box_stretch.hpp"
#include "shapes/reference_bodies.hpp"

namespace clast {

/// Default edge length of the mesh for roundness, over the diameter of the ball of equal volume.
inline constexpr double kDefaultRoundnessEdge = 0.05;

/// Variation to given ratios of the smallest box, by stretching.
struct StretchVariation {
  BoxRatios ratios;
};
/// Variation to a given convexity by filling concavities; the hull, and so L, I, S, is unchanged.
struct ConvexityVariation {
  double convexity = 1.0;
};
/// Variation to a given Minkowski radius over S; I/L and S/L are kept.
struct RoundingVariation {
  double radius_share = 0.02;
};
/// Variation to a given Wadell roundness (classify/roundness.hpp) by the Minkowski radius; I/L and
/// S/L are kept.
struct RoundnessVariation {
  double roundness = 0.5;
  double edge_fraction =
      kDefaultRoundnessEdge;  ///< edge length of the mesh, see `kDefaultRoundnessEdge`
};
/// Variation to a given number of core vertices; I/L and S/L are kept.
struct VertexCountVariation {
  std::size_t vertices = 250;
};
/// Variation by scaling the surface detail (shapes/surface_detail.hpp); I/L and S/L are kept.
struct DetailVariation {
  double gain = 0.0;
  int degree = 6;
};
/// Variation to a reference body with the block's I/L, S/L and ratio of radius to S.
struct ReferenceVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;  ///< target of a stretch or of a sampled body
  double exponent = 4.0;                             ///< of the superellipsoid
};
/// Variation to the ellipsoid or box with the block's mass and principal moments, at the required
/// density: equal in free motion but different in contact.
struct InertiaVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;  ///< or a box
};
/// Variation to a shape sampled from a population (classify/form_copula.hpp): stretched to the
/// ratios, scaled to the length, and filled if the sampled convexity is above the block's.
struct SampledFormVariation {
  BoxRatios ratios;
  double length = 1.0;  ///< L, m
  std::optional<double> convexity;
};
using Variation = std::variant<StretchVariation, ConvexityVariation, RoundingVariation,
                               RoundnessVariation, VertexCountVariation, DetailVariation,
                               ReferenceVariation, InertiaVariation, SampledFormVariation>;

/// Returns "stretch", "convexity", "rounding", "roundness", "vertices", "detail", "reference",
/// "inertia" or "drawn".
std::string name_of_variation(const Variation& variation);
/// Returns the label of a variation in ids: "il0.8_sl0.5".
std::string variation_label(const Variation& variation);

enum class PreservedSize { kMass, kVolume, kLength };
/// Parses "mass", "volume" or "L".
/// @throws InputError  for another name
PreservedSize parse_preserved_size(const std::string& name);
std::string name_of(PreservedSize preserved);

struct VariationOptions {
  PreservedSize keep =
      PreservedSize::kMass;  ///< unused by `InertiaVariation` and `SampledFormVariation`
  double accuracy = 1e-4;    ///< relative accuracy of volume and inertia

  void check() const;  ///< throws InputError naming the field and its value
};

/// Relative tolerance of targets; a block beyond it is an error.
inline constexpr double kVariationTolerance = 5e-3;
/// Relative tolerance of roundness, about twice its mesh dependence.
inline constexpr double kRoundnessTolerance = 1e-2;

/// Makes the varied block. The variation and its results are stored in `source.options` (read by
/// `parse_variation`); `source` is otherwise as given.
/// @param source  library of the parent and its digest
/// @throws InputError, GeometryError  if the target cannot be reached; names the block, the target
///                                    and the nearest possible value
Block vary_block(const std::string& id, const Block& parent, const Variation& variation,
                 BlockSource source, const VariationOptions& options = {});

/// Variation that is recorded in a block's `source.options`.
struct VariationRecord {
  std::string kind;
  std::string parent;             ///< block id
  std::optional<BoxRatios> form;  ///< target of a stretch, or of a body that was drawn
  double step = 0.0;              ///< target of other variations; 0 for references
  std::string reference;          ///< name of the reference body
};
/// Parses the variation of a block; empty if it is not varied.
std::optional<VariationRecord> parse_variation(const Block& block);
/// Describes a variation: "stretch to 0.8, 0.5", "vertices 250", "ellipsoid".
std::string describe_variation(const VariationRecord& record);

}  // namespace clast
