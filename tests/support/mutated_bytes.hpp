#pragma once
/// Files with bytes changed, for readers to read or to refuse.
#include <algorithm>
#include <string>

#include "core/random.hpp"

namespace clast {

/// One to four changes: cut short, bytes overwritten, left out or repeated, words that numbers
/// should not be, other digits.
inline std::string mutated(const std::string& sound, Random& random) {
  std::string bytes = sound;
  const auto somewhere = [&] {
    return static_cast<std::size_t>(random.uniform_index(bytes.size()));
  };
  const std::size_t times = 1 + random.uniform_index(4);
  for (std::size_t i = 0; i < times && !bytes.empty(); ++i) {
    const std::size_t place = somewhere();
    const std::size_t length =
        std::min<std::size_t>(1 + random.uniform_index(60), bytes.size() - place);
    switch (random.uniform_index(9)) {
      case 0:
        bytes.resize(place);
        break;
      case 1:
        bytes[place] = static_cast<char>(random.uniform_index(256));
        break;
      case 2:
        for (std::size_t k = 0; k < length; ++k) {
          bytes[place + k] = static_cast<char>(random.uniform_index(256));
        }
        break;
      case 3:
        bytes.erase(place, length);
        break;
      case 4:
        bytes.insert(place, bytes.substr(somewhere(), length));
        break;
      case 5: {
        const char* const words[] = {"nan", "1e308", "-1", "99999999999", " ", "\n", "inf", "0"};
        bytes.insert(place, words[random.uniform_index(std::size(words))]);
        break;
      }
      default:  // other numbers in a file that is sound as such, so that the reader's checks work
        for (std::size_t k = 0; k < length; ++k) {
          char& byte = bytes[somewhere()];
          if (byte >= '0' && byte <= '9') byte = static_cast<char>('0' + random.uniform_index(10));
        }
    }
  }
  return bytes;
}

}  // namespace clast
