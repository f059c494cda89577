#pragma once
/// Programs run as processes, with what they printed.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/text_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

struct ProgramRun {
  int exit_code = -1;  ///< 128 + signal when it was killed
  std::string out;
  std::string err;
};

/// Runs `words[0]` (a path, or a name that is looked up in PATH) with the other words in `folder`;
/// output goes through files, so that any amount fits.
inline ProgramRun run_program(std::vector<std::string> words,
                              const std::filesystem::path& folder = ".") {
  const ScratchFolder captured;
  const std::string out = captured / "out";
  const std::string err = captured / "err";
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = ::fork();
  if (child == 0) {
    const bool ready = ::chdir(folder.c_str()) == 0 && std::freopen("/dev/null", "r", stdin) &&
                       std::freopen(out.c_str(), "w", stdout) &&
                       std::freopen(err.c_str(), "w", stderr);
    if (ready) ::execvp(argv[0], argv.data());
    ::_exit(126);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, read_text_file(out), read_text_file(err)};
}

inline ProgramRun run_clast(const std::vector<std::string>& arguments,
                            const std::filesystem::path& folder = ".") {
  std::vector<std::string> words = {CLAST_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(std::move(words), folder);
}

}  // namespace clast
