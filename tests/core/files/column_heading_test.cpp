#include "core/files/column_heading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace clast {
namespace {

TEST(ColumnHeadings, NameWordsAndUnitAreTakenApart) {
  struct Case {
    const char* text;
    const char* name;
    std::vector<std::string> words;
    double metres;  ///< 0: no unit of length
  };
  const std::vector<Case> cases = {
      {"X", "x", {"x"}, 0},
      {"X (m)", "x", {"x"}, 1},
      {"x_m", "x", {"x"}, 1},
      {"L [cm]", "l", {"l"}, 0.01},
      {"L cm", "l", {"l"}, 0.01},
      {"Major axis (um)", "major axis", {"major"}, 1e-6},
      {"\"Y\"", "y", {"y"}, 0},
      {" Z , mm", "z", {"z"}, 0.001},
      {"Coord. X / ft", "coord. x", {"x"}, 0.3048},
      {"X in m", "x", {"x"}, 1},
      {"X (pieds)", "x", {"x"}, 0.3048},
      {"Y (')", "y", {"y"}, 0.3048},
      {"H\xC3\xB6he [Zoll]", "h\xC3\xB6he", {"hohe"}, 0.0254},
      {"Z [m \xC3\xBC.M.]", "z", {"z"}, 1},
      {"Kote Fuss", "kote fuss", {"kote", "fuss"}, 0},
      {"H\xC3\xB6he (m)", "h\xC3\xB6he", {"hohe"}, 1},
      {"H\xC3\x96HE", "h\xC3\x96he", {"hohe"}, 0},
      {"Ho\xCC\x88he", "ho\xCC\x88he", {"hohe"}, 0},  // an accent of its own
      {"\xC3\x89l\xC3\xA9vation", "\xC3\x89l\xC3\xA9vation", {"elevation"}, 0},
      {"PointID", "pointid", {"id"}, 0},
      {"POINT_X", "point_x", {"x"}, 0},
      {"X-Koordinate", "x-koordinate", {"x"}, 0},
      {"start_x_m", "start_x", {"start", "x"}, 1},
      {"Point", "point", {"point"}, 0},
      {"U:0", "u:0", {"u", "0"}, 0},
      {"m", "m", {"m"}, 0},
      {"", "", {}, 0}};
  for (const Case& each : cases) {
    const ColumnHeading heading = parse_heading(each.text);
    EXPECT_EQ(heading.name, each.name) << each.text;
    EXPECT_EQ(heading.words, each.words) << each.text;
    EXPECT_EQ(heading.length_unit ? heading.length_unit->factor : 0.0, each.metres) << each.text;
  }
  EXPECT_EQ(parse_heading("mass [t]").unit, "t");
  EXPECT_EQ(parse_heading("slope (deg)").unit, "deg");
}

TEST(SummaryLabels, AreKnownInFiveLanguages) {
  for (const char* text : {"Mean",
                           "mean",
                           "MEAN:",
                           "Mean (n = 12)",
                           "Average",
                           "Median",
                           "Total",
                           "Sum",
                           "Std. dev.",
                           "StDev",
                           "Standard deviation",
                           "Min",
                           "Max",
                           "Maximum",
                           "Count",
                           "Mittelwert",
                           "Mittel",
                           "Durchschnitt",
                           "Summe",
                           "Standardabweichung",
                           "Stabw.",
                           "Anzahl",
                           "Moyenne",
                           "M\xC3\xA9"
                           "diane",
                           "\xC3\x89"
                           "cart-type",
                           "Ecart type",
                           "Somme",
                           "Nombre",
                           "Media",
                           "Mediana",
                           "Totale",
                           "Somma",
                           "Deviazione standard",
                           "Dev. st.",
                           "Scarto",
                           "Promedio",
                           "Suma",
                           "Desviaci\xC3\xB3n est\xC3\xA1ndar",
                           "Desv. est.",
                           "M\xC3\xA1ximo",
                           "M\xC3\xADnimo",
                           "Massimo",
                           "Grand total",
                           "Median =",
                           "Variance"}) {
    EXPECT_EQ(detect_summary_row_label(text), SummaryRowLabel::kCertain) << text;
  }
  for (const char* text : {"\xE2\x88\x85", "\xC3\x98", "\xCF\x83", "25%", "75 %", "Overall mean",
                           "Coef. var.", "STDEV.S"}) {
    EXPECT_EQ(detect_summary_row_label(text), SummaryRowLabel::kCertain) << text;
  }
  for (const char* text : {"SD", "n", "N", "CV", "s.d.", "SE", "s"}) {
    EXPECT_EQ(detect_summary_row_label(text), SummaryRowLabel::kAmbiguous) << text;
  }
  for (const char* text : {"", "B1", "Max 3", "Meander", "Total station", "rock", "12", "-",
                           "Mean 2", "Minette", "Sum of all fears", "@SUM(A1)", "=SUM(A1)", "A"}) {
    EXPECT_EQ(detect_summary_row_label(text), SummaryRowLabel::kNone) << text;
  }
}

}  // namespace
}  // namespace clast
