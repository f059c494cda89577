#include "report/maps/map_legend.hpp"

#include <set>
#include <string>

#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr std::size_t kMaxMapCharacters = 24;  // of a name, beside the map

/// Rows of marks and words beside the map.
class LegendRows {
 public:
  explicit LegendRows(double x) : x_(x) {}

  void head(const std::string& text) {
    y_ += y_ > kMapTop + 14.0 ? 10.0 : 0.0;
    svg_ += svg_text(x_, y_, text, "font-size=\"12.5\" font-weight=\"600\" fill=\"#1d2733\"");
    y_ += 20.0;
  }
  void row(const std::string& mark, const std::string& text) {
    svg_ += mark + svg_text(x_ + 24, y_, text, kMapTextStyle);
    y_ += 19.0;
  }
  void swatch(const std::string& colour, const std::string& text) {
    row("<rect x=\"" + format_fixed(x_, 1) + "\" y=\"" + format_fixed(y_ - 10, 1) +
            "\" width=\"16\" height=\"12\" fill=\"" + colour + "\" stroke=\"#8a949e\"/>",
        text);
  }
  double mark_x() const { return x_ + 8.0; }
  double mark_y() const { return y_ - 4.0; }
  double bottom() const { return y_; }
  const std::string& svg() const { return svg_; }

 private:
  double x_;
  double y_ = kMapTop + 12.0;
  std::string svg_;
};

}  // namespace

MapLegend draw_map_legend(const SiteMap& site, const MapToPixels& sheet) {
  LegendRows legend(kMapLeft + sheet.width() + 22.0);
  const auto line = [&](const std::string& stroke) {
    return format_svg_line(legend.mark_x() - 8, legend.mark_y(), legend.mark_x() + 8,
                           legend.mark_y(), stroke);
  };
  const bool has_contours = site.highest > site.lowest;  // level ground has none
  if (has_contours || !site.release_positions.empty() || !site.release_outlines.empty() ||
      !site.barriers.empty()) {
    legend.head("Site");
  }
  std::set<std::string> named;
  for (const ReleaseOutline& outline : site.release_outlines) {
    if (!named.insert(outline.name).second) continue;
    legend.row(draw_release_outline("M" + format_fixed(legend.mark_x() - 8, 1) + " " +
                                        format_fixed(legend.mark_y() - 5, 1) + "h16v10h-16Z",
                                    ""),
               outline.name);
  }
  if (!site.release_positions.empty()) {
    legend.row(draw_release_mark(legend.mark_x(), legend.mark_y(), ""), "release point");
  }
  if (!site.barriers.empty()) {
    legend.row(line("stroke=\"#111\" stroke-width=\"2.2\""),
               site.counts_crossings ? "barrier, crossings counted" : "barrier");
  }
  if (has_contours) {
    legend.row(line("stroke=\"" + format_colour(kContourColour) + "\" stroke-width=\"1.2\""),
               "contours every " + format_significant_digits(site.contour_interval(), 2) + " m");
  }
  const std::vector<std::string>& zones = site.terrain->zone_names;
  if (!zones.empty()) legend.head("Ground zones");
  for (std::size_t zone = 0; zone < zones.size(); ++zone) {
    legend.swatch(format_colour(zone_colour(zones[zone], zone)),
                  shorten_text(zones[zone], kMaxMapCharacters));
  }
  return {legend.svg(), legend.bottom()};
}

}  // namespace clast::report_detail
