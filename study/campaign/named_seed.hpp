#pragma once
/// Seeds of sequences that do not disturb each other.
#include <cstdint>
#include <string_view>

namespace clast::study_detail {

/// The seed of a sequence of its own for what is called `name`: it stays the same whatever else
/// draws from `seed`, in whatever order.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace clast::study_detail
