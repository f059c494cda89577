#pragma once
/// Orderly end of long jobs on signals.

namespace clast {

/// While an object exists, the first SIGINT, SIGTERM or SIGHUP only sets a flag; the second ends
/// the program at once.
class InterruptionWatch {
 public:
  /// Installs the signal handlers.
  /// @param said  message written to stderr at the first signal, or empty; must outlive this object
  explicit InterruptionWatch(const char* said = "");
  ~InterruptionWatch();
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;

  bool interrupted() const;

 private:
  void (*hangup_)(int);  ///< previous handler of SIGHUP
};

}  // namespace clast
