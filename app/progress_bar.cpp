#include "app/progress_bar.hpp"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace clast {

namespace {

constexpr double kQuiet = 2.0;  ///< s without a word

/// "3.2 per s", or "2.5 s each" where they are slow.
std::string rate_text(double seconds_each) {
  char text[32];
  if (seconds_each < 1.0) {
    std::snprintf(text, sizeof text, "%.3g per s", 1.0 / seconds_each);
  } else {
    std::snprintf(text, sizeof text, "%.3g s each", seconds_each);
  }
  return text;
}

}  // namespace

std::string format_duration(double seconds) {
  char text[32];
  const long whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
  } else if (whole >= 60) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld s", whole);
  }
  return text;
}

ProgressBar::ProgressBar(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()) {}

void ProgressBar::start_from(std::size_t done) {
  started_ = true;
  first_ = done;
  tenths_ = total_ ? 10 * first_ / total_ : 0;
}

void ProgressBar::update(std::size_t done, const std::string& note, bool is_slow) {
  end_long_step();
  // A resumed job does not start at zero: what was there took no time now.
  if (!started_) start_from(done > 0 ? done - 1 : 0);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  if (total_ > 0 && (elapsed.count() >= kQuiet || is_slow)) show(done, note, elapsed.count());
  if (is_slow) {
    long_step_ = note;
    long_begin_ = std::chrono::steady_clock::now();
    if (!terminal_) std::fprintf(stderr, "%s ... ", note.c_str());
  }
  std::fflush(stderr);
}

void ProgressBar::show(std::size_t done, const std::string& note, double elapsed) {
  std::string left;
  if (done > first_ && done < total_) {
    const double each = elapsed / static_cast<double>(done - first_);
    left = ", " + rate_text(each) + ", " +
           format_duration(each * static_cast<double>(total_ - done)) + " left";
  }
  const std::string count =
      std::to_string(done) + " of " + std::to_string(total_) + " " + what_ + left;
  if (terminal_) {
    constexpr std::size_t kWidth = 30;
    const std::size_t filled = kWidth * done / total_;
    std::fprintf(stderr, "\r\033[K[%s%s] %s%s%s", std::string(filled, '#').c_str(),
                 std::string(kWidth - filled, '.').c_str(), count.c_str(), note.empty() ? "" : "  ",
                 note.c_str());
    visible_ = true;
  } else if (10 * done / total_ > tenths_) {
    tenths_ = 10 * done / total_;
    std::fprintf(stderr, "%s\n", count.c_str());
  }
}

void ProgressBar::end_long_step() {
  if (long_step_.empty()) return;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - long_begin_;
  const std::string time = format_duration(took.count());
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s ... %s\n", long_step_.c_str(), time.c_str());
    visible_ = false;
  } else {
    std::fprintf(stderr, "%s\n", time.c_str());
  }
  long_step_.clear();
}

void ProgressBar::clear() {
  end_long_step();
  if (!visible_) return;
  std::fprintf(stderr, "\r\033[K");
  std::fflush(stderr);
  visible_ = false;
}

}  // namespace clast
