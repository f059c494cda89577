#include "report/maps/map_marks.hpp"

#include "core/files/png.hpp"
#include "report/html/html_page.hpp"
#include "study/campaign/barrier_line.hpp"

namespace clast::report_detail {

std::string draw_release_mark(double x, double y, const std::string& title) {
  const std::string at = format_fixed(x, 1) + " " + format_fixed(y, 1);
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"5\" d=\"M" + at +
         "m-6-6l12 12m0-12l-12 12\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"2.4\" "
         "d=\"M" +
         at + "m-5-5l10 10m0-10l-10 10\">" +
         (title.empty() ? "" : "<title>" + escape_html(title) + "</title>") + "</path>";
}

std::string draw_release_outline(const std::string& path, const std::string& title) {
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"4\" d=\"" + path +
         "\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"1.8\" "
         "stroke-dasharray=\"6 4\" d=\"" +
         path + "\">" + (title.empty() ? "" : "<title>" + escape_html(title) + "</title>") +
         "</path>";
}

CountedDirectionArrow make_counted_direction_arrow(const BarrierLine& line) {
  using Counts = BarrierLine::Counts;
  // The two arrows of a ring stand at different sides.
  const std::size_t side = line.counts == Counts::kExits ? 0 : (line.vertices.size() - 1) / 2;
  const Vec2 &from = line.vertices[side], &to = line.vertices[side + 1];
  const Vec2 along = (to - from).normalized();
  const Vec2 to_right(along.y(), -along.x());
  const bool right = !line.belongs_to_ring() ||
                     is_counter_clockwise(line.vertices) == (line.counts == Counts::kExits);
  return {0.5 * (from + to), right ? to_right : Vec2(-to_right), line.counts == Counts::kEither};
}

std::string draw_relief_image(const SiteMap& site, std::uint32_t columns) {
  const MapFrame& frame = site.terrain->frame;
  const Vec2 origin = frame.origin.head<2>();
  const Relief relief =
      sample_relief(*site.terrain, {site.window.low - origin, site.window.high - origin}, columns);
  return png_data_uri(render_relief_png(relief, site.terrain->zone_names, frame.origin.z(),
                                        site.contour_interval()));
}

}  // namespace clast::report_detail
