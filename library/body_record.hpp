#pragma once
/// A sphero-polyhedron as a group of an HDF5 file: `core` of a block in docs/formats.md.
#include <string>

#include "core/files/hdf5_file.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

void write_body(Hdf5Group group, const SpheroPolyhedron& body);

/// @param where  what the message begins with: "blocks.h5: block B017"
/// @throws InputError  something is missing, or can't be
SpheroPolyhedron read_body(const Hdf5Group& group, const std::string& where);

}  // namespace clast
