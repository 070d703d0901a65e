// Watches how long a SUMO that was joined lets us wait: for another of its clients, or for ever.
#pragma once

#include <atomic>
#include <string>
#include <thread>

namespace pedzone {

/// Tells on standard error what is waited for, once it takes long. A call that waits when the
/// program is interrupted is ended a few seconds later: it then throws ConnectionLost.
class StepWatch {
 public:
  /// `wanted`: else it does nothing.
  explicit StepWatch(bool wanted);
  ~StepWatch();
  StepWatch(const StepWatch&) = delete;
  StepWatch& operator=(const StepWatch&) = delete;

  /// From now until end() SUMO is waited for. `what`, a literal, says so.
  void begin(const char* what);
  void end();

 private:
  void watch();
  void tell(double waited);

  std::atomic<const char*> what_ = nullptr;
  std::atomic<double> since_ = 0.0;  ///< [s]
  std::atomic<bool> over_ = false;
  double told_ = -1.0;         ///< [s] since when what was told is waited for
  double interrupted_ = -1.0;  ///< [s]
  std::thread thread_;
};

}  // namespace pedzone
