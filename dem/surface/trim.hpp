#pragma once
/// Limiting the spare capacity of lists.
#include <vector>

namespace clast::dem_detail {

/// Frees the spare capacity of lists in which it exceeds half the size.
template <class... T>
void shrink_capacity(std::vector<T>&... lists) {
  const auto trim_one = [](auto& list) {
    if (list.capacity() > list.size() + list.size() / 2) list.shrink_to_fit();
  };
  (trim_one(lists), ...);
}

}  // namespace clast::dem_detail
