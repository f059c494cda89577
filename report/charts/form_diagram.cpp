#include "report/charts/form_diagram.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "classify/certainty.hpp"
#include "report/charts/marks.hpp"
#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr double kDiagramWidth = 520.0;
constexpr const char* kDiagramText = "font-size=\"12\" fill=\"#33404d\"";
constexpr const char* kDiagramHalo =
    " fill=\"#1d2733\" text-anchor=\"middle\" stroke=\"#fff\" stroke-width=\"3.5\" "
    "stroke-opacity=\".9\" paint-order=\"stroke\" pointer-events=\"none\"";

/// The area of a class on the picture, px.
struct Field {
  std::string name;
  std::vector<Vec2> corners;
  Vec2 label;
};

const ClassFraction& share_of(const std::vector<ClassFraction>& shares, const std::string& name) {
  return *std::find_if(shares.begin(), shares.end(),
                       [&](const ClassFraction& share) { return share.name == name; });
}

/// Outlines, darker where more blocks are; a class without a block keeps its outline.
std::string fields_svg(const std::vector<Field>& fields, const std::vector<ClassFraction>& shares) {
  double largest = 1e-9;
  for (const ClassFraction& share : shares) largest = std::max(largest, share.fraction);
  std::string svg;
  for (const Field& field : fields) {
    const ClassFraction& share = share_of(shares, field.name);
    std::string points;
    for (const Vec2& corner : field.corners) {
      points += format_fixed(corner.x(), 1) + "," + format_fixed(corner.y(), 1) + " ";
    }
    svg += "<polygon points=\"" + points + "\" fill=\"" + kDataColours[5] + "\" fill-opacity=\"" +
           format_fixed(0.45 * share.fraction / largest, 3) + "\" stroke=\"#5b6775\"><title>" +
           escape_html(field.name + ": " + std::to_string(share.count) + " blocks, " +
                       format_percent(share.fraction) + " (95 % interval " +
                       format_percent(share.low) + " to " + format_percent(share.high) + ")") +
           "</title></polygon>\n";
  }
  return svg;
}

std::string labels_svg(const std::vector<Field>& fields, const std::vector<ClassFraction>& shares) {
  std::string svg;
  for (const Field& field : fields) {
    const ClassFraction& share = share_of(shares, field.name);
    svg += svg_text(field.label.x(), field.label.y() - 2, field.name,
                    std::string("font-size=\"13\" font-weight=\"700\"") + kDiagramHalo);
    svg += svg_text(field.label.x(), field.label.y() + 12,
                    share.count > 0 ? format_percent(share.fraction) : std::string("0"),
                    std::string("font-size=\"11\"") + kDiagramHalo);
  }
  return svg;
}

template <class Place>
std::string blocks_svg(const Population& population, std::size_t number,
                       const PopulationOptions& options, const Vec2& corner, Place place_of) {
  std::vector<Vec2> places;
  places.reserve(population.blocks.size());
  for (const MeasuredBlock& block : population.blocks)
    places.push_back(place_of(block.axes_in_table_unit));
  if (places.size() > kMaxSingleBlocks) return draw_density_squares(places, corner, "blocks");
  std::string svg;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const MeasuredBlock& block = population.blocks[i];
    svg += draw_shape_mark(
               places[i].x(), places[i].y(), garcia_class(block.axes_in_table_unit), true,
               "class=\"block\" data-block=\"" + block_highlight_attribute(number, i) + "\"",
               format_block_tooltip(block, options)) +
           "\n";
  }
  return svg;
}

/// Draws the key of the marks, centred at the bottom of the image.
std::string mark_key(const Population& population, double y) {
  if (population.blocks.size() > kMaxSingleBlocks) {
    std::string svg;
    double x = 108.0;
    svg += svg_text(x - 8, y + 4, "few", std::string(kDiagramText) + " text-anchor=\"end\"");
    for (const char* colour : kDensityColours) {
      svg += "<rect x=\"" + format_fixed(x, 1) + "\" y=\"" + format_fixed(y - 6, 1) +
             "\" width=\"18\" height=\"12\" fill=\"" + colour + "\"/>";
      x += 18.0;
    }
    return svg + svg_text(x + 8, y + 4,
                          "many of " + std::to_string(population.blocks.size()) +
                              " blocks per square (7 px)",
                          kDiagramText);
  }
  return draw_shape_mark(110, y, "compact", true, "", "") +
         svg_text(120, y + 4, "compact, s_c \xE2\x89\xA4 0.3", kDiagramText) +
         draw_shape_mark(280, y, "elongated", true, "", "") +
         svg_text(290, y + 4, "elongated, s_c > 0.3", kDiagramText);
}

std::string opened(const std::string& title, double height) {
  return open_svg(kDiagramWidth, height, title) +
         svg_text(16, 18, title, "font-size=\"14\" font-weight=\"600\" fill=\"#1d2733\"");
}

std::string title_with_count(const std::string& what, const Population& population) {
  constexpr std::size_t kMaxCharacters = 28;
  return what + ": " + shorten_text(population.name, kMaxCharacters) + " (" +
         std::to_string(population.blocks.size()) + ")";
}

/// Geometry of the triangle.
constexpr double kDiagramSide = 400.0, kDiagramLeft = 60.0, kApex = 44.0;
const double kDiagramHeight = kDiagramSide * std::sqrt(3.0) / 2.0;

Vec2 on_triangle(double q, double d) {
  return {kDiagramLeft + kDiagramSide * ((1.0 - q) * d + 0.5 * q),
          kApex + kDiagramHeight * (1.0 - q)};
}

// Limits of the classes, as drawn by Sneed and Folk.
constexpr std::array<double, 5> kLimitsQ = {1.0, 0.7, 0.5, 0.3, 0.0};
std::array<double, 4> limits_d(const SchemeOptions& limits) {
  if (limits.sneed_folk_thirds) return {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0};
  return {0.0, 0.33, 0.67, 1.0};
}

std::vector<Field> triangle_fields(const std::array<double, 4>& limits) {
  std::vector<Field> fields = {{"C",
                                {on_triangle(1, 0), on_triangle(0.7, 0), on_triangle(0.7, 1)},
                                on_triangle(0.785, 0.5)}};
  const std::array<const char*, 3> before = {"C", "", "V"}, after = {"P", "B", "E"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double high = kLimitsQ[i + 1], low = kLimitsQ[i + 2];
    for (std::size_t k = 0; k < 3; ++k) {
      const double left = limits[k], right = limits[k + 1];
      fields.push_back({std::string(before[i]) + after[k],
                        {on_triangle(high, left), on_triangle(high, right), on_triangle(low, right),
                         on_triangle(low, left)},
                        on_triangle(0.5 * (high + low), 0.5 * (left + right))});
    }
  }
  return fields;
}

}  // namespace

std::string block_highlight_attribute(std::size_t number, std::size_t block) {
  return std::to_string(number) + "-" + std::to_string(block);
}

std::string format_block_tooltip(const MeasuredBlock& block, const PopulationOptions& options) {
  const Axes& axes = block.axes;
  std::string title = block.name + "\nL " + format_significant_digits(axes.L, 3) + ", I " +
                      format_significant_digits(axes.I, 3) + ", S " +
                      format_significant_digits(axes.S, 3) +
                      (block.unscaled ? " u (model units)" : " m");
  if (block.mass) title += ", " + format_significant_digits(*block.mass, 4) + " kg";
  title += "\ns_c " + format_fixed(elongation_index(block.axes_in_table_unit), 2);
  for (const std::string& scheme : options.selected_schemes()) {
    const ClassCertainty certainty =
        assess_class_certainty(scheme, axes, block.axis_error, options.limits);
    title += "\n" + scheme + ": " + shape_class(scheme, block.axes_in_table_unit, options.limits);
    if (certainty.near_limit) title += " (" + describe_certainty(certainty) + ")";
  }
  return title;
}

std::string draw_sneed_folk_diagram(const Population& population, std::size_t number,
                                    const PopulationOptions& options) {
  const std::vector<ClassFraction> shares =
      class_fractions(axes_for_ratios(population), "sneed-folk", options.limits);
  const std::array<double, 4> limits = limits_d(options.limits);
  const std::vector<Field> fields = triangle_fields(limits);
  const double base = kApex + kDiagramHeight;
  std::string svg = opened(title_with_count("Sneed and Folk (1958)", population), base + 78) +
                    fields_svg(fields, shares);
  for (const double q : {0.3, 0.5, 0.7}) {
    const Vec2 at = on_triangle(q, 0.0);
    svg += svg_text(at.x() - 8, at.y() + 4, format_fixed(q, 1),
                    std::string(kDiagramText) + " text-anchor=\"end\"");
  }
  for (const double d : {limits[1], limits[2]}) {
    svg += svg_text(on_triangle(0.0, d).x(), base + 16, format_fixed(d, 2),
                    std::string(kDiagramText) + " text-anchor=\"middle\"");
  }
  const Vec2 side = on_triangle(0.6, 0.0);
  svg += "<text x=\"0\" y=\"0\" transform=\"translate(" + format_fixed(side.x() - 42, 1) + " " +
         format_fixed(side.y(), 1) + ") rotate(-60)\" text-anchor=\"middle\" " + kDiagramText +
         ">S/L</text>";
  svg += svg_text(kDiagramLeft + 0.5 * kDiagramSide, base + 34,
                  "(L \xE2\x88\x92 I)/(L \xE2\x88\x92 S)",
                  std::string(kDiagramText) + " text-anchor=\"middle\"");
  svg += svg_text(kDiagramLeft + 0.5 * kDiagramSide, kApex - 8, "compact",
                  std::string(kDiagramText) + " font-weight=\"600\" text-anchor=\"middle\"");
  svg += svg_text(kDiagramLeft - 6, base + 22, "platy",
                  std::string(kDiagramText) + " font-weight=\"600\" text-anchor=\"middle\"");
  svg += svg_text(kDiagramLeft + kDiagramSide + 6, base + 22, "elongated",
                  std::string(kDiagramText) + " font-weight=\"600\" text-anchor=\"middle\"");
  svg += blocks_svg(population, number, options, {kDiagramLeft, kApex}, [](const Axes& axes) {
    return on_triangle(axes.S / axes.L, disc_rod_index(axes).value_or(0.0));
  });
  return svg + labels_svg(fields, shares) + mark_key(population, base + 62) + "</svg>\n";
}

std::string draw_zingg_diagram(const Population& population, std::size_t number,
                               const PopulationOptions& options) {
  constexpr double kSize = 380.0, kX = 84.0, kTop = 36.0, kLimit = 2.0 / 3.0;
  const auto on_square = [](double flat, double long_) {
    return Vec2(kX + kSize * flat, kTop + kSize * (1.0 - long_));
  };
  const std::vector<ClassFraction> shares = class_fractions(axes_for_ratios(population), "zingg");
  std::vector<Field> fields;
  const auto add_field = [&](const char* name, double x0, double x1, double y0, double y1) {
    fields.push_back({name,
                      {on_square(x0, y0), on_square(x1, y0), on_square(x1, y1), on_square(x0, y1)},
                      on_square(0.5 * (x0 + x1), 0.5 * (y0 + y1))});
  };
  add_field("disc", 0, kLimit, kLimit, 1);
  add_field("spheroid", kLimit, 1, kLimit, 1);
  add_field("blade", 0, kLimit, 0, kLimit);
  add_field("rod", kLimit, 1, 0, kLimit);
  const double bottom = kTop + kSize;
  std::string svg = opened(title_with_count("Zingg (1935)", population), bottom + 78) +
                    fields_svg(fields, shares);
  for (int k = 0; k <= 5; ++k) {
    const double value = 0.2 * k;
    const Vec2 x = on_square(value, 0.0), y = on_square(0.0, value);
    svg += format_svg_line(x.x(), bottom, x.x(), bottom + 5, "stroke=\"#5b6775\"") +
           format_svg_line(kX - 5, y.y(), kX, y.y(), "stroke=\"#5b6775\"") +
           svg_text(x.x(), bottom + 18, format_fixed(value, 1),
                    std::string(kDiagramText) + " text-anchor=\"middle\"") +
           svg_text(kX - 9, y.y() + 4, format_fixed(value, 1),
                    std::string(kDiagramText) + " text-anchor=\"end\"");
  }
  svg += svg_text(kX + 0.5 * kSize, bottom + 36, "S/I (limit 2/3)",
                  std::string(kDiagramText) + " text-anchor=\"middle\"");
  svg += "<text x=\"0\" y=\"0\" transform=\"translate(" + format_fixed(kX - 42, 1) + " " +
         format_fixed(kTop + 0.5 * kSize, 1) + ") rotate(-90)\" text-anchor=\"middle\" " +
         kDiagramText + ">I/L (limit 2/3)</text>";
  svg += blocks_svg(population, number, options, {kX, kTop},
                    [&](const Axes& axes) { return on_square(axes.S / axes.I, axes.I / axes.L); });
  return svg + labels_svg(fields, shares) + mark_key(population, bottom + 62) + "</svg>\n";
}

}  // namespace clast::report_detail
