#include "study/report/map_marks.hpp"

#include "study/report/html_page.hpp"
#include "study/report/palette.hpp"

namespace clast {

std::string release_mark(double x, double y, const std::string& title) {
  const std::string at = fixed(x, 1) + " " + fixed(y, 1);
  return "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"5\" d=\"M" + at +
         "m-6-6l12 12m0-12l-12 12\"/><path fill=\"none\" stroke=\"#111\" stroke-width=\"2.4\" "
         "d=\"M" +
         at + "m-5-5l10 10m0-10l-10 10\">" +
         (title.empty() ? "" : "<title>" + escaped(title) + "</title>") + "</path>";
}

std::string stop_mark(double x, double y, const std::string& garcia, bool at_rest,
                      const std::string& title) {
  const std::string paint = at_rest
                                ? "fill=\"" + class_colour(garcia) +
                                      "\" fill-opacity=\".8\" stroke=\"#fff\" stroke-width=\".7\""
                                : "fill=\"#fff\" fill-opacity=\".6\" stroke-width=\"1.6\" "
                                  "stroke=\"" +
                                      class_colour(garcia) + "\"";
  const std::string tail = title.empty() ? "/>" : "><title>" + escaped(title) + "</title>";
  if (garcia == "compact") {
    return "<circle class=\"stop\" cx=\"" + fixed(x, 1) + "\" cy=\"" + fixed(y, 1) +
           "\" r=\"3.6\" " + paint + tail + (title.empty() ? "" : "</circle>");
  }
  return "<path class=\"stop\" d=\"M" + fixed(x, 1) + " " + fixed(y - 4.8, 1) +
         "l4.8 4.8-4.8 4.8-4.8-4.8z\" " + paint + tail + (title.empty() ? "" : "</path>");
}

std::string block_class(std::size_t group) { return "block-" + std::to_string(group); }

}  // namespace clast
