#pragma once
/// Seeds of named random sequences.
#include <cstdint>
#include <string_view>

namespace clast::study_detail {

/// Derives the seed of a named random sequence from a common seed. Sequences of different names are
/// independent.
std::uint64_t derive_seed(std::uint64_t seed, std::string_view name);

}  // namespace clast::study_detail
