#include "app/interruption.hpp"

#include <unistd.h>

#include <csignal>
#include <cstring>

namespace clast {

namespace {

// A signal handler can reach nothing else.
volatile std::sig_atomic_t stop_asked = 0;
const char* volatile said_first = "";

void ask_to_stop(int) {
  stop_asked = 1;
  const char* text = said_first;
  const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  static_cast<void>(written);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

InterruptionWatch::InterruptionWatch(const char* first_signal_message) {
  stop_asked = 0;
  said_first = first_signal_message;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  hangup_ = std::signal(SIGHUP, ask_to_stop);
  if (hangup_ == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // under nohup
}

InterruptionWatch::~InterruptionWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, hangup_);
}

bool InterruptionWatch::interrupted() const { return stop_asked != 0; }

}  // namespace clast
