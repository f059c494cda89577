#pragma once
/// List of selected indices. It is filled without branches, for speed.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast::dem_detail {

class IndexList {
 public:
  /// Removes all indices and reserves memory.
  /// @param max_count  maximum number of indices until the next call
  void clear(std::uint32_t max_count) {
    if (indices_.size() <= max_count) indices_.resize(max_count + 1);
    count_ = 0;
  }
  void add_if(bool wanted, std::uint32_t index) {
    indices_[count_] = index;
    count_ += wanted ? 1 : 0;
  }

  /// Fills the list with the indices below `end` for which `wanted` is true.
  template <class Wanted>
  void fill_if(std::uint32_t end, const Wanted& wanted) {
    clear(end);
    std::uint32_t* const to = indices_.data();
    std::size_t count = 0;
    for (std::uint32_t index = 0; index < end; ++index) {
      to[count] = index;
      count += wanted(index) ? 1 : 0;
    }
    count_ = count;
  }

  std::size_t size() const { return count_; }
  std::uint32_t operator[](std::size_t i) const { return indices_[i]; }
  const std::uint32_t* begin() const { return indices_.data(); }
  const std::uint32_t* end() const { return indices_.data() + count_; }

  /// Selected indices, followed by one spare element.
 private:
  std::vector<std::uint32_t> indices_;
  std::size_t count_ = 0;
};

}  // namespace clast::dem_detail
