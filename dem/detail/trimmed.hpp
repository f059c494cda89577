#pragma once
/// Lists that are made anew now and then take little more memory than they need.
#include <vector>

namespace clast::dem_detail {

/// Gives back room for more than half as many elements again.
template <class... T>
void trim(std::vector<T>&... lists) {
  const auto trim_one = [](auto& list) {
    if (list.capacity() > list.size() + list.size() / 2) list.shrink_to_fit();
  };
  (trim_one(lists), ...);
}

}  // namespace clast::dem_detail
