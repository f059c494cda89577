#pragma once
/// Files of report/assets as strings: `page_css` is page.css.
#include <string_view>

namespace clast::report_detail::assets {

extern const std::string_view page_html;       ///< the frame of every page
extern const std::string_view page_css;        ///< of every page
extern const std::string_view page_js;         ///< of every page
extern const std::string_view report_css;      ///< of pages about runs and populations of blocks
extern const std::string_view scans_css;       ///< of pages about scans
extern const std::string_view blocks_js;       ///< highlights a block in all diagrams
extern const std::string_view unpack_js;       ///< unpacks what `format_packed_element` holds
extern const std::string_view charts_js;       ///< draws what `plotly_figure` holds
extern const std::string_view gallery_css;     ///< of galleries of blocks
extern const std::string_view gallery_js;      ///< filters, sorts and opens blocks of a gallery
extern const std::string_view turntable_html;  ///< a block in 3-D and its controls
extern const std::string_view turntable_css;   ///< of turntables
extern const std::string_view turntable_js;    ///< draws blocks in 3-D
extern const std::string_view map_html;        ///< a map and its controls
extern const std::string_view map_css;         ///< of maps
extern const std::string_view map_js;          ///< layers, paths, north arrow and scale bar of maps
extern const std::string_view scene_html;      ///< the 3-D view and its controls
extern const std::string_view scene_js;        ///< draws the 3-D view

}  // namespace clast::report_detail::assets
