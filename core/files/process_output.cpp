#include "core/files/process_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "core/error.hpp"
#include "core/files/detail/program_call.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"

namespace clast {

namespace {

constexpr int kPipeBytes = 1 << 20;
constexpr std::chrono::milliseconds kEndPoll{20};
constexpr std::size_t kLastWords = 4096;  // bytes at the end of standard error

}  // namespace

ProcessOutput::ProcessOutput(const std::vector<std::string>& command, Target target,
                             double silence_limit)
    : silence_limit_(silence_limit) {
  const files_detail::ProgramCall call(command, {});
  if (target == Target::kFile) {
    file_.emplace();
    child_ = call.start(file_->descriptor(), errors_.descriptor());
  } else {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) {
      throw InputError(command[0] + " can't be started: " + std::strerror(errno));
    }
    pipe_ = ends[0];
#ifdef F_SETPIPE_SZ
    ::fcntl(pipe_, F_SETPIPE_SZ, kPipeBytes);
#endif
    try {
      child_ = call.start(ends[1], errors_.descriptor());
    } catch (...) {
      ::close(ends[0]);
      ::close(ends[1]);
      throw;
    }
    ::close(ends[1]);
  }
  running_ = true;
}

ProcessOutput::~ProcessOutput() {
  if (running_) kill_group();
  if (pipe_ >= 0) ::close(pipe_);
}

void ProcessOutput::kill_group() {
  ::kill(-child_, SIGKILL);
  exit_code_ = files_detail::wait_for_exit(child_);
  running_ = false;
}

void ProcessOutput::refuse_silence() {
  kill_group();
  throw InputError("gave no output for " + format_significant(silence_limit_, 3) +
                   " s and was stopped");
}

std::size_t ProcessOutput::read_pipe(char* bytes, std::size_t count) {
  const int limit = static_cast<int>(std::ceil(1000.0 * silence_limit_));
  for (;;) {
    pollfd source{.fd = pipe_, .events = POLLIN, .revents = 0};
    const int ready = ::poll(&source, 1, limit);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) refuse_silence();
    const ssize_t got = ::read(pipe_, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    return got > 0 ? static_cast<std::size_t>(got) : 0;
  }
}

/// Waits for the end of the program, as long as its file grows.
void ProcessOutput::await_end() {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  off_t size = 0;
  while (running_) {
    int status = 0;
    const pid_t ended = ::waitpid(child_, &status, WNOHANG);
    if (ended == child_) {
      exit_code_ = files_detail::exit_code_of(status);
      running_ = false;
      return;
    }
    struct stat entry {};
    if (file_ && ::fstat(file_->descriptor(), &entry) == 0 && entry.st_size != size) {
      size = entry.st_size;
      last = Clock::now();
    }
    if (std::chrono::duration<double>(Clock::now() - last).count() > silence_limit_)
      refuse_silence();
    std::this_thread::sleep_for(kEndPoll);
  }
}

std::size_t ProcessOutput::read(char* bytes, std::size_t count) {
  if (!file_) return read_pipe(bytes, count);
  if (running_) {
    await_end();
    ::lseek(file_->descriptor(), 0, SEEK_SET);
  }
  const ssize_t got = ::read(file_->descriptor(), bytes, count);
  return got > 0 ? static_cast<std::size_t>(got) : 0;
}

int ProcessOutput::wait() {
  if (running_ && !file_) {
    std::string dropped(1 << 16, '\0');
    while (read_pipe(dropped.data(), dropped.size()) > 0) {
    }
  }
  await_end();
  return exit_code_;
}

std::string ProcessOutput::last_words() const {
  struct stat entry {};
  if (::fstat(errors_.descriptor(), &entry) != 0) return {};
  const off_t begin = std::max<off_t>(0, entry.st_size - static_cast<off_t>(kLastWords));
  std::string text(static_cast<std::size_t>(entry.st_size - begin), '\0');
  const ssize_t got = ::pread(errors_.descriptor(), text.data(), text.size(), begin);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos) return {};
  text.resize(end + 1);
  return escape_nonprintable(text.substr(text.find_last_of("\r\n") + 1));
}

}  // namespace clast
