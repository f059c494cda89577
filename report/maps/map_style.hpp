#pragma once
/// Styles of map layers, on pages and in QGIS.
#include <array>
#include <string>
#include <vector>

#include "core/files/png.hpp"
#include "report/maps/mark_shape.hpp"
#include "study/compare/comparison.hpp"
#include "study/compare/map_rasters.hpp"

namespace clast::report_detail {

/// Classified colour scale of a raster.
struct ColourScale {
  std::string title;                 ///< title of the layer, such as "Kinetic energy, 95 %"
  std::string unit;                  ///< displayed unit, such as "kJ"
  double unit_size = 1.0;            ///< displayed unit divided by stored unit, such as 1000 for kJ
  std::vector<double> breaks;        ///< upper limits of the classes in stored units, ascending
  std::vector<Rgb> colours;          ///< colour of each class
  std::vector<std::string> numbers;  ///< class limits as texts in the displayed unit, such as "0.3"

  /// Returns the label of a colour class, such as "0.1 to 0.3 kJ".
  std::string label(std::size_t class_index) const;
};

/// Opacity of raster layers over the relief.
inline constexpr double kLayerOpacity = 0.85;
inline constexpr double kPathOpacity = 0.6;

/// Chooses the colour scale of each raster layer. Energies have class limits at 1, 3, 10, 30, ...,
/// because 30 and 300 kJ separate weak, medium and strong intensity in Swiss hazard maps. Layers of
/// one quantity have the same limits.
/// @cite jaboyedoff2005
std::vector<ColourScale> choose_colour_scales(const MapRasterSet& rasters);

inline constexpr MarkShape kMeasuredStopShape = {"cross-thin-open", "cross"};
inline constexpr const char* kMeasuredStopColour = "#c0104a";
inline constexpr const char* kBarrierColour = "#111111";

/// Maximum number of stops that are drawn as single marks. More stops are drawn as a density.
inline constexpr std::size_t kMaxSingleStops = 5000;

/// Mark of the stops of one block, or of one shape class if there are many blocks.
struct StopMark {
  std::size_t group = 0;  ///< index into Comparison::groups
  std::string key;        ///< block id or class
  std::string garcia;
  std::string colour;  ///< colour of the class, such as "#0072B2"
  MarkShape shape;
};

struct StopMarks {
  bool by_block = true;  ///< true for one mark per block; false for one mark per shape class
  std::vector<StopMark> marks;
};

/// Chooses the marks of stops. Classes differ in colour, blocks of a class in mark shape.
StopMarks choose_stop_marks(const Comparison& comparison);

}  // namespace clast::report_detail
