#pragma once
/// The axis of a file that points up, and turning y up to z up and back.
#include <filesystem>
#include <string>

#include "core/types.hpp"

namespace clast {

/// "y" or "z". Of "auto" it is y for .glb and .gltf files, which glTF 2.0 (3.4) has y up, and z for
/// all others.
/// @param up  "auto", "y" or "z"
/// @throws InputError  anything else
std::string resolve_up_axis(const std::string& up, const std::filesystem::path& file);

/// (x, y, z) of a frame whose y points up in one whose z does: a quarter turn about x.
inline Vec3 y_up_to_z_up(const Vec3& p) { return {p.x(), -p.z(), p.y()}; }
/// The inverse.
inline Vec3 z_up_to_y_up(const Vec3& p) { return {p.x(), p.z(), -p.y()}; }

}  // namespace clast
