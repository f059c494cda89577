#pragma once
/// Programs started as several processes by mpirun.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/run_program.hpp"

namespace clast {

#ifdef CLAST_MPIRUN
/// @param processes  how many
inline ProgramRun mpirun(const std::string& processes, const std::vector<std::string>& arguments,
                         const std::filesystem::path& folder) {
  // As root, and with more processes than cores: what a container on CI needs of Open MPI. Other
  // launchers pass over these.
  for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                           "OMPI_MCA_rmaps_base_oversubscribe"}) {
    ::setenv(name, "1", 1);
  }
  // Under the sanitizers: the plugins of Open MPI leave memory behind when they are unloaded.
  ::setenv("LSAN_OPTIONS", "detect_leaks=0", 1);
  std::vector<std::string> words = {CLAST_MPIRUN, "-n", processes};
  for (const std::string& word : clast_words(arguments)) words.push_back(word);
  return RunningProgram(words, folder).wait();
}
#endif

}  // namespace clast
