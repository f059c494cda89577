#pragma once
/// Up axis of a file, and rotation between y-up and z-up frames.
#include <filesystem>
#include <string>

#include "core/types.hpp"

namespace clast {

/// Resolves "auto" to "y" for .glb and .gltf files (glTF 2.0, section 3.4), otherwise to "z".
/// @param up  "auto", "y" or "z"
/// @throws InputError  if `up` is any other text
std::string resolve_up_axis(const std::string& up, const std::filesystem::path& file);

/// Rotates a point from a y-up to a z-up frame, by a quarter turn about x.
inline Vec3 y_up_to_z_up(const Vec3& p) { return {p.x(), -p.z(), p.y()}; }
/// Rotates a point from a z-up to a y-up frame.
inline Vec3 z_up_to_y_up(const Vec3& p) { return {p.x(), p.z(), -p.y()}; }

}  // namespace clast
