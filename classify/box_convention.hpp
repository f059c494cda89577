#pragma once
/// Which box the axes L >= I >= S of a block are the sides of.
#include <array>
#include <string>

#include "massprops/mass_properties.hpp"
#include "massprops/principal_frame.hpp"
#include "shapes/oriented_box.hpp"

namespace clast {

/// Shape classes depend on it: state it beside every class.
enum class BoxConvention {
  kSmallest,  ///< smallest volume; the default everywhere
  kInertia,   ///< along the principal axes of inertia of the solid body
  kFeret,     ///< longest distance, then longest width across it: callipers and tape
  kPca,       ///< along the principal components of the hull's corners
};

inline constexpr std::array kBoxConventions = {BoxConvention::kSmallest, BoxConvention::kInertia,
                                               BoxConvention::kFeret, BoxConvention::kPca};

/// "smallest", "inertia", "feret" or "pca".
std::string name_of(BoxConvention convention);
/// @throws InputError  unknown name; the message lists the known ones
BoxConvention parse_box_convention(const std::string& name);

/// The box of the rounded body by the convention.
/// @param frame  principal frame of the body; used by `kInertia` only
/// @throws GeometryError  the body has no vertices
OrientedBox box_by_convention(const SpheroPolyhedron& body, const PrincipalFrame& frame,
                   BoxConvention convention);

}  // namespace clast
