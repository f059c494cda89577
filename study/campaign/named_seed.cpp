#include "study/campaign/named_seed.hpp"

#include <string>

#include "core/files/digest.hpp"

namespace clast::study_detail {

std::uint64_t derive_seed(std::uint64_t seed, std::string_view name) {
  const std::string digest = sha256(std::to_string(seed) + "/" + std::string(name));
  return std::stoull(digest.substr(0, 16), nullptr, 16);
}

}  // namespace clast::study_detail
