#include "report/maps/map_marks.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {

std::string release_mark(double x, double y, const std::string& title) {
  const std::string at = fixed(x, 1) + " " + fixed(y, 1);
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"5\" d=\"M" + at +
         "m-6-6l12 12m0-12l-12 12\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"2.4\" "
         "d=\"M" +
         at + "m-5-5l10 10m0-10l-10 10\">" +
         (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</path>";
}

std::string release_outline(const std::string& path, const std::string& title) {
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"4\" d=\"" + path +
         "\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"1.8\" "
         "stroke-dasharray=\"6 4\" d=\"" +
         path + "\">" + (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</path>";
}

}  // namespace clast::report_detail
