#pragma once
/// What the machine has.
#include <optional>

namespace clast {

/// Memory that programs can still take without swapping, bytes; none where the system doesn't say.
std::optional<double> available_memory();

}  // namespace clast
