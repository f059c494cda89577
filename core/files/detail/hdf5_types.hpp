#pragma once
/// Mapping of C++ values to HDF5: owned identifiers, element types, fixed-width text.
#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace clast::hdf5 {

/// Disables HDF5's own error output in this thread.
void silence_hdf5_errors();

/// Owner of an HDF5 identifier, which it closes on destruction.
class ScopedId {
 public:
  using CloseFunction = herr_t (*)(hid_t);
  ScopedId(hid_t id, CloseFunction close) : id_(id), close_(close) {}
  ScopedId(ScopedId&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  ~ScopedId() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  CloseFunction close_;
};

/// Returns HDF5's innermost error message of the last call in brackets, or an empty text.
std::string last_hdf5_error();

/// Makes an HDF5 type for zero-padded text of fixed width. Variable-length text would be stored in
/// a heap without checksums, and a damaged heap crashes HDF5.
ScopedId fixed_string_type(std::size_t width);

/// Returns the HDF5 type of numbers T, native in memory or little-endian in the file.
template <class T>
ScopedId hdf5_number_type(bool file_type) {
  const auto copy = [](hid_t type) { return ScopedId(H5Tcopy(type), H5Tclose); };
  if constexpr (std::is_same_v<T, double>) {
    return copy(file_type ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE);
  } else if constexpr (std::is_same_v<T, float>) {
    return copy(file_type ? H5T_IEEE_F32LE : H5T_NATIVE_FLOAT);
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return copy(file_type ? H5T_STD_I64LE : H5T_NATIVE_INT64);
  } else if constexpr (std::is_same_v<T, std::int32_t>) {
    return copy(file_type ? H5T_STD_I32LE : H5T_NATIVE_INT32);
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return copy(file_type ? H5T_STD_U32LE : H5T_NATIVE_UINT32);
  } else if constexpr (std::is_same_v<T, std::uint16_t>) {
    return copy(file_type ? H5T_STD_U16LE : H5T_NATIVE_UINT16);
  } else {
    static_assert(std::is_same_v<T, std::uint8_t>);
    return copy(file_type ? H5T_STD_U8LE : H5T_NATIVE_UINT8);
  }
}

template <class T>
const char* type_name() {
  if constexpr (std::is_same_v<T, std::string>) return "text";
  if constexpr (std::is_same_v<T, double>) return "64-bit numbers";
  if constexpr (std::is_same_v<T, float>) return "32-bit numbers";
  if constexpr (std::is_same_v<T, std::int64_t>) return "64-bit integers";
  if constexpr (std::is_same_v<T, std::int32_t>) return "32-bit integers";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "unsigned 32-bit integers";
  if constexpr (std::is_same_v<T, std::uint16_t>) return "unsigned 16-bit integers";
  return "unsigned 8-bit integers";
}

/// True if all values of the stored type can be represented as T.
template <class T>
bool is_lossless_conversion(hid_t stored) {
  const H5T_class_t kind = H5Tget_class(stored);
  if constexpr (std::is_same_v<T, std::string>) {
    return kind == H5T_STRING && H5Tis_variable_str(stored) == 0;
  } else if constexpr (std::is_floating_point_v<T>) {
    return kind == H5T_FLOAT && H5Tget_size(stored) <= sizeof(T);
  } else {
    return kind == H5T_INTEGER && H5Tget_size(stored) <= sizeof(T) &&
           (H5Tget_sign(stored) == H5T_SGN_2) == std::is_signed_v<T>;
  }
}

/// Concatenates texts, each padded or truncated to `width` bytes. No UTF-8 character is split.
std::string padded_strings(std::span<const std::string> texts, std::size_t width);
std::string unpadded_string(const std::string& bytes, std::size_t begin, std::size_t width);
/// Returns the size of the longest text in bytes, at least 1.
std::size_t longest_size(std::span<const std::string> texts);

/// Values in the memory layout from which HDF5 writes them, with their HDF5 types.
template <class T>
struct Hdf5WriteBuffer {
  explicit Hdf5WriteBuffer(std::span<const T> all)
      : element_size(sizeof(T)),
        file_type(hdf5_number_type<T>(true)),
        memory_type(hdf5_number_type<T>(false)),
        values(all) {}
  Hdf5WriteBuffer(std::span<const T> all, std::size_t) : Hdf5WriteBuffer(all) {}
  const void* data() const { return values.data(); }

  std::size_t element_size;  ///< size of one value in the file, bytes
  ScopedId file_type;
  ScopedId memory_type;
  std::span<const T> values;
};

template <>
struct Hdf5WriteBuffer<std::string> {
  Hdf5WriteBuffer(std::span<const std::string> all, std::size_t width)
      : element_size(width),
        file_type(fixed_string_type(width)),
        memory_type(fixed_string_type(width)),
        bytes(padded_strings(all, width)) {}
  explicit Hdf5WriteBuffer(std::span<const std::string> all)
      : Hdf5WriteBuffer(all, longest_size(all)) {}
  const void* data() const { return bytes.data(); }

  std::size_t element_size;
  ScopedId file_type;
  ScopedId memory_type;
  std::string bytes;
};

}  // namespace clast::hdf5
