#include "report/maps/deposit_map.hpp"

#include <cmath>

#include "classify/axis_orientation.hpp"
#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "report/charts/palette.hpp"
#include "report/maps/detail/qml.hpp"

namespace clast::report_detail {
namespace {

/// Confidence below which an outline is drawn as uncertain.
constexpr double kUncertain = 0.8;
constexpr const char* kUncertainColour = "#c0104a";

/// "0,114,178,60" of "#0072B2".
std::string translucent(const std::string& colour) {
  std::string text;
  for (const std::size_t at : {1u, 3u, 5u}) {
    text += std::to_string(std::stoi(colour.substr(at, 2), nullptr, 16)) + ",";
  }
  return text + "60";
}

}  // namespace

DepositMapBlock make_deposit_map_block(const Block& block) {
  return {.id = block.id,
          .axes = block.axes(),
          .volume = block.mass.volume,
          .mass = block.mass.mass,
          .visible_fraction = block.deposit ? block.deposit->visible_fraction : NAN,
          .confidence = block.deposit ? block.deposit->confidence : NAN,
          .points = block.deposit ? block.deposit->points : 0,
          .centre = block.mass.centre,
          .long_axis = block.box.axes.col(0)};
}

const TableColumns<DepositMapBlock>& deposit_block_columns() {
  using Row = DepositMapBlock;
  static const TableColumns<Row> columns = {
      {"block", "", "id in the library", [](const Row& row) { return row.id; }},
      {"L_m", "m", "axes, L >= I >= S", [](const Row& row) { return row.axes.L; }},
      {"I_m", "m", "axes, L >= I >= S", [](const Row& row) { return row.axes.I; }},
      {"S_m", "m", "axes, L >= I >= S", [](const Row& row) { return row.axes.S; }},
      {"volume_m3", "m^3", "volume of the closed body", [](const Row& row) { return row.volume; }},
      {"mass_kg", "kg", "volume times density", [](const Row& row) { return row.mass; }},
      {"class", "", "class by Sneed and Folk",
       [](const Row& row) { return sneed_folk_class(row.axes); }},
      {"shape", "", "class by Garcia et al.",
       [](const Row& row) { return garcia_class(row.axes); }},
      {"points", "", "number of points of the scan on the block",
       [](const Row& row) { return std::uint64_t{row.points}; }},
      {"visible_fraction", "", "fraction of the surface that the scan shows",
       [](const Row& row) { return row.visible_fraction; }},
      {"confidence", "", "probability that the outline is that of one block; 1 if it was accepted",
       [](const Row& row) { return row.confidence; }},
      {"trend_deg", "degrees", "direction of the lower end of L in plan, clockwise from north (+y)",
       [](const Row& row) { return kDegreesPerRadian * axis_orientation(row.long_axis).trend; }},
      {"plunge_deg", "degrees", "angle of L below the horizontal",
       [](const Row& row) { return kDegreesPerRadian * axis_orientation(row.long_axis).plunge; }}};
  return columns;
}

const TableColumns<DepositMapPart>& left_out_columns() {
  using Row = DepositMapPart;
  static const TableColumns<Row> columns = {
      {"reason", "", "reason why it is no block", [](const Row& row) { return row.reason; }},
      {"points", "", "number of its points",
       [](const Row& row) { return std::uint64_t{row.points}; }}};
  return columns;
}

std::vector<LayerStyle> make_deposit_styles() {
  QmlCategories outlines("CASE WHEN \"confidence\" < " + format_decimals(kUncertain, 1) +
                         " THEN 'uncertain outline' ELSE \"shape\" END");
  QmlCategories centres("shape");
  for (const char* shape : {"compact", "elongated"}) {
    const std::string colour = class_colour(shape);
    outlines.add(shape, format_qml_fill(outlines.next(), translucent(colour), colour, 0.3));
    centres.add(shape, format_qml_marker(centres.next(), {"", "circle"}, colour, "#ffffff", 0.16));
  }
  outlines.add("uncertain outline", format_qml_fill(outlines.next(), translucent(kUncertainColour),
                                                    kUncertainColour, 0.5));
  const std::string parts =
      format_qml_single_symbol(format_qml_marker(0, {"", "cross2"}, "#555555", "#555555", 0.4));
  return {{"outlines", format_qml(outlines.renderer(), format_qml_labels("block", 7, {}))},
          {"centres", format_qml(centres.renderer())},
          {"left_out", format_qml(parts)}};
}

}  // namespace clast::report_detail
