#pragma once
/// Checksums of HDF5 objects. Each group and dataset has an attribute `checksum`: the exclusive or
/// of one number per other attribute and, for datasets, one for the values, so that setting an
/// attribute changes one number. HDF5 itself protects its own structures and, by Fletcher32,
/// compressed chunks, but not uncompressed values, text outside headers, or the chunk index, where
/// a lost chunk would be read as zeros.
#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>

namespace clast::hdf5 {

inline constexpr const char* kChecksumAttribute = "checksum";

/// Returns the checksum of an attribute: the first 64 bits of the SHA-256 of name, zero byte and
/// stored bytes.
std::uint64_t attribute_checksum(const std::string& name, const void* bytes, std::size_t size);

/// Returns the checksum of stored dataset values: from their CRC-32, which detects every error
/// burst up to 32 bits, and their number.
std::uint64_t values_checksum(const void* bytes, std::size_t size, std::uint64_t count);

/// Returns the checksum of an attribute of an object; empty if it cannot be read.
std::optional<std::uint64_t> attribute_checksum(hid_t object, const std::string& name);

/// Returns the combined checksum of all attributes except the checksum itself; empty if one cannot
/// be read.
std::optional<std::uint64_t> attributes_checksum(hid_t object);

/// Returns the stored checksum; empty if there is none.
std::optional<std::uint64_t> stored_checksum(hid_t object);

/// Combines a change into the stored checksum, which is 0 if missing.
/// @return false if it cannot be written
bool update_checksum(hid_t object, std::uint64_t change);

}  // namespace clast::hdf5
