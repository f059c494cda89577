#pragma once
/// Box conventions: the box whose edges are the axes L >= I >= S of a block.
#include <array>
#include <string>

#include "massprops/mass_properties.hpp"
#include "massprops/principal_frame.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// Box on which the axes are measured. Shape classes depend on this choice, so every class is
/// reported with it.
enum class BoxConvention {
  kSmallest,  ///< smallest volume; the default everywhere
  kInertia,   ///< edges along the principal axes of inertia of the solid body
  kFeret,  ///< longest distance, then the longest width perpendicular to it, as with callipers or
           ///< tape
  kPca,    ///< edges along the principal components of the hull's vertices
};

inline constexpr std::array kBoxConventions = {BoxConvention::kSmallest, BoxConvention::kInertia,
                                               BoxConvention::kFeret, BoxConvention::kPca};

/// Returns "smallest", "inertia", "feret" or "pca".
std::string name_of(BoxConvention convention);
/// Parses the name of a convention.
/// @throws InputError  if the name is unknown; the message lists the known names
BoxConvention parse_box_convention(const std::string& name);

/// Computes the box of the rounded body by a convention.
/// @param frame  principal frame of the body; used by `kInertia` only
/// @throws GeometryError  if the body has no vertices
OrientedBox box_by_convention(const SpheroPolyhedron& body, const PrincipalFrame& frame,
                              BoxConvention convention);

}  // namespace clast
