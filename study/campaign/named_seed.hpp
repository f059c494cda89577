#pragma once
/// Independent seeds for named random sequences.
#include <cstdint>
#include <string_view>

namespace clast::study_detail {

/// Derives the seed of the random sequence `name`, which is independent of others from `seed`.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace clast::study_detail
