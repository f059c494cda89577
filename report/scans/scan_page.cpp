#include "report/scans/scan_page.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {

namespace {

constexpr std::string_view kStyle = R"(
.views{display:grid;grid-template-columns:repeat(3,minmax(0,1fr));gap:8px}
.views>div{border:1px solid var(--line)}
.colours{max-width:440px}
.plan{max-width:620px}
figure+figure{margin-top:18px}
td img{display:block}
td a{font-weight:600}
@media (max-width:700px){.views{grid-template-columns:minmax(0,1fr)}}
)";

}  // namespace

std::string scan_page(std::string_view title, std::string_view body) {
  return page(title, body, {.style = kStyle});
}

}  // namespace clast::report_detail
