#include "report/pages/realisation_traces.hpp"

#include <utility>

namespace clast::report_detail {

void add_realisation_curve(std::vector<ChartTrace>& traces, const std::string& name,
                           const std::string& colour, ChartTrace::Kind kind,
                           const RealisationCurve& curve, std::size_t realisations) {
  ChartTrace low{name, colour, "", kind, curve.time, curve.minimum};
  low.named = false;
  ChartTrace high{name, colour, "", kind, curve.time, curve.maximum};
  high.named = false;
  high.filled = true;
  if (realisations > 1) {
    traces.push_back(std::move(low));
    traces.push_back(std::move(high));
  }
  traces.push_back({name, colour, "", kind, curve.time, curve.mean});
}

}  // namespace clast::report_detail
