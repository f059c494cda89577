#include "core/files/detail/hdf5_checksum.hpp"

#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>

#include "core/files/detail/hdf5_types.hpp"
#include "core/files/digest.hpp"

namespace clast::hdf5 {

static_assert(std::endian::native == std::endian::little,
              "values lie in files as they do in memory");

std::uint64_t attribute_checksum(const std::string& name, const void* bytes, std::size_t size) {
  std::string text = name;
  text += '\0';
  text.append(static_cast<const char*>(bytes), size);
  return std::stoull(sha256(text).substr(0, 16), nullptr, 16);
}

std::uint64_t values_checksum(const void* bytes, std::size_t size, std::uint64_t count) {
  const std::uint64_t crc = ::crc32_z(0, static_cast<const Bytef*>(bytes), size);
  const std::array<std::uint64_t, 2> both = {crc, count};
  return attribute_checksum("", both.data(), sizeof both);  // no attribute has an empty name
}

std::optional<std::uint64_t> attribute_checksum(hid_t object, const std::string& name) {
  const ScopedId attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) return std::nullopt;
  const ScopedId type(H5Aget_type(attribute), H5Tclose);
  const ScopedId space(H5Aget_space(attribute), H5Sclose);
  if (!type.valid() || !space.valid() || H5Tis_variable_str(type) != 0) return std::nullopt;
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (count < 0) return std::nullopt;
  std::string bytes(H5Tget_size(type) * static_cast<std::size_t>(count), '\0');
  if (H5Aread(attribute, type, bytes.data()) < 0) return std::nullopt;
  return attribute_checksum(name, bytes.data(), bytes.size());
}

std::optional<std::uint64_t> attributes_checksum(hid_t object) {
  std::uint64_t sum = 0;
  hsize_t position = 0;
  const herr_t status = H5Aiterate2(
      object, H5_INDEX_NAME, H5_ITER_NATIVE, &position,
      [](hid_t holder, const char* name, const H5A_info_t*, void* out) -> herr_t {
        if (std::strcmp(name, kChecksumAttribute) == 0) return 0;
        const std::optional<std::uint64_t> one = attribute_checksum(holder, name);
        if (!one) return -1;
        *static_cast<std::uint64_t*>(out) ^= *one;
        return 0;
      },
      &sum);
  return status < 0 ? std::nullopt : std::optional<std::uint64_t>(sum);
}

std::optional<std::uint64_t> stored_checksum(hid_t object) {
  const ScopedId attribute(H5Aopen(object, kChecksumAttribute, H5P_DEFAULT), H5Aclose);
  std::uint64_t sum = 0;
  if (!attribute.valid() || H5Aread(attribute, H5T_NATIVE_UINT64, &sum) < 0) return std::nullopt;
  return sum;
}

bool update_checksum(hid_t object, std::uint64_t change) {
  const bool there = H5Aexists(object, kChecksumAttribute) > 0;
  const std::optional<std::uint64_t> before = there ? stored_checksum(object) : 0;
  if (!before) return false;
  const std::uint64_t sum = *before ^ change;
  if (there) {
    const ScopedId attribute(H5Aopen(object, kChecksumAttribute, H5P_DEFAULT), H5Aclose);
    return attribute.valid() && H5Awrite(attribute, H5T_NATIVE_UINT64, &sum) >= 0;
  }
  const ScopedId space(H5Screate(H5S_SCALAR), H5Sclose);
  const ScopedId attribute(
      H5Acreate2(object, kChecksumAttribute, H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  return attribute.valid() && H5Awrite(attribute, H5T_NATIVE_UINT64, &sum) >= 0;
}

}  // namespace clast::hdf5
