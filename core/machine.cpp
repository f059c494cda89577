#include "core/machine.hpp"

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

}  // namespace clast
