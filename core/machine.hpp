#pragma once
/// Properties of the machine.
#include <optional>

namespace clast {

/// Returns the memory available without swapping, bytes; empty if unknown.
std::optional<double> available_memory();

/// Returns the processor time that the calling thread has used, s. Unlike elapsed time, it does not
/// depend on the load of the machine.
double thread_processor_time();

}  // namespace clast
