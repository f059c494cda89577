#pragma once
/// Chunked storage of large HDF5 datasets: chunks along the first dimension, shuffled, compressed
/// and with checksums.
#include <cstddef>
#include <vector>

#include "core/files/detail/hdf5_types.hpp"

namespace clast::hdf5 {

/// Adds chunks and filters to the creation properties of a dataset.
/// @param extent  number of elements by dimension, none 0
/// @param row_bytes  size of one index of the first dimension
void set_chunked_compression(const ScopedId& properties, const std::vector<hsize_t>& extent,
                             std::size_t row_bytes);

/// True if a chunk is missing or stored without filter. clast writes no such chunk, and HDF5 would
/// read beyond its bytes.
/// @param extent  of the dataset, none 0
bool has_damaged_chunks(const ScopedId& dataset, const std::vector<hsize_t>& extent);

}  // namespace clast::hdf5
