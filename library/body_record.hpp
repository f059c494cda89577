#pragma once
/// Storage of sphero-polyhedra as HDF5 groups (`core` of a block in docs/formats.md).
#include <string>

#include "core/files/hdf5_file.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

void write_body(Hdf5Group group, const SpheroPolyhedron& body);

/// Reads a sphero-polyhedron from a group.
/// @param where  prefix of messages, such as "blocks.h5: block B017"
/// @throws InputError  if a dataset is missing or invalid
SpheroPolyhedron read_body(const Hdf5Group& group, const std::string& where);

}  // namespace clast
