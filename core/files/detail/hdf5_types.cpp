#include "core/files/detail/hdf5_types.hpp"

#include <algorithm>

namespace clast::hdf5 {

void silence_hdf5_errors() {
  thread_local const bool done = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  static_cast<void>(done);
}

std::string last_hdf5_error() {
  std::string found;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned depth, const H5E_error2_t* error, void* out) -> herr_t {
        if (depth == 0 && error->desc) *static_cast<std::string*>(out) = error->desc;
        return 0;
      },
      &found);
  return found.empty() ? "" : " (HDF5: " + found + ")";
}

ScopedId fixed_string_type(std::size_t width) {
  ScopedId type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(1, width));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

std::string padded_strings(std::span<const std::string> texts, std::size_t width) {
  std::string result;
  result.reserve(texts.size() * width);
  for (const std::string& text : texts) {
    std::size_t length = std::min(text.size(), width);
    while (length < text.size() && length > 0 && (text[length] & 0xC0) == 0x80) --length;
    result.append(text, 0, length).append(width - length, '\0');
  }
  return result;
}

std::string unpadded_string(const std::string& bytes, std::size_t begin, std::size_t width) {
  const std::string text = bytes.substr(begin, width);
  return text.substr(0, text.find_last_not_of('\0') + 1);
}

std::size_t longest_size(std::span<const std::string> texts) {
  std::size_t width = 1;
  for (const std::string& text : texts) width = std::max(width, text.size());
  return width;
}

}  // namespace clast::hdf5
