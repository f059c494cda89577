#pragma once
/// Companion executable, which contains the command `reconstruct`.
#include <string>

namespace clast {

/// Summary of `clast reconstruct`, shown by both executables.
inline constexpr const char* kReconstructSummary =
    "Turn scans (meshes, point clouds, photographs) into blocks of a library, repairing "
    "defects";

/// Replaces this process by the companion, which alone links PCL and OpenCV because they take long
/// to load. The companion is beside the program or in the folder for internal executables.
/// @throws InputError  if it is not installed
[[noreturn]] void run_companion(char** argv);

/// Companion command that prints its options as JSON (`to_json`), for `clast help`.
inline constexpr const char* kDescribeCommand = "describe";

/// Runs the companion with one argument and returns its output.
/// @throws InputError  if it is not installed or fails
std::string read_companion_output(const std::string& argument);

}  // namespace clast
