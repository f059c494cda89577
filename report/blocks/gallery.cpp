#include "report/blocks/gallery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "classify/form.hpp"
#include "classify/schemes.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "library/unscaled.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/blocks/series_matrix.hpp"
#include "report/blocks/turntable.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/scene/three_library.hpp"
#include "report/text/block_text.hpp"

namespace clast {

using namespace report_detail;

namespace {

constexpr const char* kPage = "gallery.html";
constexpr const char* kMark = "class=\"gallery\"";
constexpr std::uint32_t kGalleryWidth = 200, kGalleryHeight = 150;  ///< of a picture, px
/// Triangles of the scans of all blocks together, and of one.
constexpr std::size_t kAllTriangles = 600'000, kFewest = 1'500, kMost = 12'000;
constexpr double kDeviationCells = 24.0;

/// A scheme of classes by which blocks can be chosen.
struct Scheme {
  const char* key;  ///< of the attribute data-KEY
  const char* name;
  std::string (*class_of)(const Axes& axes);
};
const std::array<Scheme, 3>& schemes() {
  static const std::array<Scheme, 3> all = {
      {{"shape", "compact or elongated", garcia_class},
       {"zingg", "Zingg", zingg_class},
       {"sneed", "Sneed and Folk", [](const Axes& axes) { return sneed_folk_class(axes); }}}};
  return all;
}

std::string option(const std::string& value, const std::string& text) {
  return "<option value=\"" + escape_html(value) + "\">" + escape_html(text) + "</option>\n";
}

/// Every class that some block has, with how many have it.
std::string class_choices(std::span<const Block* const> blocks) {
  std::string options = option("all:", "all");
  for (const Scheme& scheme : schemes()) {
    std::map<std::string, std::size_t> counts;
    for (const Block* block : blocks) ++counts[scheme.class_of(block->axes())];
    options += "<optgroup label=\"" + std::string(scheme.name) + "\">\n";
    for (const auto& [name, count] : counts) {
      options +=
          option(std::string(scheme.key) + ":" + name, name + " (" + std::to_string(count) + ")");
    }
    options += "</optgroup>\n";
  }
  return options;
}

std::string bar(std::span<const Block* const> blocks) {
  std::string orders;
  for (const auto& [key, text] : {std::array{"name", "name"},
                                  {"mass", "mass"},
                                  {"length", "length L"},
                                  {"elongation", "s_c"},
                                  {"vertices", "vertices"}}) {
    orders += option(key, text);
  }
  return "<div class=\"gallery-bar\">\n<label>class <select data-gallery=\"class\">\n" +
         class_choices(blocks) + "</select></label>\n<label>by <select data-gallery=\"order\">\n" +
         orders +
         "</select></label>\n<button type=\"button\" data-gallery=\"turn\" "
         "aria-label=\"reverse the order\">\xE2\x96\xB4</button>\n"
         "<output data-gallery=\"count\"></output>\n</div>\n";
}

std::string term(const std::string& name, const std::string& value) {
  return "<dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "</dd>";
}

/// Everything the library holds of a block, for the large view.
std::string details(const Block& block) {
  const Block* const one = &block;
  const TextTable table = make_block_table({&one, 1});
  std::string html = "<dl class=\"facts\">";
  for (std::size_t i = 1; i < table.headings.size(); ++i) {
    html += format_fact(table.headings[i], table.rows.front()[i]);
  }
  html += "</dl>";
  HtmlTable more({"what", "value"}, 2);
  for (const auto& [name, value] : describe_block(block)) more.row({name, value});
  return html + more.html();
}

std::string card(const Block& block, const std::string& source) {
  const Axes axes = block.axes();
  const bool metric = !is_unscaled(block);
  const std::string u = metric ? " m" : " u";
  std::string attributes = " data-name=\"" + escape_html(block.id) + "\" data-source=\"" + source +
                           "\" data-mass=\"" + (metric ? format_rounded(block.mass.mass, 6) : "") +
                           "\" data-length=\"" + (metric ? format_rounded(axes.L, 6) : "") +
                           "\" data-elongation=\"" + format_rounded(elongation_index(axes), 6) +
                           "\" data-vertices=\"" + std::to_string(block.body.vertices.size()) +
                           "\"";
  std::string classes;
  for (const Scheme& scheme : schemes()) {
    const std::string name = scheme.class_of(axes);
    attributes += " data-" + std::string(scheme.key) + "=\"" + escape_html(name) + "\"";
    classes += (classes.empty() ? "" : ", ") + name;
  }
  return "<article class=\"card\"" + attributes +
         "><button type=\"button\" class=\"open\" title=\"show in 3-D\">" +
         render_thumbnail(block.surface, block.id, kGalleryWidth, kGalleryHeight) +
         "</button>\n<h3>" + escape_html(block.id) + "</h3>\n<div class=\"file\">" +
         escape_html(block.source.file) + "</div>\n<dl>" + term("class", classes) +
         term("mass", metric ? format_rounded(block.mass.mass) + " kg" : "none: unscaled") +
         term("L x I x S", format_rounded(axes.L, 3) + " x " + format_rounded(axes.I, 3) + " x " +
                               format_rounded(axes.S, 3) + u) +
         term("volume", format_rounded(block.mass.volume) + (metric ? " m3" : " u3")) +
         term("s_c", format_rounded(elongation_index(axes), 3)) +
         term("vertices", std::to_string(block.body.vertices.size())) +
         "</dl>\n<template class=\"details\">" + details(block) + "</template>\n</article>\n";
}

}  // namespace

OutputFolderKind gallery_folder_kind() {
  return {"gallery of blocks", kPage, kMark,
          [](const std::filesystem::path& file) { return file == kPage; }};
}

std::filesystem::path write_gallery(std::span<const Block* const> blocks, const std::string& title,
                                    const std::filesystem::path& folder) {
  const TurntableLimits limits = {
      .scan_triangles =
          std::clamp(kAllTriangles / std::max<std::size_t>(blocks.size(), 1), kFewest, kMost),
      .deviation_cells = kDeviationCells};
  const bool three = three_is_installed();
  std::string cards, data;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::string source = "block-" + std::to_string(i);
    cards += card(*blocks[i], source);
    if (three) data += format_packed_element(source, format_turntable_json(*blocks[i], limits));
  }
  std::string body = "<h1>" + escape_html(title) + "</h1>\n<p class=\"lead\">" +
                     format_count(blocks.size(), "block") +
                     "; click a picture to see the block in 3-D with all its properties</p>\n";
  if (const std::string note = describe_unscaled_blocks(blocks); !note.empty())
    body += format_paragraph(note);
  body +=
      format_series_matrices(blocks) + bar(blocks) + "<div " + kMark + ">\n" + cards + "</div>\n";
  body +=
      "<dialog class=\"block\"><button type=\"button\" class=\"close\" "
      "aria-label=\"close\">\xC3\x97</button><h2></h2>\n" +
      (three ? format_turntable_view("") : std::string()) +
      "<div class=\"numbers\"></div></dialog>\n" + data + turntable_script() + "<footer>clast " +
      escape_html(version()) + "</footer>\n";
  const std::string style = std::string(assets::gallery_css) + std::string(assets::turntable_css);
  const std::filesystem::path target = folder / kPage;
  write_text_file(target, format_page(title, body, {.style = style, .script = assets::gallery_js}));
  return target;
}

}  // namespace clast
