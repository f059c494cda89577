#pragma once
/// A block's twin that differs in one thing.
#include <optional>
#include <string>
#include <variant>

#include "library/block.hpp"
#include "shapes/box_stretch.hpp"
#include "shapes/reference_bodies.hpp"

namespace clast {

/// Edges of the mesh that roundness is measured on, over the diameter of the ball of equal volume.
inline constexpr double kDefaultRoundnessEdge = 0.05;

/// The smallest box gets these ratios; all else is stretched with it.
struct StretchVariation {
  BoxRatios ratios;
};
/// Hollows are filled until volume over that of the hull, both rounded, is this. The hull, and with
/// it L, I, S, stays.
struct ConvexityVariation {
  double convexity = 1.0;
};
/// Edges and corners get this radius, as a share of S; I/L and S/L stay.
struct RoundingVariation {
  double radius_share = 0.02;
};
/// Edges and corners get the radius with which Wadell's roundness is this (classify/roundness.hpp);
/// I/L and S/L stay.
struct RoundnessVariation {
  double roundness = 0.5;
  double edge_fraction = kDefaultRoundnessEdge;  ///< of the mesh it is measured on, see there
};
/// The core gets so many vertices; I/L and S/L stay.
struct VertexCountVariation {
  std::size_t vertices = 250;
};
/// The core's detail is multiplied (shapes/surface_detail.hpp); I/L and S/L stay.
struct DetailVariation {
  double gain = 0.0;
  int degree = 6;
};
/// A simple body with the block's I/L and S/L and its radius as a share of S.
struct ReferenceVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;
  double exponent = 4.0;  ///< of the superellipsoid
};
/// The ellipsoid, or the box, with the block's mass and principal moments, at the density that this
/// takes: alike in free motion, and different in contact.
struct InertiaVariation {
  ReferenceShape form = ReferenceShape::kEllipsoid;  ///< or a box
};
/// A body drawn from a population (classify/form_copula.hpp): stretched to the ratios and scaled to
/// the length, hollows filled where the convexity drawn is above the block's.
struct SampledFormVariation {
  BoxRatios ratios;
  double length = 1.0;  ///< L, m
  std::optional<double> convexity;
};
using Variation = std::variant<StretchVariation, ConvexityVariation, RoundingVariation,
                               RoundnessVariation, VertexCountVariation, DetailVariation,
                               ReferenceVariation, InertiaVariation, SampledFormVariation>;

/// "stretch", "convexity", "rounding", "roundness", "vertices", "detail", "reference", "inertia",
/// "drawn".
std::string variation_kind(const Variation& variation);
/// What distinguishes the bodies of a series from each other, in their ids: "il0.8_sl0.5".
std::string variation_label(const Variation& variation);

/// What a block has in common with its twins.
enum class PreservedSize { kMass, kVolume, kLength };
/// "mass", "volume", "L". @throws InputError  another name
PreservedSize parse_preserved_size(const std::string& name);
std::string name_of(PreservedSize preserved);

struct VariationOptions {
  PreservedSize keep =
      PreservedSize::kMass;  ///< no matter for `InertiaVariation` and `SampledFormVariation`
  double accuracy = 1e-4;    ///< relative, of volume and inertia

  void check() const;  ///< throws InputError naming the field and its value
};

/// Targets are reached to this, relative; else the block is refused.
inline constexpr double kVariationTolerance = 5e-3;
/// Roundness is measured on a mesh, which makes it uneven by about half of this.
inline constexpr double kRoundnessTolerance = 1e-2;

/// The twin, a block made of a core and a radius. What was done, with its figures, is in
/// `source.options` (`parse_variation` reads it back); `source` is otherwise as given.
/// @param source  the library that the parent is in, and its hash
/// @throws InputError, GeometryError  a target that can't be reached, with the block's id, the
///                        target, and the nearest that can
Block vary_block(const std::string& id, const Block& parent, const Variation& variation,
                 BlockSource source, const VariationOptions& options = {});

/// What `source.options` of a block that `vary_block` made says.
struct VariationRecord {
  std::string kind;
  std::string parent;             ///< id
  std::optional<BoxRatios> form;  ///< target of a stretch, or of a body that was drawn
  double step = 0.0;              ///< target of the others; 0 of references
  std::string reference;          ///< name of a reference body
};
/// None: the block is no variation.
std::optional<VariationRecord> parse_variation(const Block& block);
/// "stretch to 0.8, 0.5", "vertices 250", "ellipsoid".
std::string describe_variation(const VariationRecord& record);

}  // namespace clast
