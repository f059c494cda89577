#include "report/html/html_page.hpp"
#include "report/maps/map_style.hpp"
#include "report/maps/page_map.hpp"
#include "report/maps/site_map.hpp"
#include "report/pages/report_groups.hpp"
#include "report/pages/report_sections.hpp"

namespace clast::report_detail {

std::string format_deposit_map(const Comparison& comparison, const MapRasterSet& rasters) {
  return format_page_map(comparison, {.id = "deposit-map",
                                      .label = "map of the thickness of the deposit",
                                      .marks = false,
                                      .rasters = {&rasters}});
}

std::string format_map_section(const Comparison& comparison, const MapRasterSet& paths,
                               const MapRasterSet& deposits) {
  const bool density = comparison.rows.size() > kMaxSingleStops;
  const std::string stops =
      density ? "The " + std::to_string(comparison.rows.size()) +
                    " stops are shown by their density; stops.gpkg has each of them. "
              : "A click on a name in the legend hides or shows its stops, a double click shows "
                "only these; open symbols: still moving at the end. ";
  const std::string rasters =
      paths.layers.empty()
          ? ""
          : "The other maps show every path, cell by cell; rasters/ has them for a GIS. ";
  const std::string reading =
      "Centres of mass at the end of each run, in map coordinates. The wheel zooms, dragging moves "
      "the map. " +
      stops + rasters + "Relief lit from the north-west, contours every " +
      format_significant_digits(make_site_map(comparison).contour_interval(), 2) + " m" +
      (has_several_files(comparison) ? "; the surface is that of file 1." : ".");
  return format_section(
      "Where the blocks stop",
      format_page_map(comparison, {.id = "map",
                                   .label = "map of stops, release points and barriers",
                                   .rasters = {&paths, &deposits}}) +
          format_folded_section("How to read and use the map", format_paragraph(reading)));
}

}  // namespace clast::report_detail
