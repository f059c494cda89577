#pragma once
/// Interactive charts, drawn by plotly.js in the browser.
#include <filesystem>
#include <string>
#include <vector>

#include "report/charts/series.hpp"

namespace clast::report_detail {

/// Finds plotly.js (Debian package python3-plotly) in the folder named by CLAST_PLOTLY, or in that
/// found at configuration.
std::filesystem::path find_plotly_file();
bool plotly_is_installed();

/// One data series of a chart, with its legend entry.
struct ChartTrace {
  enum class Kind { kLine, kSteps, kBars, kPoints };
  std::string name;  ///< plain text
  std::string colour;
  std::string dash = {};  ///< SVG dash pattern; empty for a solid line
  Kind kind = Kind::kLine;
  std::vector<double> x;
  std::vector<double> y;                ///< y values, as many as `x`; NaN makes a gap
  std::vector<std::string> notes = {};  ///< tooltip of each point, plain text
  bool filled = false;                  ///< true if the area down to the previous trace is filled
  bool shown = true;  ///< false if the trace is hidden until its legend entry is clicked
  bool named = true;  ///< false if the trace has no legend entry
};

/// Vertical line with a label.
struct LabelledLine {
  double x = 0.0;
  std::string name;  ///< plain text
};

struct ChartAxes {
  std::string title;
  std::string x;  ///< label with unit
  std::string y;
  bool y_in_percent = false;  ///< true if y values are fractions that are shown in per cent
  bool equal_scales = false;  ///< true if both axes have equal scales
  std::vector<LabelledLine> places = {};
};

/// Value with its interval, drawn as one row of `draw_interval_chart`.
struct IntervalRow {
  std::string name;  ///< plain text
  double value = 0.0;
  double low = 0.0, high = 0.0;
  bool is_significant = false;  ///< true for significant values, whose marks are filled
  std::string note;             ///< tooltip, plain text
};

/// Formats an interactive chart as HTML. Empty without points, or if plotly.js is not installed.
std::string draw_plotly_chart(const ChartAxes& axes, const std::vector<ChartTrace>& traces);

/// Formats a chart of horizontal intervals with a vertical line at zero, as HTML. Empty without
/// intervals, or if plotly.js is not installed.
std::string draw_interval_chart(const std::string& title, const std::string& label,
                                const std::vector<IntervalRow>& marks);

/// Formats a chart from data of plotly.js.
/// @param json  JSON with `data`, `layout` and optionally `config` of plotly.js
/// @param style  additional CSS class
/// @param title  plain text above the chart, which is wrapped if necessary
std::string format_plotly_figure(const std::string& label, const std::string& style,
                                 std::string json, const std::string& title = {});

/// Returns the scripts that draw all charts of a page, to be inserted once after the charts.
/// Without plotly.js, returns a note on how to install it.
std::string charts_script();

/// Minimum number of values that are drawn as a curve. Fewer values are drawn as points.
inline constexpr std::size_t kMinCurveValues = 4;

/// Makes the traces of cumulative distributions, or of exceedance curves if `exceeding`. Empty
/// samples are omitted, and small ones are drawn as points.
std::vector<ChartTrace> make_cumulative_traces(const std::vector<ChartSeries>& samples,
                                               bool exceeding = false);

/// Makes the traces of relative histograms of samples, which have the same bins.
std::vector<ChartTrace> make_histogram_traces(const std::vector<ChartSeries>& samples);

}  // namespace clast::report_detail
