#pragma once
/// Variations of a block in a single property.
#include <optional>
#include <string>
#include <variant>

#include "library/block.hpp"
#include "shapes/box_stretch.hpp"
#include "shapes/reference_bodies.hpp"

namespace clast {

/// Default edge length of the mesh for roundness, relative to the equivalent spherical diameter.
inline constexpr double kDefaultRoundnessEdge = 0.05;

/// Variation that stretches a block to given side ratios of its smallest box.
struct StretchVariation {
  BoxRatios ratios;
};
/// Variation that fills concavities up to a given convexity. The hull and L, I, S are unchanged.
struct ConvexityVariation {
  double convexity = 1.0;
};
/// Variation that changes the ratio of Minkowski radius to S. I/L and S/L are kept.
struct RoundingVariation {
  double radius_fraction = 0.02;
};
/// Variation that changes the Minkowski radius until Wadell's roundness (classify/roundness.hpp)
/// has a given value. I/L and S/L are kept.
struct RoundnessVariation {
  double roundness = 0.5;
  double edge_fraction =
      kDefaultRoundnessEdge;  ///< relative edge length of the mesh, like `kDefaultRoundnessEdge`
};
/// Variation that simplifies the core to a given number of vertices. I/L and S/L are kept.
struct VertexCountVariation {
  std::size_t vertices = 250;
};
/// Variation that scales the surface detail (shapes/surface_detail.hpp). I/L and S/L are kept.
struct DetailVariation {
  double gain = 0.0;
  int degree = 6;
};
/// Variation that replaces a block by a reference body with the same I/L, S/L and ratio of radius
/// to S.
struct ReferenceVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;  ///< kind of reference body
  double exponent = 4.0;                             ///< exponent of the superellipsoid
};
/// Variation that replaces a block by an ellipsoid or box with the same mass and principal moments.
/// The density is adjusted. The body moves like the block in free flight but not in contact.
struct InertiaVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;  ///< ellipsoid or box
};
/// Variation that gives a block a shape sampled from a population (classify/form_copula.hpp). It is
/// stretched to the ratios and scaled to the length. Its concavities are filled if the sampled
/// convexity exceeds that of the block.
struct SampledFormVariation {
  BoxRatios ratios;
  double length = 1.0;  ///< L, m
  std::optional<double> convexity;
};
using Variation = std::variant<StretchVariation, ConvexityVariation, RoundingVariation,
                               RoundnessVariation, VertexCountVariation, DetailVariation,
                               ReferenceVariation, InertiaVariation, SampledFormVariation>;

/// Returns the kind of a variation: "stretch", "convexity", "rounding", "roundness", "vertices",
/// "detail", "reference", "inertia" or "drawn".
std::string name_of_variation(const Variation& variation);
/// Returns the label of a variation in ids, such as "il0.8_sl0.5".
std::string variation_label(const Variation& variation);

/// Quantity that is equal for a varied block and its parent.
enum class PreservedSize { kMass, kVolume, kLength };
/// Parses the name of a preserved size: "mass", "volume" or "L".
/// @throws InputError  if the name is unknown
PreservedSize parse_preserved_size(const std::string& name);
std::string name_of(PreservedSize preserved);

struct VariationOptions {
  PreservedSize preserved_size =
      PreservedSize::kMass;  ///< not used by `InertiaVariation` and `SampledFormVariation`
  double accuracy = 1e-4;    ///< relative accuracy of volume and inertia

  void check() const;  ///< throws InputError naming the field and its value
};

/// Maximum relative deviation of a varied block from its target. A larger one is an error.
inline constexpr double kVariationTolerance = 5e-3;
/// Relative tolerance of the roundness, about twice its dependence on the mesh.
inline constexpr double kRoundnessTolerance = 1e-2;

/// Makes a varied block. The variation and its results are appended to `source.options`, from which
/// `parse_variation` reads them.
/// @param source  library of the parent, with its digest
/// @throws InputError, GeometryError  if the target cannot be reached; names the block, the target
///                                    and the nearest possible value
Block vary_block(const std::string& id, const Block& parent, const Variation& variation,
                 BlockSource source, const VariationOptions& options = {});

/// Variation that is stored in `source.options` of a block.
struct VariationRecord {
  std::string kind;
  std::string parent;                      ///< id of the varied block
  std::optional<BoxRatios> target_ratios;  ///< target ratios of a stretched or sampled body
  double target_value = 0.0;               ///< target of other variations; 0 for reference bodies
  std::string reference;                   ///< name of the reference body
};
/// Parses the variation of a block. Empty if the block is not a variation.
std::optional<VariationRecord> parse_variation(const Block& block);
/// Describes a variation, such as "stretch to 0.8, 0.5", "vertices 250" or "ellipsoid".
std::string describe_variation(const VariationRecord& record);

}  // namespace clast
