#include "report/html/contents_list.hpp"

namespace clast::report_detail {

std::string make_contents_list(std::string_view body) {
  constexpr std::string_view kOpen = "<section id=\"", kMiddle = "\">\n<h2>", kEnd = "</h2>";
  std::string links;
  if (body.find("<header id=\"answer\">") != body.npos) {
    links = "<li><a href=\"#answer\">Answer</a></li>\n";
  }
  for (std::size_t at = body.find(kOpen); at != body.npos; at = body.find(kOpen, at + 1)) {
    const std::size_t id = at + kOpen.size(), id_end = body.find('"', id);
    if (body.substr(id_end, kMiddle.size()) != kMiddle) continue;
    const std::size_t title = id_end + kMiddle.size(), title_end = body.find(kEnd, title);
    links += "<li><a href=\"#" + std::string(body.substr(id, id_end - id)) + "\">" +
             std::string(body.substr(title, title_end - title)) + "</a></li>\n";
  }
  return "<nav class=\"contents\" aria-label=\"contents\"><ul>\n" + links + "</ul></nav>\n";
}

}  // namespace clast::report_detail
