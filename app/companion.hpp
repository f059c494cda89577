#pragma once
/// Companion executable with the command `reconstruct`.
#include <string>

namespace clast {

/// Summary of `clast reconstruct`, shown by both executables.
inline constexpr const char* kReconstructSummary =
    "Turn scans (meshes, point clouds, photographs) into blocks of a library, repairing "
    "defects";

/// Replaces this process by the companion executable. Only the companion links PCL and OpenCV,
/// which load slowly. It is beside the program, or in the folder for internal executables.
/// @throws InputError  if the companion is not installed
[[noreturn]] void run_companion(char** argv);

/// Argument with which the companion executable prints its options as JSON.
inline constexpr const char* kDescribeCommand = "describe";

/// Runs the companion executable with one argument and returns its output.
/// @throws InputError  if the companion is not installed or fails
std::string read_companion_output(const std::string& argument);

}  // namespace clast
