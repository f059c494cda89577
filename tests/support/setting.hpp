#pragma once
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

namespace clast {

/// The whole number in a variable of the environment, by which a test is made larger.
inline std::optional<std::uint64_t> setting(const char* name) {
  const char* text = std::getenv(name);
  return text ? std::optional<std::uint64_t>(std::stoull(text)) : std::nullopt;
}

}  // namespace clast
