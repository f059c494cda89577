#include "report/scans/deposit_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/files/up_axis.hpp"
#include "core/version.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/scans/deposit_plan.hpp"
#include "report/scans/json/deposit_json.hpp"
#include "report/scene/three_library.hpp"

namespace clast {

using namespace report_detail;

namespace {

/// Side of the cells in which the outlines of blocks are traced, in point spacings.
constexpr double kOutlineCell = 1.5;

/// Reason in the words of a page, without names of options.
std::string describe_reason(LeftOutReason reason) {
  return reason == LeftOutReason::kTooSmall ? "smaller than asked for" : name_of(reason);
}

/// Points of the scan in metres, z up.
std::vector<Vec3> deposit_points(const DepositPageContents& deposit) {
  std::vector<Vec3> points;
  points.reserve(deposit.scan->raw.vertices.size());
  for (const Vec3& vertex : deposit.scan->raw.vertices) {
    const Vec3 p = deposit.unit * vertex;
    points.push_back(deposit.up == "y" ? y_up_to_z_up(p) : p);
  }
  return points;
}

/// Number of a block, from 1.
std::uint32_t block_number(const DepositPageContents& deposit, const std::string& id) {
  const auto found = std::find(deposit.ids.begin(), deposit.ids.end(), id);
  return static_cast<std::uint32_t>(found - deposit.ids.begin() + 1);
}

DepositMap make_map(const DepositPageContents& deposit, std::span<const Vec3> points) {
  DepositMap map;
  // The system of the file holds for its coordinates as they are.
  if (deposit.unit == 1.0 && deposit.up == "z") map.crs = deposit.scan->crs;
  std::vector<std::vector<Vec2>> plan(deposit.ids.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t block = deposit.scan->block_of_point[i];
    if (block > 0) plan[block - 1].push_back(points[i].head<2>());
  }
  for (const Block& block : *deposit.blocks) {
    DepositMapBlock entry = make_deposit_map_block(block);
    const std::vector<Vec2>& around = plan[block_number(deposit, block.id) - 1];
    entry.outlines = trace_plan_outlines(around, kOutlineCell * deposit.scan->spacing);
    map.blocks.push_back(std::move(entry));
  }
  for (const LeftOutPart& part : deposit.scan->left_out) {
    map.left_out.push_back({part.centre, part.points, describe_reason(part.reason)});
  }
  return map;
}

/// Confidence by which blocks are sorted; unknown ones are last.
double known_or_last(double confidence) { return std::isnan(confidence) ? 2.0 : confidence; }

/// The blocks, those with the least certain outlines first.
std::string format_block_list(const DepositPageContents& deposit, const DepositMap& map) {
  HtmlTable table({"block", "corrections", "class", "confidence %", "L m", "I m", "S m",
                   "volume m3", "mass kg", "visible %", "points"},
                  3);
  std::vector<const DepositMapBlock*> order;
  for (const DepositMapBlock& block : map.blocks) order.push_back(&block);
  std::stable_sort(order.begin(), order.end(),
                   [](const DepositMapBlock* a, const DepositMapBlock* b) {
                     return known_or_last(a->confidence) < known_or_last(b->confidence);
                   });
  for (const DepositMapBlock* block : order) {
    table.add_html_row(
        {"<a data-block=\"" + std::to_string(block_number(deposit, block->id)) + "\" href=\"" +
             format_link_target("blocks/" + block->id + ".html") + "\">" + escape_html(block->id) +
             "</a>",
         "", escape_html(sneed_folk_class(block->axes) + ", " + garcia_class(block->axes)),
         format_fixed(100.0 * block->confidence, 0), format_significant_digits(block->axes.L, 3),
         format_significant_digits(block->axes.I, 3), format_significant_digits(block->axes.S, 3),
         format_significant_digits(block->volume, 3), format_significant_digits(block->mass, 3),
         format_fixed(100.0 * block->visible_fraction, 0), std::to_string(block->points)});
  }
  return format_section(
      "Blocks",
      format_paragraph("Least certain outlines first. Confidence is the probability that an "
                       "outline is that of one block. Click a row to select its block, or its name "
                       "for the page of the block.") +
          "<div class=\"blocks\">" + table.html() + "</div>");
}

std::string format_left_out_list(const DepositMap& map) {
  if (map.left_out.empty()) return {};
  HtmlTable table({"reason", "corrections", "x m", "y m", "z m", "points"}, 2);
  for (std::size_t i = 0; i < map.left_out.size(); ++i) {
    const DepositMapPart& part = map.left_out[i];
    table.add_html_row(
        {"<span data-part=\"" + std::to_string(i) + "\">" + escape_html(part.reason) + "</span>",
         "", format_fixed(part.place.x(), 2), format_fixed(part.place.y(), 2),
         format_fixed(part.place.z(), 2), std::to_string(part.points)});
  }
  return format_section(
      "Left out",
      format_paragraph("Parts that may be blocks, or pieces of blocks, but are not among the "
                       "blocks. A cross on the map marks each; merge it with its block, or leave "
                       "it out.") +
          "<div class=\"parts\">" + table.html() + "</div>");
}

std::string format_deposit_views(const DepositPageContents& deposit, const DepositPlan& plan) {
  return fill_template(
      assets::deposit_html,
      {{"relief", png_data_uri(render_plan_png(plan))},
       {"command", escape_html(deposit.next_command)},
       {"note", three_is_installed()
                    ? std::string()
                    : format_paragraph(explain_missing_three("write the pages again"))}});
}

/// Data and scripts, which the page has after the lists that they fill.
std::string format_deposit_scripts(const DepositPageContents& deposit, const DepositPlan& plan,
                                   std::span<const Vec3> points) {
  std::vector<std::uint32_t> accepted;
  for (const Block& block : *deposit.blocks) {
    if (block.deposit && block.deposit->confidence == 1.0) {
      accepted.push_back(block_number(deposit, block.id));
    }
  }
  const DepositViewContents view{points,   deposit.scan->block_of_point, deposit.ids,
                                 accepted, deposit.scan->left_out,       deposit.edits};
  return format_packed_element("deposit-data", format_deposit_json(view, plan)) +
         format_script_element(assets::unpack_js) + (three_is_installed() ? three_scripts() : "") +
         format_script_element(assets::deposit_edits_js) +
         format_script_element(assets::deposit_scene_js) +
         format_script_element(assets::deposit_js);
}

}  // namespace

DepositPage make_deposit_page(const DepositPageContents& deposit) {
  const std::vector<Vec3> points = deposit_points(deposit);
  DepositPage page;
  page.map = make_map(deposit, points);
  const DepositPlan plan =
      make_deposit_plan(points, deposit.scan->block_of_point, deposit.scan->spacing);
  std::string body = "<h1>Deposit " + escape_html(deposit.name) + "</h1>\n<p class=\"lead\">" +
                     format_count(page.map.blocks.size(), "block") + " in " +
                     format_count(points.size(), "point") + " of " + escape_html(deposit.file);
  if (!page.map.left_out.empty()) {
    body += ", " + format_count(page.map.left_out.size(), "part") + " left out";
  }
  body += "</p>\n" + format_deposit_views(deposit, plan) + format_block_list(deposit, page.map) +
          format_left_out_list(page.map) + format_deposit_scripts(deposit, plan, points) +
          "<footer>clast " + escape_html(version()) + "; map layers of this page: <a href=\"" +
          format_link_target(deposit.stem + ".gpkg") + "\">" + escape_html(deposit.stem) +
          ".gpkg</a></footer>\n";
  const std::string style = std::string(assets::scans_css) + std::string(assets::deposit_css);
  page.html = format_page("Deposit " + deposit.name, body, {.style = style});
  return page;
}

}  // namespace clast
