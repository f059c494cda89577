#pragma once
/// Charts that a reader can zoom and filter, drawn by plotly.js in the browser.
#include <filesystem>
#include <string>
#include <vector>

#include "report/charts/series.hpp"

namespace clast::report_detail {

/// Where plotly.js is installed (Debian package python3-plotly): in the folder that CLAST_PLOTLY
/// names, or the one found when clast was configured.
std::filesystem::path plotly_file();
bool plotly_is_installed();

/// What one entry of a chart's legend shows and hides.
struct Trace {
  enum class Kind { kLine, kSteps, kBars, kPoints };
  std::string name;  ///< plain text
  std::string colour;
  std::string dash = {};  ///< SVG dash pattern; empty for a full line
  Kind kind = Kind::kLine;
  std::vector<double> x;
  std::vector<double> y;                ///< as many; NaN leaves a gap
  std::vector<std::string> notes = {};  ///< of each point, plain text; shown with the point
  bool filled = false;                  ///< the area down to the trace before it
  bool shown = true;                    ///< else only once its legend entry is clicked
  bool named = true;                    ///< has a legend entry; else it belongs to the one after it
};

/// A place on the x axis that a chart names: a line over its whole height.
struct ChartPoint {
  double x = 0.0;
  std::string name;  ///< plain text
};

struct ChartAxes {
  std::string title;
  std::string x;  ///< label with unit
  std::string y;
  bool y_in_percent = false;  ///< y are shares
  bool equal_scales = false;  ///< of both axes, as on a map
  std::vector<ChartPoint> places = {};
};

/// A value with its interval, a row of `draw_interval_chart`.
struct IntervalMark {
  std::string name;  ///< plain text
  double value = 0.0;
  double low = 0.0, high = 0.0;
  bool clear = false;  ///< more than chance: filled, else open
  std::string note;    ///< shown with the mark, plain text
};

/// The place of a chart in the page and what is drawn there. Empty without traces that have points,
/// and where plotly.js is not installed: `charts_script` then says so.
std::string draw_plotly_chart(const ChartAxes& axes, const std::vector<Trace>& traces);

/// Intervals below each other, the first on top, with a line at zero. Empty as `draw_plotly_chart`.
std::string draw_interval_chart(const std::string& title, const std::string& label,
                           const std::vector<IntervalMark>& marks);

/// The same for a figure written by hand: JSON with `data` and `layout` as plotly.js reads them,
/// and optionally `config`.
/// @param style  class of the element beside "chart"
/// @param title  plain text above the chart; it breaks into lines where a chart could not
std::string plotly_figure(const std::string& label, const std::string& style, std::string json,
                          const std::string& title = {});

/// plotly.js and what draws the charts of a page when they come into view; once, after the charts.
/// Where plotly.js is not installed, a sentence that says what to do.
std::string charts_script();

/// Fewer values than these are drawn one by one: a curve would promise a distribution.
inline constexpr std::size_t kFewestForCurve = 4;

/// Share of each sample that is at or below x, or above x with `exceeding`. Samples without values
/// are left out; of large ones about 1,500 steps are drawn, of few values points, each with what is
/// at or beyond it.
std::vector<Trace> make_cumulative_traces(const std::vector<Series>& samples, bool exceeding = false);

/// Share of each sample in every bin, over common bins.
std::vector<Trace> make_histogram_traces(const std::vector<Series>& samples);

}  // namespace clast::report_detail
