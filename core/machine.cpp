#include "core/machine.hpp"

#include <time.h>

#include <fstream>
#include <string>

namespace clast {

std::optional<double> available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string key, unit;
  for (double number = 0.0; file >> key >> number;) {
    if (key == "MemAvailable:") return 1024.0 * number;
    std::getline(file, unit);
  }
  return std::nullopt;
}

double thread_processor_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace clast
