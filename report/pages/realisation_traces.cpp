#include "report/pages/realisation_traces.hpp"

#include <utility>

namespace clast::report_detail {

void add_realisation_curve(std::vector<Trace>& traces, const std::string& name,
                           const std::string& colour, Trace::Kind kind,
                           const RealisationCurve& curve, std::size_t realisations) {
  Trace low{name, colour, "", kind, curve.time, curve.least};
  low.named = false;
  Trace high{name, colour, "", kind, curve.time, curve.most};
  high.named = false;
  high.filled = true;
  if (realisations > 1) {
    traces.push_back(std::move(low));
    traces.push_back(std::move(high));
  }
  traces.push_back({name, colour, "", kind, curve.time, curve.mean});
}

}  // namespace clast::report_detail
