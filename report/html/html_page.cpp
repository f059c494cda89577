#include "report/html/html_page.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace clast::report_detail {
namespace {

constexpr std::string_view kStyle = R"(
:root{--ink:#1d2733;--soft:#5b6775;--line:#d5dbe1;--band:#f4f6f8;--warn:#fff4e0;--edge:#c77700}
*{box-sizing:border-box}
body{margin:0;color:var(--ink);background:#fff;font:15px/1.5 system-ui,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
main{max-width:1120px;margin:0 auto;padding:28px 24px 56px}
h1{font-size:27px;line-height:1.2;margin:0 0 4px}
h2{font-size:19px;margin:38px 0 10px;padding-bottom:5px;border-bottom:2px solid var(--ink)}
h3{font-size:15.5px;margin:22px 0 6px}
p{margin:6px 0 10px;max-width:86ch}
h1,h2,h3,p,li,dt{overflow-wrap:anywhere}
.lead{color:var(--soft);margin-bottom:16px}
.note{color:var(--soft);font-size:13.5px}
dl.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(225px,1fr));gap:1px;margin:14px 0}
dl.facts div{box-shadow:0 0 0 1px var(--line);padding:7px 12px}
dl.facts dt{color:var(--soft);font-size:12.5px}
dl.facts dd{margin:0;font-weight:600;overflow-wrap:anywhere}
.warnings{background:var(--warn);border-left:5px solid var(--edge);padding:9px 16px;margin:18px 0}
.warnings h2{border:0;margin:0 0 2px;padding:0;font-size:16px}
.warnings ul{margin:2px 0;padding-left:20px}
.fine{background:#eaf5ee;border-left:5px solid #009E73;padding:9px 16px;margin:18px 0}
.scroll{overflow-x:auto;margin:8px 0 14px}
table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums;min-width:50%}
th,td{padding:4px 8px;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{background:var(--band);vertical-align:bottom;white-space:normal;line-height:1.25;min-width:5ch;cursor:pointer;user-select:none;border-bottom:2px solid var(--soft);font-weight:600}
th:hover,th:focus{background:#e3e8ed;outline:none}
th[aria-sort=ascending]::after{content:" \25B4"}
th[aria-sort=descending]::after{content:" \25BE"}
th.t,td.t{text-align:left}
td.t{white-space:normal;overflow-wrap:break-word}
td.wrap{min-width:22ch;overflow-wrap:anywhere}
tbody tr:hover{background:#f7f9fb}
svg{display:block;width:100%;height:auto;font-family:inherit}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(440px,100%),1fr));gap:18px 26px;margin:8px 0}
.beside{display:grid;grid-template-columns:minmax(0,4fr) minmax(0,5fr);gap:18px 20px;margin:8px 0;align-items:start}
.beside th,.beside td{padding:4px 6px}
.beside td.wrap{min-width:14ch}
table.wide{font-size:12px}
table.wide th,table.wide td{padding:3px 4px}
table.wide td.wrap{min-width:15ch}
figure{margin:0}
figcaption{font-size:13.5px;color:var(--soft);margin-top:4px}
details{margin:10px 0}
summary{cursor:pointer;font-weight:600}
pre{background:var(--band);padding:12px;overflow-x:auto;font-size:12.5px;line-height:1.4}
code{font-size:12.5px;overflow-wrap:anywhere}
footer{margin-top:40px;border-top:1px solid var(--line);padding-top:10px;color:var(--soft);font-size:13px}
@media (max-width:1000px){.beside{grid-template-columns:minmax(0,1fr)}}
@media (max-width:600px){main{padding:16px 10px 40px}h1{font-size:22px}th:first-child,td:first-child{position:sticky;left:0;background:#fff;box-shadow:1px 0 0 var(--line)}th:first-child{background:var(--band)}td:first-child{max-width:38vw}.beside table{font-size:11px}.beside th,.beside td{padding:3px;white-space:normal;min-width:0}}
@media print{@page{margin:14mm}body{font-size:11px}main{padding:0;max-width:none}table{font-size:9.5px}th,td{padding:2px 5px}.scroll{overflow:visible}.note,figcaption,footer,code,pre{font-size:9.5px}h2{break-after:avoid}figure,tr,.warnings,.facts div{break-inside:avoid}.charts{grid-template-columns:1fr 1fr}*{-webkit-print-color-adjust:exact;print-color-adjust:exact}}
)";

constexpr std::string_view kScript = R"(
document.querySelectorAll('th').forEach(function(th){
  th.tabIndex=0;
  function sort(){
    var body=th.closest('table').tBodies[0],column=th.cellIndex;
    var up=th.getAttribute('aria-sort')!=='ascending';
    th.parentNode.querySelectorAll('th').forEach(function(o){o.removeAttribute('aria-sort')});
    th.setAttribute('aria-sort',up?'ascending':'descending');
    var value=function(row){return row.cells[column].textContent.trim()};
    Array.from(body.rows).sort(function(a,b){
      var s=value(a),t=value(b),x=parseFloat(s),y=parseFloat(t);
      var order=th.classList.contains('t')?s.localeCompare(t,undefined,{numeric:true})
        :isNaN(x)?(isNaN(y)?0:1):isNaN(y)?-1:x-y;
      return up?order:-order;
    }).forEach(function(row){body.appendChild(row)});
  }
  th.addEventListener('click',sort);
  th.addEventListener('keydown',function(e){if(e.key==='Enter'||e.key===' '){e.preventDefault();sort()}});
});
)";

std::string number_text(double value, std::chars_format format, int precision) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 400> text;  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
  std::string result(text.data(), end.ptr);
  // "-0.0" is a rounding residue, not a sign anyone asked for.
  if (result.find_first_not_of("-0.") == std::string::npos && result.front() == '-') {
    result.erase(0, 1);
  }
  return result;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 || c == '\n' || c == '\t') result += c;
      }
    }
  }
  return result;
}

std::string shortened(std::string_view text, std::size_t most) {
  std::size_t characters = 0, end = 0;  // up to and with the last character that has room
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) == 0x80) continue;
    if (++characters == most) end = i;
    if (characters > most) return std::string(text.substr(0, end)) + "\xE2\x80\xA6";
  }
  return std::string(text);
}

std::string link_to(std::string_view path) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string link;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '.' || c == '_' || c == '-';
    if (plain) {
      link += c;
    } else {
      link += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return link;
}

std::string fixed(double value, int decimals) {
  return number_text(value, std::chars_format::fixed, decimals);
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0.0) return "0";
  const std::string scientific = number_text(value, std::chars_format::scientific, digits - 1);
  // Read from the rounded number: 9.996 has two digits before the point once it is 10.0.
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  if (exponent >= 7 || exponent < -4) return scientific;
  return number_text(value, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

HtmlTable::HtmlTable(std::vector<std::string> heads, std::size_t text_columns)
    : heads_(std::move(heads)), text_columns_(text_columns) {}

HtmlTable& HtmlTable::row(std::vector<std::string> cells) {
  constexpr std::size_t kLongText = 24;  // broken anywhere from here on, if there is no room
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_text = i<text_columns_, is_long = cells[i].size()> kLongText;
    add_cell(is_text, is_long, escaped(cells[i]));
  }
  rows_ += "</tr>\n";
  return *this;
}

HtmlTable& HtmlTable::html_row(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) add_cell(i < text_columns_, false, cells[i]);
  rows_ += "</tr>\n";
  return *this;
}

void HtmlTable::add_cell(bool text, bool long_text, const std::string& html) {
  rows_ += !text ? "<td>" : long_text ? "<td class=\"t wrap\">" : "<td class=\"t\">";
  rows_ += html + "</td>";
}

std::string HtmlTable::html() const {
  constexpr std::size_t kWide = 10;  // columns from which a table is set closer
  std::string html = "<div class=\"scroll\"><table";
  html += heads_.size() >= kWide ? " class=\"wide\"><thead><tr>" : "><thead><tr>";
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    html += i < text_columns_ ? "<th class=\"t\">" : "<th>";
    html += escaped(heads_[i]) + "</th>";
  }
  return html + "</tr></thead>\n<tbody>\n" + rows_ + "</tbody></table></div>\n";
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view style) {
  return "<line x1=\"" + fixed(x1, 1) + "\" y1=\"" + fixed(y1, 1) + "\" x2=\"" + fixed(x2, 1) +
         "\" y2=\"" + fixed(y2, 1) + "\" " + std::string(style) + "/>";
}

std::string svg_text(double x, double y, std::string_view text, std::string_view style) {
  return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" " + std::string(style) + ">" +
         escaped(text) + "</text>";
}

std::string svg_open(double width, double height, std::string_view label) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + fixed(width, 0) + " " +
         fixed(height, 0) + "\" role=\"img\" aria-label=\"" + escaped(label) + "\">";
}

std::string svg_file(const std::string& svg) {
  const std::string_view box = "viewBox=\"0 0 ";
  const std::size_t at = svg.find(box) + box.size();
  const std::string size = svg.substr(at, svg.find('"', at) - at);  // "width height"
  const std::string width = size.substr(0, size.find(' '));
  const std::string height = size.substr(size.find(' ') + 1);
  const std::size_t end = svg.find('>') + 1;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg width=\"" + width + "\" height=\"" +
         height + "\" font-family=\"Helvetica, Arial, sans-serif\"" + svg.substr(4, end - 4) +
         "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#fff\"/>" +
         svg.substr(end);
}

std::string section(std::string_view title, std::string_view body) {
  return "<section>\n<h2>" + escaped(title) + "</h2>\n" + std::string(body) + "</section>\n";
}

std::string paragraph(std::string_view text) { return "<p>" + escaped(text) + "</p>\n"; }

std::string figure(std::string_view svg, std::string_view caption) {
  std::string html = "<figure>" + std::string(svg);
  if (!caption.empty()) html += "<figcaption>" + escaped(caption) + "</figcaption>";
  return html + "</figure>\n";
}

std::string fact(std::string_view name, std::string_view value) {
  return "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
}

std::string note_box(std::string_view title, const std::vector<std::string>& notes) {
  std::string html = "<div class=\"warnings\" role=\"note\"><h2>" + escaped(title) + "</h2><ul>\n";
  for (const std::string& note : notes) html += "<li>" + escaped(note) + "</li>\n";
  return html + "</ul></div>\n";
}

std::string page(std::string_view title, std::string_view body, const PageExtras& extras) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + std::string(kStyle) + std::string(extras.style) +
         "</style>\n</head>\n<body>\n<main>\n" + std::string(body) + "</main>\n<script>" +
         std::string(kScript) + std::string(extras.script) + "</script>\n</body>\n</html>\n";
}

}  // namespace clast::report_detail
