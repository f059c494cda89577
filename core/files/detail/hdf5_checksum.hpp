#pragma once
/// Checksums of what an HDF5 file holds. Every group and dataset has an attribute `checksum`, the
/// exclusive or of one number for each other attribute and, of a dataset, one for its values, so
/// that setting one attribute costs one number. HDF5 itself checks its own structures and, by
/// Fletcher32, compressed chunks, but neither values stored uncompressed, nor texts outside the
/// headers, nor the index of chunks, where a chunk can get lost and be read as zeros.
#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>

namespace clast::hdf5 {

inline constexpr const char* kChecksumAttribute = "checksum";

/// Of an attribute, as it lies in the file: the first 64 bits of the SHA-256 of name, zero, bytes.
std::uint64_t attribute_checksum(const std::string& name, const void* bytes, std::size_t size);

/// Of the values of a dataset, as they lie in the file: by their CRC-32, which finds every change
/// of up to 32 bits in a row, and their number.
std::uint64_t values_checksum(const void* bytes, std::size_t size, std::uint64_t count);

/// Of one attribute of an object, as stored; none when it can't be read.
std::optional<std::uint64_t> attribute_checksum(hid_t object, const std::string& name);

/// Of all attributes of an object but its checksum; none when one can't be read.
std::optional<std::uint64_t> attributes_checksum(hid_t object);

/// The checksum that an object has; none when it has none.
std::optional<std::uint64_t> stored_checksum(hid_t object);

/// Changes the checksum of an object, 0 when it has none yet.
/// @return false when it can't be written
bool update_checksum(hid_t object, std::uint64_t change);

}  // namespace clast::hdf5
