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
                    " stops are too many to show one by one, so the map shows their density; "
                    "stops.gpkg contains every stop. "
              : "Click a name in the legend to hide or show its stops; double-click it to show "
                "only these stops. Open symbols are blocks that were still moving at the end. ";
  const std::string rasters = paths.layers.empty()
                                  ? ""
                                  : "The other maps combine all paths cell by cell; the folder "
                                    "rasters/ contains them for a GIS. ";
  const std::string reading =
      "The map shows the centres of mass at the end of each run, in map coordinates. Use the mouse "
      "wheel to zoom and drag to move the map. " +
      stops + rasters + "The relief is lit from the north-west; contours are every " +
      format_significant_digits(make_site_map(comparison).contour_interval(), 2) + " m" +
      (has_several_files(comparison) ? "; the surface is that of file 1." : ".");
  return format_section(
      "Stops of the blocks",
      format_page_map(comparison, {.id = "map",
                                   .label = "map of stops, release points and barriers",
                                   .rasters = {&paths, &deposits}}) +
          format_folded_section("How to read and use the map", format_paragraph(reading)));
}

}  // namespace clast::report_detail
