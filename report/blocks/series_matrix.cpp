#include "report/blocks/series_matrix.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/number_text.hpp"
#include "library/block_variation.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr std::uint32_t kMatrixWidth = 76, kMatrixHeight = 60;  ///< of a picture, px

constexpr double kVisibleFraction = 0.04;  ///< of S: a smaller radius is not seen
constexpr int kMatrixSkinSegments = 3;

/// Rounds the number of a row or column; targets agree to this.
double rounded_ratio(double value) { return 1e-4 * std::round(1e4 * value); }

struct Member {
  std::size_t number;  ///< in the gallery
  const Block* block;
  VariationRecord record;
};

/// Visible surface of a block: with the rounded layer if the radius is large.
TriangleMesh seen_surface(const Block& block) {
  const bool round = block.body.radius > kVisibleFraction * block.box.lengths[2];
  return round && !block.body.faces.empty() ? rounded_surface_mesh(block.body, kMatrixSkinSegments)
                                            : block.surface;
}

std::string picture(const Member& member) {
  const std::string source = "block-" + std::to_string(member.number);
  return "<button type=\"button\" class=\"cell\" data-source=\"" + source + "\" title=\"" +
         escape_html(member.block->id) + "\">" +
         render_thumbnail(seen_surface(*member.block), member.block->id, kMatrixWidth,
                          kMatrixHeight) +
         "</button>";
}

/// A table of pictures with heads above and beside.
class PictureTable {
 public:
  explicit PictureTable(std::vector<std::string> heads) : heads_(std::move(heads)) {}

  void row(const std::string& head, const std::vector<std::vector<const Member*>>& cells) {
    rows_ += "<tr><th scope=\"row\">" + escape_html(head) + "</th>";
    for (const std::vector<const Member*>& cell : cells) {
      rows_ += "<td>";
      for (const Member* member : cell) rows_ += picture(*member);
      rows_ += "</td>";
    }
    rows_ += "</tr>\n";
  }
  std::string html(const std::string& corner) const {
    std::string head = "<th>" + escape_html(corner) + "</th>";
    for (const std::string& text : heads_)
      head += "<th scope=\"col\">" + escape_html(text) + "</th>";
    return "<div class=\"series-scroll\"><table class=\"series\"><thead><tr>" + head +
           "</tr></thead><tbody>\n" + rows_ + "</tbody></table></div>\n";
  }

 private:
  std::vector<std::string> heads_;
  std::string rows_;
};

/// Forms of one block, larger S above.
std::string form_table(const std::string& parent, const std::vector<Member>& members) {
  using Ratio = std::function<double(const BoxRatios&)>;
  const auto across = [](const BoxRatios& form) { return rounded_ratio(form.i_l); };
  const Ratio s_l = [](const BoxRatios& form) { return rounded_ratio(form.s_l); };
  const Ratio s_i = [](const BoxRatios& form) { return rounded_ratio(form.s_l / form.i_l); };
  std::set<double> columns, rows_s_l, rows_s_i;
  for (const Member& member : members) {
    columns.insert(across(*member.record.target_ratios));
    rows_s_l.insert(s_l(*member.record.target_ratios));
    rows_s_i.insert(s_i(*member.record.target_ratios));
  }
  const bool by_s_i = rows_s_i.size() < rows_s_l.size();
  const std::set<double>& rows = by_s_i ? rows_s_i : rows_s_l;
  std::map<std::pair<double, double>, std::vector<const Member*>> at;
  for (const Member& member : members) {
    const BoxRatios& form = *member.record.target_ratios;
    at[{(by_s_i ? s_i : s_l)(form), across(form)}].push_back(&member);
  }
  std::vector<std::string> heads;
  for (const double column : columns) heads.push_back(format_significant(column, 3));
  PictureTable table(heads);
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    std::vector<std::vector<const Member*>> cells;
    for (const double column : columns) cells.push_back(at[{*row, column}]);
    table.row(format_significant(*row, 3), cells);
  }
  return "<h2>Forms of " + escape_html(parent) + "</h2>\n" +
         table.html(by_s_i ? "S/I by I/L" : "S/L by I/L");
}

std::string heading_of(const std::string& kind) {
  if (kind == "convexity") return "Convexity, increased by filling hollows";
  if (kind == "roundness") return "Wadell's roundness, by the radius of edges and corners";
  if (kind == "rounding") return "Radius of edges and corners, as a fraction of S";
  if (kind == "vertices") return "Number of vertices of the core";
  if (kind == "detail") return "Factor on the surface detail";
  return "Reference bodies";
}

/// Blocks down, steps across.
std::string step_table(const std::string& kind, const std::vector<Member>& members) {
  std::vector<std::string> parents;
  std::map<std::pair<double, std::string>, std::string> columns;  // by step, then by name
  std::map<std::string, std::map<std::pair<double, std::string>, std::vector<const Member*>>> at;
  for (const Member& member : members) {
    const VariationRecord& record = member.record;
    const std::pair<double, std::string> key = {record.target_value, record.reference};
    columns[key] =
        record.reference.empty() ? format_significant(record.target_value, 4) : record.reference;
    if (!at.contains(record.parent)) parents.push_back(record.parent);
    at[record.parent][key].push_back(&member);
  }
  std::vector<std::string> heads;
  for (const auto& [key, text] : columns) heads.push_back(text);
  PictureTable table(heads);
  for (const std::string& parent : parents) {
    std::vector<std::vector<const Member*>> cells;
    for (const auto& [key, text] : columns) cells.push_back(at[parent][key]);
    table.row(parent, cells);
  }
  return "<h2>" + heading_of(kind) + "</h2>\n" + table.html("of");
}

}  // namespace

std::string format_series_matrices(std::span<const Block* const> blocks) {
  std::map<std::string, std::vector<Member>> forms, steps;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::optional<VariationRecord> record = parse_variation(*blocks[i]);
    if (!record || record->kind == "drawn") continue;
    const std::string kind = record->kind == "inertia" ? "reference" : record->kind;
    if (kind == "stretch" && !record->target_ratios) continue;
    (kind == "stretch" ? forms[record->parent] : steps[kind]).push_back({i, blocks[i], *record});
  }
  std::string html;
  for (const auto& [parent, members] : forms) html += form_table(parent, members);
  for (const auto& [kind, members] : steps) html += step_table(kind, members);
  return html.empty() ? html : "<div class=\"series-tables\">\n" + html + "</div>\n";
}

}  // namespace clast::report_detail
