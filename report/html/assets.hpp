#pragma once
/// Files of the folder report/assets as strings. `page_css`, for example, is page.css.
#include <string_view>

namespace clast::report_detail::assets {

extern const std::string_view page_html;    ///< frame of every page
extern const std::string_view page_css;     ///< style of every page
extern const std::string_view page_js;      ///< script of every page
extern const std::string_view report_css;   ///< style of pages about runs and populations of blocks
extern const std::string_view scans_css;    ///< style of pages about scans
extern const std::string_view blocks_js;    ///< highlights a block in all diagrams
extern const std::string_view unpack_js;    ///< unpacks the contents of `format_packed_element`
extern const std::string_view charts_js;    ///< draws the charts of `format_plotly_figure`
extern const std::string_view gallery_css;  ///< style of galleries of blocks
extern const std::string_view gallery_js;   ///< filters, sorts and opens blocks of a gallery
extern const std::string_view three_view_js;   ///< opens a 3-D view
extern const std::string_view turntable_html;  ///< 3-D view of a block and its controls
extern const std::string_view turntable_css;   ///< style of turntables
extern const std::string_view turntable_js;    ///< draws the 3-D view of a block
extern const std::string_view map_html;        ///< map and its controls
extern const std::string_view map_css;         ///< style of maps
extern const std::string_view map_js;  ///< draws layers, paths, north arrow and scale bar of maps
extern const std::string_view deposit_html;  ///< map and 3-D view of a deposit, and their controls
extern const std::string_view deposit_css;   ///< style of pages of deposits
extern const std::string_view deposit_edits_js;  ///< applies and formats corrections of a deposit
extern const std::string_view deposit_scene_js;  ///< draws the 3-D view of a deposit
extern const std::string_view deposit_js;        ///< map, lists and controls of a deposit
extern const std::string_view scene_html;        ///< 3-D view of a report and its controls
extern const std::string_view scene_js;          ///< draws the 3-D view of a report

}  // namespace clast::report_detail::assets
