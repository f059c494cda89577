#pragma once
/// Disjoint sets (union-find).
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast {

/// Disjoint sets of the numbers 0..n-1; the smallest number represents a set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t find(std::uint32_t item);
  void join(std::uint32_t a, std::uint32_t b);

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace clast
