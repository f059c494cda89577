#pragma once
/// How map layers are drawn, on pages and in QGIS: the classes and colours of rasters, and the
/// marks of blocks.
#include <array>
#include <string>
#include <vector>

#include "core/files/png.hpp"
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// The values of a raster in classes, each with a colour.
struct ValueStyle {
  std::string title;                 ///< "Kinetic energy, 95 %"
  std::string unit;                  ///< that a reader sees: "kJ"
  double unit_size = 1.0;            ///< in stored values: 1000 J
  std::vector<double> breaks;        ///< stored value up to which each class goes, ascending
  std::vector<Rgb> colours;          ///< of each class
  std::vector<std::string> numbers;  ///< the breaks in that unit: "0.3"

  /// "0.1 to 0.3 kJ"; "up to 0.1 kJ" of the first.
  std::string label(std::size_t class_index) const;
};

/// Layers are drawn with this opacity over the relief.
inline constexpr double kLayerOpacity = 0.85;
/// Lines of paths.
inline constexpr double kPathOpacity = 0.6;

/// The style of each layer. Energies have limits at 1, 3, 10, 30, ... (30 and 300 kJ separate weak,
/// medium and strong intensity in Swiss hazard maps), counts and shares at 1, 2, 5, 10, ...,
/// heights and speeds even ones. Layers of one quantity, such as E_mean and E_max, have the same
/// limits.
/// @cite jaboyedoff2005
std::vector<ValueStyle> choose_value_styles(const MapRasterSet& rasters);

/// A mark as plotly.js and as QGIS call it.
struct MarkShape {
  const char* plotly;
  const char* qgis;
  int qgis_angle = 0;  ///< clockwise, degrees
};

/// Stops observed in the field.
inline constexpr MarkShape kMeasuredShape = {"cross-thin-open", "cross"};
inline constexpr const char* kMeasuredColour = "#c0104a";
inline constexpr const char* kBarrierColour = "#111111";

/// More stops than this are drawn as a density, not one by one.
inline constexpr std::size_t kMostSingleStops = 5000;

/// How the stops of a block are drawn, or those of a shape class where blocks are many.
struct StopMark {
  std::size_t group = 0;  ///< of the comparison, over all files
  std::string key;        ///< block id or class
  std::string garcia;
  std::string colour;  ///< of its class: "#0072B2"
  MarkShape shape;
};

struct StopMarks {
  bool by_block = true;  ///< else by shape class
  std::vector<StopMark> marks;
};

/// Classes differ in colour, blocks of a class in shape.
StopMarks choose_stop_marks(const Comparison& comparison);

}  // namespace clast::report_detail
