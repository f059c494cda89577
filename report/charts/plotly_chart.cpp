#include "report/charts/plotly_chart.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/files/text_file.hpp"
#include "report/charts/bins.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPlotHeight = 400;                  // px
constexpr std::size_t kMaxCurveSteps = 1500;      // of a curve; more can't be distinguished
constexpr std::size_t kMaxLegendCharacters = 40;  // of a name in the legend

/// Five digits are more than a chart shows.
double short_number(double value) {
  if (!std::isfinite(value) || value == 0.0) return value;
  const double scale = std::pow(10.0, 4.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) {
    list.push_back(std::isfinite(value) ? Json(short_number(value)) : Json());
  }
  return list;
}

/// Escapes HTML, because plotly.js interprets some tags in texts.
std::string plain(std::string_view text) { return escape_html(text); }

Json trace_json(const ChartTrace& trace, const ChartAxes& axes) {
  Json json = {{"name", plain(shorten_text(trace.name, kMaxLegendCharacters))},
               {"x", numbers(trace.x)},
               {"y", numbers(trace.y)}};
  const std::string y = axes.y_in_percent ? "%{y:.1%}" : "%{y:.4~g}";
  std::string hover = "%{x:.4~g}: " + y;
  if (!trace.notes.empty()) {
    Json notes = Json::array();
    for (const std::string& note : trace.notes) notes.push_back(plain(note));
    json["text"] = std::move(notes);
    json["textposition"] = "none";
    hover = y + "<br>%{text}";
  }
  json["hovertemplate"] = hover;
  if (!trace.shown) json["visible"] = "legendonly";
  if (trace.kind == ChartTrace::Kind::kBars) {
    json["type"] = "bar";
    json["marker"] = {{"color", trace.colour}};
    json["opacity"] = 0.6;
    return json;
  }
  json["type"] = "scatter";
  if (trace.kind == ChartTrace::Kind::kPoints) {
    json["mode"] = "markers";
    json["marker"] = {{"color", trace.colour}, {"size", 9}};
    return json;
  }
  json["mode"] = "lines";
  json["line"] = {{"color", trace.colour},
                  {"width", 2},
                  {"shape", trace.kind == ChartTrace::Kind::kSteps ? "hv" : "linear"}};
  if (!trace.dash.empty()) {
    std::string dash = trace.dash + "px";
    for (std::size_t at = 0; (at = dash.find(' ', at)) != std::string::npos;) {
      dash.replace(at, 1, "px,");
    }
    json["line"]["dash"] = dash;
  }
  if (trace.filled) json["fill"] = "tonexty";
  if (!trace.named) {
    json["showlegend"] = false;
    json["hoverinfo"] = "skip";
    json.erase("hovertemplate");
    json["line"]["width"] = 0;
  }
  return json;
}

/// A dotted line at every place, its name beside it at the top.
void add_places(const std::vector<LabelledLine>& places, Json& layout) {
  if (places.empty()) return;
  Json lines = Json::array(), names = Json::array();
  for (const LabelledLine& place : places) {
    const double x = short_number(place.x);
    lines.push_back({{"type", "line"},
                     {"x0", x},
                     {"x1", x},
                     {"yref", "paper"},
                     {"y0", 0},
                     {"y1", 1},
                     {"line", {{"color", "#1d2733"}, {"width", 1.5}, {"dash", "dot"}}}});
    names.push_back({{"x", x},
                     {"yref", "paper"},
                     {"y", 1},
                     {"xanchor", "left"},
                     {"yanchor", "top"},
                     {"bgcolor", "rgba(255,255,255,.7)"},
                     {"text", plain(shorten_text(place.name, kMaxLegendCharacters))},
                     {"showarrow", false},
                     {"font", {{"size", 11}}}});
  }
  layout["shapes"] = std::move(lines);
  layout["annotations"] = std::move(names);
}

Json layout_json(const ChartAxes& axes, const std::vector<ChartTrace>& traces) {
  const bool bars = std::any_of(traces.begin(), traces.end(), [](const ChartTrace& trace) {
    return trace.kind == ChartTrace::Kind::kBars;
  });
  Json layout = {{"height", kPlotHeight},
                 {"margin", {{"l", 62}, {"r", 14}, {"t", 30}, {"b", 46}}},
                 {"font",
                  {{"family", "system-ui,Segoe UI,Roboto,Helvetica Neue,Arial,sans-serif"},
                   {"size", 12},
                   {"color", "#1d2733"}}},
                 {"xaxis",
                  {{"title", {{"text", plain(axes.x)}, {"standoff", 6}}},
                   {"gridcolor", "#e2e6ea"},
                   {"zeroline", false}}},
                 {"yaxis",
                  {{"title", {{"text", plain(axes.y)}, {"standoff", 8}}},
                   {"gridcolor", "#e2e6ea"},
                   {"zeroline", false}}},
                 {"showlegend", true},
                 {"legend", {{"orientation", "h"}, {"y", -0.2}, {"yanchor", "top"}}},
                 {"hovermode", axes.equal_scales ? "closest" : "x unified"}};
  if (axes.y_in_percent) layout["yaxis"]["tickformat"] = ",.0%";
  if (axes.y_in_percent || !axes.equal_scales) layout["yaxis"]["rangemode"] = "tozero";
  if (axes.equal_scales) layout["yaxis"]["scaleanchor"] = "x";
  if (bars) layout["barmode"] = "overlay";
  add_places(axes.places, layout);
  return layout;
}

std::string with_count(const ChartSeries& sample) {
  return sample.name + " (" + std::to_string(sample.values.size()) + ")";
}

}  // namespace

std::filesystem::path find_plotly_file() {
  return std::filesystem::path(find_javascript_folder("CLAST_PLOTLY", CLAST_PLOTLY_FOLDER)) /
         "plotly.js";
}

bool plotly_is_installed() {
  std::error_code code;
  return std::filesystem::is_regular_file(find_plotly_file(), code);
}

std::string draw_plotly_chart(const ChartAxes& axes, const std::vector<ChartTrace>& traces) {
  Json data = Json::array();
  for (const ChartTrace& trace : traces) {
    if (!trace.x.empty()) data.push_back(trace_json(trace, axes));
  }
  if (data.empty()) return {};
  const Json figure = {{"data", data}, {"layout", layout_json(axes, traces)}};
  return format_plotly_figure(
      axes.title, "lines", figure.dump(-1, ' ', false, Json::error_handler_t::replace), axes.title);
}

std::string draw_interval_chart(const std::string& title, const std::string& label,
                                const std::vector<IntervalRow>& marks) {
  constexpr int kRow = 34, kAround = 120;  // px
  if (marks.empty()) return {};
  Json data = Json::array();
  for (const bool clear : {true, false}) {
    Json names = Json::array(), values = Json::array(), above = Json::array(),
         below = Json::array(), notes = Json::array();
    for (const IntervalRow& mark : marks) {
      if (mark.is_significant != clear) continue;
      names.push_back(plain(shorten_text(mark.name, kMaxLegendCharacters)));
      values.push_back(short_number(mark.value));
      above.push_back(short_number(mark.high - mark.value));
      below.push_back(short_number(mark.value - mark.low));
      notes.push_back(plain(mark.note));
    }
    if (names.empty()) continue;
    const char* colour = clear ? "#0072B2" : "#7b8794";
    data.push_back({{"type", "scatter"},
                    {"mode", "markers"},
                    {"name", clear ? "significant" : "not significant"},
                    {"x", values},
                    {"y", names},
                    {"text", notes},
                    {"hovertemplate", "%{text}<extra></extra>"},
                    {"error_x",
                     {{"type", "data"},
                      {"symmetric", false},
                      {"array", above},
                      {"arrayminus", below},
                      {"color", colour},
                      {"thickness", 2},
                      {"width", 5}}},
                    {"marker",
                     {{"size", 10},
                      {"color", clear ? colour : "#ffffff"},
                      {"line", {{"color", colour}, {"width", 2}}}}}});
  }
  Json order = Json::array();
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    order.push_back(plain(shorten_text(mark->name, kMaxLegendCharacters)));
  }
  const Json layout = {{"height", kAround + kRow * static_cast<int>(marks.size())},
                       {"margin", {{"l", 10}, {"r", 14}, {"t", 30}, {"b", 46}}},
                       {"font",
                        {{"family", "system-ui,Segoe UI,Roboto,Helvetica Neue,Arial,sans-serif"},
                         {"size", 12},
                         {"color", "#1d2733"}}},
                       {"xaxis",
                        {{"title", {{"text", plain(label)}, {"standoff", 6}}},
                         {"gridcolor", "#e2e6ea"},
                         {"zeroline", true},
                         {"zerolinecolor", "#1d2733"}}},
                       {"yaxis",
                        {{"automargin", true},
                         {"categoryorder", "array"},
                         {"categoryarray", order},
                         {"gridcolor", "#eef1f4"}}},
                       {"showlegend", true},
                       {"legend", {{"orientation", "h"}, {"y", -0.25}, {"yanchor", "top"}}},
                       {"hovermode", "closest"}};
  const Json figure = {{"data", data}, {"layout", layout}};
  return format_plotly_figure(title, "intervals",
                              figure.dump(-1, ' ', false, Json::error_handler_t::replace), title);
}

std::string format_plotly_figure(const std::string& label, const std::string& style,
                                 std::string json, const std::string& title) {
  if (!plotly_is_installed()) return {};
  return "<figure>" +
         (title.empty() ? std::string() : "<div class=\"title\">" + escape_html(title) + "</div>") +
         "<div class=\"chart " + style + "\" role=\"img\" aria-label=\"" + escape_html(label) +
         "\"></div>" + format_json_element("class=\"chart-data\"", std::move(json)) + "</figure>\n";
}

std::string charts_script() {
  if (!plotly_is_installed()) {
    return format_paragraph(
        "Charts are omitted, because there is no " + find_plotly_file().string() +
        ". Install plotly.js (on Debian: apt install python3-plotly), or name its "
        "folder in CLAST_PLOTLY, and compare again. The tables are complete.");
  }
  return format_packed_element("plotly-code", read_text_file(find_plotly_file())) +
         format_script_element(assets::charts_js);
}

std::vector<ChartTrace> make_cumulative_traces(const std::vector<ChartSeries>& samples,
                                               bool exceeding) {
  std::vector<ChartTrace> traces;
  for (const ChartSeries& sample : samples) {
    if (sample.values.empty()) continue;
    std::vector<double> sorted = sample.values;
    std::sort(sorted.begin(), sorted.end());
    const bool few = sorted.size() < kMinCurveValues;
    ChartTrace trace{with_count(sample),
                     sample.colour,
                     sample.dash,
                     few ? ChartTrace::Kind::kPoints : ChartTrace::Kind::kSteps,
                     {},
                     {}};
    const auto add = [&](double x, double below) {
      trace.x.push_back(x);
      trace.y.push_back(exceeding ? 1.0 - below : below);
    };
    const double total = static_cast<double>(sorted.size());
    if (few) {
      for (std::size_t i = 0; i < sorted.size(); ++i) {
        add(sorted[i], static_cast<double>(exceeding ? i : i + 1) / total);
      }
      traces.push_back(std::move(trace));
      continue;
    }
    add(sorted.front(), 0.0);
    const std::size_t stride = 1 + sorted.size() / kMaxCurveSteps;
    for (std::size_t i = stride - 1; i + 1 < sorted.size(); i += stride) {
      add(sorted[i], static_cast<double>(i + 1) / total);
    }
    add(sorted.back(), 1.0);
    traces.push_back(std::move(trace));
  }
  return traces;
}

std::vector<ChartTrace> make_histogram_traces(const std::vector<ChartSeries>& samples) {
  double low = INFINITY, high = -INFINITY;
  for (const ChartSeries& sample : samples) {
    for (const double value : sample.values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  const Bins bins = choose_bins(nice_axis_range(low, high));
  std::vector<ChartTrace> traces;
  for (const ChartSeries& sample : samples) {
    if (sample.values.empty()) continue;
    std::vector<std::size_t> counts(bins.count, 0);
    for (const double value : sample.values) ++counts[bins.bin_index(value)];
    ChartTrace trace{with_count(sample), sample.colour, {}, ChartTrace::Kind::kBars, {}, {}};
    for (std::size_t bin = 0; bin < bins.count; ++bin) {
      trace.x.push_back(bins.edge(bin) + 0.5 * bins.width);
      trace.y.push_back(static_cast<double>(counts[bin]) /
                        static_cast<double>(sample.values.size()));
      trace.notes.push_back(std::to_string(counts[bin]) + " from " +
                            format_significant_digits(bins.edge(bin), 4) + " to " +
                            format_significant_digits(bins.edge(bin) + bins.width, 4));
    }
    traces.push_back(std::move(trace));
  }
  return traces;
}

}  // namespace clast::report_detail
