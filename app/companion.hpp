#pragma once
/// The part of the program that is started for one command only.
#include <string>

namespace clast {

/// What `clast reconstruct` says of itself, in the program and in its companion.
inline constexpr const char* kReconstructSummary =
    "Turn scans (meshes, point clouds, photographs) into blocks of a library, repairing "
    "defects";

/// Replaces this process by the companion that has the command `reconstruct`: PCL and OpenCV, which
/// take longer to load than other commands take to run, are linked there alone. It lies beside the
/// program, or in the folder for programs that are not run by hand.
/// @throws InputError  it is not there
[[noreturn]] void run_companion(char** argv);

/// The command by which the companion prints its option tables (`to_json`), for `clast help`.
inline constexpr const char* kDescribeCommand = "describe";

/// What the companion prints when it is run with one argument.
/// @throws InputError  it is not there, or fails
std::string read_companion_output(const std::string& argument);

}  // namespace clast
