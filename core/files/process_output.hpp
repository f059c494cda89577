#pragma once
/// Child processes whose output is read.
#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/files/unnamed_file.hpp"

namespace clast {

/// Program without input whose standard output is read. The program and its children are killed
/// when this object is destroyed and when this program ends.
class ProcessOutput {
 public:
  /// Destination of the standard output.
  enum class Target {
    kPipe,  ///< a pipe, which is read while the program runs
    kFile   ///< an `UnnamedFile`, which is read after its end; the program may open it anew and
            ///< move in it (/dev/stdout)
  };

  /// Starts the program.
  /// @param command  path of the program and its arguments
  /// @param silence_limit  longest time without output, s
  /// @throws InputError  if it cannot be started
  ProcessOutput(const std::vector<std::string>& command, Target target, double silence_limit);
  ~ProcessOutput();
  ProcessOutput(const ProcessOutput&) = delete;
  ProcessOutput& operator=(const ProcessOutput&) = delete;

  /// Reads output, and waits for it.
  /// @return  number of bytes read, 0 only at the end of the output
  /// @throws InputError  if the program gave no output for `silence_limit`; it is killed
  std::size_t read(char* bytes, std::size_t count);
  /// Waits until the program has ended. Output that is not read is dropped.
  /// @return  its exit code, 128 + signal if it was killed
  /// @throws InputError  as `read`
  int wait();
  /// Returns the last line that the program wrote to standard error, or "" if there is none.
  std::string last_words() const;

 private:
  std::size_t read_pipe(char* bytes, std::size_t count);
  void await_end();
  void kill_group();
  [[noreturn]] void refuse_silence();

  double silence_limit_;
  UnnamedFile errors_;
  std::optional<UnnamedFile> file_;
  int pipe_ = -1;
  pid_t child_ = -1;
  bool running_ = false;
  int exit_code_ = -1;
};

}  // namespace clast
