#pragma once
/// How far a long job is, on stderr: a bar with rate and remaining time on a terminal, a plain line
/// every tenth otherwise. Nothing is shown in the first two seconds.
#include <chrono>
#include <cstddef>
#include <string>

namespace clast {

/// "3 min 20 s"; at least seconds are named.
std::string format_duration(double seconds);

class ProgressBar {
 public:
  /// @param what   for example "runs"
  /// @param total  how many there are to do
  ProgressBar(std::string what, std::size_t total);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Before the first update: so many were done before the clock started.
  void start_from(std::size_t done);
  /// @param note        what is being done just now, shown on a terminal
  /// @param is_slow  gives it a line of its own, with the time that it took in the end
  void update(std::size_t done, const std::string& note = "", bool is_slow = false);
  /// Removes the bar from the terminal and ends a line begun, so that another can be printed.
  void clear();

 private:
  void show(std::size_t done, const std::string& note, double elapsed);
  void end_long_step();

  std::string what_;
  std::size_t total_;
  std::size_t first_ = 0;  ///< done when the clock started
  bool started_ = false;
  std::size_t tenths_ = 0;  ///< of the last plain line
  bool terminal_;
  bool visible_ = false;
  std::chrono::steady_clock::time_point begin_;
  std::string long_step_;  ///< that is under way; else empty
  std::chrono::steady_clock::time_point long_begin_;
};

}  // namespace clast
