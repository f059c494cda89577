#pragma once
/// How HDF5 stores larger datasets: in chunks along their first dimension, each shuffled,
/// compressed and with a checksum.
#include <cstddef>
#include <vector>

#include "core/files/detail/hdf5_types.hpp"

namespace clast::hdf5 {

/// Adds chunks and their filters to the creation properties of a dataset.
/// @param extent     its numbers of elements by dimension, none 0
/// @param row_bytes  of the elements below the first dimension
void set_chunked_compression(const ScopedId& properties, const std::vector<hsize_t>& extent,
                        std::size_t row_bytes);

/// True when the file names no chunk where one must be, or one that is stored without a filter:
/// none is written so, and HDF5 would take its bytes for a whole chunk and read beyond them.
/// @param extent  of the dataset, none 0
bool has_damaged_chunks(const ScopedId& dataset, const std::vector<hsize_t>& extent);

}  // namespace clast::hdf5
