#pragma once
/// Controlled end of long jobs on signals.

namespace clast {

/// Handles SIGINT, SIGTERM and SIGHUP while an object exists. The first signal only sets a flag.
/// The second ends the program immediately.
class InterruptionWatch {
 public:
  /// Installs the signal handlers.
  /// @param said  message written to stderr at the first signal; must outlive this object
  explicit InterruptionWatch(const char* first_signal_message = "");
  ~InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;

  bool interrupted() const;

 private:
  void (*hangup_)(int);  ///< previous handler of SIGHUP
};

}  // namespace clast
