#include "core/files/detail/hdf5_chunks.hpp"

#include <algorithm>

namespace clast::hdf5 {
namespace {

constexpr std::size_t kChunk = 32768;  ///< bytes of a chunk
constexpr unsigned kGzipLevel = 4;

}  // namespace

void set_chunked_compression(const ScopedId& properties, const std::vector<hsize_t>& extent,
                             std::size_t row_bytes) {
  std::vector<hsize_t> chunk = extent;
  chunk[0] = std::clamp<hsize_t>(kChunk / row_bytes, 1, extent[0]);
  H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties);
  H5Pset_deflate(properties, kGzipLevel);
  H5Pset_fletcher32(properties);
}

bool has_damaged_chunks(const ScopedId& dataset, const std::vector<hsize_t>& extent) {
  const ScopedId properties(H5Dget_create_plist(dataset), H5Pclose);
  if (H5Pget_layout(properties) != H5D_CHUNKED) return false;
  std::vector<hsize_t> chunk(extent.size(), 0), place(extent.size(), 0);
  const auto rank = static_cast<int>(extent.size());
  if (rank == 0 || H5Pget_chunk(properties, rank, chunk.data()) != rank || chunk[0] == 0) {
    return true;
  }
  for (; place[0] < extent[0]; place[0] += chunk[0]) {
    unsigned left_out = 0;
    haddr_t address = 0;
    hsize_t size = 0;
    if (H5Dget_chunk_info_by_coord(dataset, place.data(), &left_out, &address, &size) < 0 ||
        address == HADDR_UNDEF || left_out != 0) {
      return true;
    }
  }
  return false;
}

}  // namespace clast::hdf5
