#pragma once
/// Programs run as processes, clast first of all, with what they printed.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

struct ProgramRun {
  int exit_code = -1;  ///< 128 + signal when it was killed
  std::string out;
  std::string err;
};

/// A program at work; output goes through files, so that any amount fits.
class RunningProgram {
 public:
  /// @param words  the program, a path or a name that is looked up in PATH, and its arguments
  RunningProgram(std::vector<std::string> words, const std::filesystem::path& folder) {
    const std::string out = captured_ / "out";
    const std::string err = captured_ / "err";
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    child_ = ::fork();
    if (child_ == 0) {
      const bool ready = ::chdir(folder.c_str()) == 0 && std::freopen("/dev/null", "r", stdin) &&
                         std::freopen(out.c_str(), "w", stdout) &&
                         std::freopen(err.c_str(), "w", stderr);
      if (ready) ::execvp(argv[0], argv.data());
      ::_exit(126);
    }
  }

  void signal(int number) const { ::kill(child_, number); }
  /// True once it has a handler of its own for the signal.
  bool handles(int number) const {
    std::ifstream status("/proc/" + std::to_string(child_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigCgt:")) continue;
      return (std::stoull(line.substr(7), nullptr, 16) >> (number - 1) & 1u) != 0;
    }
    return false;
  }
  /// Waits until it handles the signal, or has ended.
  void wait_for_handler(int number) {
    while (!ended() && !handles(number)) ::usleep(1000);
  }
  /// What it has printed to stderr so far.
  std::string err_so_far() const {
    const std::filesystem::path file = captured_ / "err";
    return std::filesystem::exists(file) ? read_text_file(file) : "";
  }
  bool ended() {
    if (!ended_) ended_ = ::waitpid(child_, &status_, WNOHANG) == child_;
    return ended_;
  }
  ProgramRun wait() {
    if (!ended_) ::waitpid(child_, &status_, 0);
    ended_ = true;
    const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    return {code, read_text_file(captured_ / "out"), read_text_file(captured_ / "err")};
  }

 private:
  ScratchFolder captured_;
  pid_t child_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

inline std::vector<std::string> clast_words(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {CLAST_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

/// Runs `clast` with the arguments in `folder`.
inline ProgramRun run_clast(const std::vector<std::string>& arguments,
                            const std::filesystem::path& folder = ".") {
  return RunningProgram(clast_words(arguments), folder).wait();
}

}  // namespace clast
