#pragma once
/// A figure against time, over realisations of blocks that stay.
#include <vector>

namespace clast {

struct RealisationCurve {
  std::vector<double> time;  ///< s, since the first block was released
  std::vector<double> mean, least, most;
};

}  // namespace clast
