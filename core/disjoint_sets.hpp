#pragma once
/// Disjoint sets (union-find).
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast {

/// Disjoint sets of the numbers 0 to n - 1. A set is represented by its smallest number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t find(std::uint32_t item);
  void join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace clast
