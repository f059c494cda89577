#pragma once
/// Chunked storage of large HDF5 datasets. The chunks divide the first dimension; they are
/// shuffled, compressed and have checksums.
#include <cstddef>
#include <vector>

#include "core/files/detail/hdf5_types.hpp"

namespace clast::hdf5 {

/// Adds chunks and filters to the creation properties of a dataset.
/// @param extent  number of elements in each dimension, none 0
/// @param row_bytes  size of the values at one index of the first dimension, bytes
void set_chunked_compression(const ScopedId& properties, const std::vector<hsize_t>& extent,
                             std::size_t row_bytes);

/// True if a chunk is missing or stored without filter. clast writes no such chunks; HDF5 would
/// read beyond their bytes.
/// @param extent  number of elements in each dimension, none 0
bool has_damaged_chunks(const ScopedId& dataset, const std::vector<hsize_t>& extent);

}  // namespace clast::hdf5
