#pragma once
/// Reading of named vertex properties of PLY files, such as labels of points.
#include <filesystem>
#include <string>
#include <vector>

namespace clast {

/// Reads properties of the vertices of a PLY file: a column for each name, in the order of `names`.
/// Other properties and elements are ignored.
/// @param names  properties of any number type, such as "x" or "block"; X, Y and Z count as x, y, z
/// @throws InputError  if the file is missing, corrupt or truncated, or has no such property
std::vector<std::vector<double>> read_ply_vertex_properties(const std::filesystem::path& path,
                                                            const std::vector<std::string>& names);

}  // namespace clast
