#pragma once
/// Curves of a quantity against time: mean, minimum and maximum over the realisations.
#include <vector>

namespace clast {

struct RealisationCurve {
  std::vector<double> time;  ///< time since the release of the first block, s
  std::vector<double> mean, minimum, maximum;
};

}  // namespace clast
