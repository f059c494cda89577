#pragma once
/// Serialisation of values to bytes and back. The format is private to one build of the program; it
/// serves for journals, checkpoints and messages between processes.
///
/// A class lists its members once for writing and reading, in a member or free function:
///
///     template <class Bytes>
///     void serialize(Bytes& bytes) { bytes(first_, second_); }
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace clast {

class ByteWriter {
 public:
  static constexpr bool kReads = false;

  /// Constructs a writer to a stream.
  /// @param to  stream to write to; must outlive the writer
  explicit ByteWriter(std::ostream& to) : to_(to) {}

  template <class... Values>
  void operator()(Values&... values) {
    (serialize(*this, values), ...);
  }
  void archive_bytes(const void* data, std::size_t size) {
    to_.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  /// Writes the number of the elements that follow.
  std::size_t archive_size(std::size_t size) {
    std::uint64_t stored = size;
    archive_bytes(&stored, sizeof stored);
    return size;
  }

 private:
  std::ostream& to_;
};

class ByteReader {
 public:
  static constexpr bool kReads = true;

  /// Constructs a reader of bytes.
  /// @param bytes  bytes to read; must outlive the reader
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  /// Reads values in the order in which they were written.
  /// @throws InputError  if the bytes end too early
  template <class... Values>
  void operator()(Values&... values) {
    (serialize(*this, values), ...);
  }
  void archive_bytes(void* data, std::size_t size) {
    if (size > bytes_.size()) throw InputError("a record is too short");
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  std::size_t archive_size(std::size_t) {
    std::uint64_t stored = 0;
    archive_bytes(&stored, sizeof stored);
    // An element takes at least one byte.
    if (stored > bytes_.size()) throw InputError("a record has an impossible size");
    return stored;
  }
  std::size_t remaining_bytes() const { return bytes_.size(); }
  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;  ///< bytes not yet read
};

template <class Bytes, class T>
requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void serialize(Bytes& bytes, T& value) {
  if constexpr (std::is_same_v<T, bool>) {  // not every byte is one
    std::uint8_t stored = value ? 1 : 0;
    bytes(stored);
    value = stored != 0;
  } else {
    bytes.archive_bytes(&value, sizeof value);
  }
}

template <class Bytes, class T>
requires requires(Bytes& bytes, T& value) { value.serialize(bytes); }
void serialize(Bytes& bytes, T& value) { value.serialize(bytes); }

template <class Bytes, int kRows, int kColumns>
requires(kRows > 0 && kColumns > 0) void serialize(Bytes& bytes,
                                                   Eigen::Matrix<double, kRows, kColumns>& matrix) {
  bytes.archive_bytes(matrix.data(), sizeof(double) * kRows * kColumns);
}

template <class Bytes>
void serialize(Bytes& bytes, Quat& rotation) {
  bytes(rotation.coeffs());
}

template <class Bytes>
void serialize(Bytes& bytes, Pose& pose) {
  bytes(pose.translation, pose.rotation);
}

template <class Bytes>
void serialize(Bytes& bytes, std::string& text) {
  text.resize(bytes.archive_size(text.size()));
  bytes.archive_bytes(text.data(), text.size());
}

template <class Bytes, class T>
void serialize(Bytes& bytes, std::vector<T>& list) {
  list.resize(bytes.archive_size(list.size()));
  if constexpr (std::is_arithmetic_v<T>) {
    bytes.archive_bytes(list.data(), sizeof(T) * list.size());
  } else {
    for (T& element : list) bytes(element);
  }
}

template <class Bytes, class First, class Second>
void serialize(Bytes& bytes, std::pair<First, Second>& pair) {
  bytes(pair.first, pair.second);
}

template <class Bytes, class T, std::size_t kCount>
void serialize(Bytes& bytes, std::array<T, kCount>& array) {
  for (T& element : array) bytes(element);
}

template <class Bytes, class T>
void serialize(Bytes& bytes, std::optional<T>& value) {
  bool has = value.has_value();
  bytes(has);
  if constexpr (Bytes::kReads) {
    value.reset();
    if (has) value.emplace();
  }
  if (has) bytes(*value);
}

template <class Bytes, class T>
void serialize(Bytes& bytes, std::unique_ptr<T>& value) {
  bool has = value != nullptr;
  bytes(has);
  if constexpr (Bytes::kReads) value = has ? std::make_unique<T>() : nullptr;
  if (has) bytes(*value);
}

template <class Bytes, class Key, class T>
void serialize(Bytes& bytes, std::unordered_map<Key, T>& map) {
  std::vector<std::pair<Key, T>> entries(map.begin(), map.end());
  std::sort(entries.begin(), entries.end());  // equal maps are equal bytes
  bytes(entries);
  if constexpr (Bytes::kReads) map = {entries.begin(), entries.end()};
}

template <class T>
std::string serialized_bytes(T& value) {
  std::ostringstream text;
  ByteWriter writer(text);
  writer(value);
  return std::move(text).str();
}

}  // namespace clast
