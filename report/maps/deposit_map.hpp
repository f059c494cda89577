#pragma once
/// Blocks of a deposit as map layers.
#include <cstdint>
#include <string>
#include <vector>

#include "core/files/table.hpp"
#include "core/types.hpp"
#include "library/block.hpp"
#include "report/maps/layer_style.hpp"

namespace clast::report_detail {

/// Block of a deposit and its outline in plan.
struct DepositMapBlock {
  std::string id;
  Axes axes;                      ///< m
  double volume = 0.0;            ///< m^3
  double mass = 0.0;              ///< kg
  double visible_fraction = 0.0;  ///< of its surface; NaN if unknown
  double confidence = 0.0;        ///< of its outline; NaN if unknown
  std::size_t points = 0;
  Vec3 centre = Vec3::Zero();                    ///< centre of mass, m
  Vec3 long_axis = Vec3::UnitX();                ///< direction of L
  std::vector<std::vector<Vec2>> outlines = {};  ///< polygons around its points, m; not closed
};

/// Makes the map entry of a block without its outline.
DepositMapBlock make_deposit_map_block(const Block& block);

/// Part of a deposit that is not among its blocks.
struct DepositMapPart {
  Vec3 place = Vec3::Zero();  ///< one of its points, m
  std::size_t points = 0;
  std::string reason;
};

struct DepositMap {
  std::string crs;  ///< "EPSG:25832" or WKT; empty if unknown
  std::vector<DepositMapBlock> blocks;
  std::vector<DepositMapPart> left_out;
};

/// Returns the columns of the blocks and of the parts that are left out.
const TableColumns<DepositMapBlock>& deposit_block_columns();
const TableColumns<DepositMapPart>& left_out_columns();

/// Makes the QGIS styles of the layers `outlines`, `centres` and `left_out`. Colours show the class
/// of Garcia et al.; uncertain outlines are red.
std::vector<LayerStyle> make_deposit_styles();

}  // namespace clast::report_detail
