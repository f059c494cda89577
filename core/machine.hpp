#pragma once
/// Properties of the machine.
#include <optional>

namespace clast {

/// Returns the memory available without swapping, bytes; empty if unknown.
std::optional<double> available_memory();

}  // namespace clast
