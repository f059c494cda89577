#pragma once
/// Program version, recorded in every output.
namespace clast {

/// Returns "major.minor.patch", from the top-level CMakeLists.txt.
const char* version();

}  // namespace clast
