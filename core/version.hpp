#pragma once
/// The program version that every output names.
namespace clast {

/// Returns "major.minor.patch", from the top-level CMakeLists.txt.
const char* version();

}  // namespace clast
