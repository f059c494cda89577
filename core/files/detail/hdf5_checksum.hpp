#pragma once
/// Checksums of HDF5 objects. Each group and dataset has an attribute `checksum`. It is the
/// exclusive or of one number for each other attribute and, for datasets, one number for the
/// values. HDF5 itself protects its own structures and compressed chunks. It does not protect
/// uncompressed values, text outside headers, and the chunk index; a lost chunk is read as zeros.
#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>

namespace clast::hdf5 {

inline constexpr const char* kChecksumAttribute = "checksum";

/// Returns the checksum of an attribute: the first 64 bits of the SHA-256 of its name, a zero byte
/// and its stored bytes.
std::uint64_t attribute_checksum(const std::string& name, const void* bytes, std::size_t size);

/// Returns the checksum of stored dataset values, from their CRC-32 and their number.
std::uint64_t values_checksum(const void* bytes, std::size_t size, std::uint64_t count);

/// Returns the checksum of an attribute of an object; empty if it cannot be read.
std::optional<std::uint64_t> attribute_checksum(hid_t object, const std::string& name);

/// Returns the checksum of all attributes except the checksum itself; empty if one is unreadable.
std::optional<std::uint64_t> attributes_checksum(hid_t object);

/// Returns the stored checksum of a group or dataset; empty if there is none.
std::optional<std::uint64_t> stored_checksum(hid_t object);

/// Combines a change into the stored checksum by exclusive or. A missing checksum counts as 0.
/// @return false if the checksum cannot be written
bool update_checksum(hid_t object, std::uint64_t change);

}  // namespace clast::hdf5
