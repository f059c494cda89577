#pragma once
/// Binary arrays inside a page.
#include <bit>
#include <span>
#include <string>

#include "core/files/png.hpp"

namespace clast::report_detail {

static_assert(std::endian::native == std::endian::little, "browsers read little-endian arrays");

/// Encodes an array as base64 text for scripts of a page.
template <class T>
std::string encode_packed_array(std::span<const T> values) {
  return encode_base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace clast::report_detail
