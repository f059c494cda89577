#pragma once
/// Progress of long jobs on stderr. On a terminal, it is a bar with rate and remaining time;
/// otherwise, a line is printed for every tenth. Nothing is shown during the first two seconds.
#include <chrono>
#include <cstddef>
#include <string>

namespace clast {

/// Formats a duration in seconds or larger units, such as "3 min 20 s".
std::string format_duration(double seconds);

class ProgressBar {
 public:
  /// Starts the clock of a progress bar.
  /// @param what  items, such as "runs"
  /// @param total  number of items
  ProgressBar(std::string what, std::size_t total);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Sets the number of items finished before the clock started. Call it before the first update.
  void start_from(std::size_t done);
  /// Updates the display.
  /// @param note  current activity, shown on a terminal
  /// @param is_slow  true if the activity is shown on a line of its own
  void update(std::size_t done, const std::string& note = "", bool is_slow = false);
  /// Removes the bar from the terminal and ends an open line, so that other text can be printed.
  void clear();

 private:
  void show(std::size_t done, const std::string& note, double elapsed);
  void end_long_step();

  std::string what_;
  std::size_t total_;
  std::size_t first_ = 0;  ///< number of items finished when the clock started
  bool started_ = false;
  std::size_t tenths_ = 0;  ///< number of tenths of the last printed line
  bool terminal_;
  bool visible_ = false;
  std::chrono::steady_clock::time_point begin_;
  std::string long_step_;  ///< current slow step; empty if none
  std::chrono::steady_clock::time_point long_begin_;
};

}  // namespace clast
