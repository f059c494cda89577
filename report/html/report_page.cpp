#include "report/html/report_page.hpp"

#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr std::string_view kStyle = R"(
#scene .view{min-height:320px;background:var(--band);line-height:0}
#scene .bar{display:flex;flex-wrap:wrap;gap:6px 16px;align-items:center;padding:7px 0;font-size:14px}
#scene input[type=range]{flex:1;min-width:160px}
#scene output{min-width:6ch;text-align:right;font-variant-numeric:tabular-nums}
.chart{min-height:400px}
.chart.map{min-height:640px}
.chart .modebar-group{display:flex!important}
.block:hover,.lit{stroke:#000;stroke-width:2}
)";

constexpr std::string_view kScript = R"(
(function(){
  var lit=[];
  function light(on){lit.forEach(function(e){e.classList.toggle('lit',on)})}
  document.addEventListener('pointerover',function(e){
    var mark=e.target.closest&&e.target.closest('[data-block]');
    light(false);lit=[];
    if(!mark)return;
    lit=Array.from(document.querySelectorAll('[data-block="'+mark.dataset.block+'"]'));
    light(true);
  });
})();
)";

}  // namespace

std::string report_page(std::string_view title, std::string_view body) {
  return page(title, body, {.style = kStyle, .script = kScript});
}

}  // namespace clast::report_detail
