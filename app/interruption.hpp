#pragma once
/// A long job that is asked to stop and ends in order.

namespace clast {

/// While one of these lives, the first Ctrl-C, the first signal of a queue that wants the machine
/// back, or of a terminal that is closed, only sets a flag; the second ends the program at once.
class InterruptionWatch {
 public:
  /// @param said  written to stderr by the first signal: what the program waits for; nothing where
  ///              it stops soon. Must outlive the watch
  explicit InterruptionWatch(const char* said = "");
  ~InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;

  bool interrupted() const;

 private:
  void (*hangup_)(int);  ///< what was done before when the terminal is closed
};

}  // namespace clast
