#pragma once
/// Chart traces of curves over realisations.
#include <string>
#include <vector>

#include "report/charts/plotly_chart.hpp"
#include "study/compare/realisation_curve.hpp"

namespace clast::report_detail {

inline constexpr double kKilojoulesPerJoule = 1e-3;

/// Adds the mean curve over realisations and the band between minimum and maximum.
void add_realisation_curve(std::vector<ChartTrace>& traces, const std::string& name,
                           const std::string& colour, ChartTrace::Kind kind,
                           const RealisationCurve& curve, std::size_t realisations);

}  // namespace clast::report_detail
