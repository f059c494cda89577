#pragma once
/// Things that belong together, found pair by pair.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast {

/// Sets of numbers 0..n-1 that are joined pair by pair; the smallest of a set stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t find(std::uint32_t item);
  void join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace clast
