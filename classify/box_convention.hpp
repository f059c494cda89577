#pragma once
/// Box conventions: definitions of the box whose edges are the axes L >= I >= S of a block.
#include <array>
#include <string>

#include "massprops/mass_properties.hpp"
#include "massprops/principal_frame.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// Box on which the axes are measured. Shape classes depend on it, so it is reported with them.
enum class BoxConvention {
  kSmallest,  ///< smallest volume; the default
  kInertia,   ///< edges along the principal axes of inertia of the solid body
  kFeret,     ///< L is the largest diameter, I the largest width perpendicular to it
  kPca,       ///< edges along the principal components of the hull's vertices
};

inline constexpr std::array kBoxConventions = {BoxConvention::kSmallest, BoxConvention::kInertia,
                                               BoxConvention::kFeret, BoxConvention::kPca};

/// Returns the name of a convention: "smallest", "inertia", "feret" or "pca".
std::string name_of(BoxConvention convention);
/// Parses the name of a convention.
/// @throws InputError  if the name is unknown; the message lists the known names
BoxConvention parse_box_convention(const std::string& name);

/// Computes the box of the rounded body according to a convention.
/// @param frame  principal frame of the body; only used for `kInertia`
/// @throws GeometryError  if the body has no vertices
OrientedBox box_by_convention(const SpheroPolyhedron& body, const PrincipalFrame& frame,
                              BoxConvention convention);

}  // namespace clast
