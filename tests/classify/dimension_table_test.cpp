#include "classify/dimension_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

class Tables : public testing::Test {
 protected:
  DimensionTable read(const std::string& text, const DimensionColumns& columns = {}) {
    const auto path = folder_ / "dims.csv";
    write_text_file(path, text);
    return read_dimension_table(path, columns);
  }
  std::string refusal(const std::string& text, const DimensionColumns& columns = {}) {
    return clast::refusal([&] { read(text, columns); });
  }

  ScratchFolder folder_;
};

void expect_axes(const MeasuredBlock& block, double L, double I, double S) {
  EXPECT_NEAR(block.axes.L, L, 1e-15);
  EXPECT_NEAR(block.axes.I, I, 1e-15);
  EXPECT_NEAR(block.axes.S, S, 1e-15);
}

TEST_F(Tables, EverySeparatorGivesTheSameBlocks) {
  for (const char* text :
       {"id,L,I,S\nB1,1.5,1.2,0.5\nB2,0.9,0.8,0.7\n", "id;L;I;S\nB1;1.5;1.2;0.5\nB2;0.9;0.8;0.7",
        "id\tL\tI\tS\nB1\t1.5\t1.2\t0.5\nB2\t0.9\t0.8\t0.7\n",
        "id L  I   S\n B1 1.5 1.2 0.5\nB2\t0.9 0.8 0.7\n",
        "id;L;I;S\r\nB1;1,5;1,2;0,5\r\nB2;0,9;0,8;0,7\r\n",
        "\xef\xbb\xbf# taped in May\n\n\"id\",\"L\",\"I\",\"S\"\n"
        "\"B1\",\"1.5\",1.2,+0.5\nB2,9e-1,0.8,0.7\n"}) {
    const DimensionTable table = read(text);
    ASSERT_EQ(table.blocks.size(), 2u) << text;
    EXPECT_TRUE(table.notes.empty()) << text;
    EXPECT_EQ(table.blocks[0].name, "B1");
    expect_axes(table.blocks[0], 1.5, 1.2, 0.5);
    EXPECT_EQ(table.blocks[1].name, "B2");
    expect_axes(table.blocks[1], 0.9, 0.8, 0.7);
  }
}

TEST_F(Tables, ColumnNamesIgnoreCaseAndUnits) {
  for (const char* header :
       {"L_m,I_m,S_m", "l (m),i (m),s (m)", "L [m],I [m],S [m]", "L m,I m,S m"}) {
    const DimensionTable table = read(std::string(header) + "\n3,2,1\n");
    expect_axes(table.blocks.at(0), 3, 2, 1);
    EXPECT_EQ(table.blocks.at(0).name, "row 2");
    EXPECT_TRUE(table.notes.empty());
  }
}

// Words of the field in five languages, with units and quotes, whatever separates the columns.
TEST_F(Tables, WordsForTheAxesCountWhereNoColumnHasTheirLetter) {
  const std::vector<std::array<const char*, 4>> names = {
      {"id", "Length", "Width", "Height"},
      {"block", "Long axis", "Intermediate axis", "Short axis"},
      {"name", "a-axis", "b-axis", "c-axis"},
      {"id", "a", "b", "c"},
      {"id", "Longest", "Intermediate", "Shortest"},
      {"id", "Length", "Breadth", "Thickness"},
      {"Block", "L\xC3\xA4nge", "Breite", "H\xC3\xB6he"},
      {"Block", "Laenge", "Breite", "Dicke"},
      {"Bloc", "Longueur", "Largeur", "\xC3\x89paisseur"},
      {"Bloc", "longueur", "largeur", "hauteur"},
      {"Blocco", "Lunghezza", "Larghezza", "Spessore"},
      {"Blocco", "Lunghezza", "Larghezza", "Altezza"},
      {"Bloque", "Largo", "Ancho", "Espesor"},
      {"Bloque", "Longitud", "Anchura", "Altura"}};
  for (const auto& each : names) {
    if (std::string(each[2]) == "Breadth") continue;
    for (const char separator : {',', ';', '\t'}) {
      for (const char* unit : {" (cm)", " [cm]", "_cm", " cm"}) {
        std::string text = each[0];
        for (std::size_t k = 1; k < 4; ++k) text += separator + std::string(each[k]) + unit;
        text += "\n";
        for (const char* cell : {"B1", "120", "80", "60"}) {
          text += cell + std::string(1, std::string(cell) == "60" ? '\n' : separator);
        }
        SCOPED_TRACE(text);
        const DimensionTable table = read(text);
        ASSERT_EQ(table.blocks.size(), 1u);
        expect_axes(table.blocks[0], 1.2, 0.8, 0.6);
        EXPECT_TRUE(contains(table.notes.front(), "L, I and S were read from the columns \""));
      }
    }
  }
  EXPECT_TRUE(contains(refusal("id,Length,Breadth,Thickness\nB1,3,2,1\n"),
                       "no column \"I\"; the header has"));
  EXPECT_TRUE(contains(refusal("id,a,Length,b,c\nB1,3,3,2,1\n"), "2 columns are called \"L\""));
}

// The rows of a table end with its means, sums and deviations.
TEST_F(Tables, RowsThatSumUpTheOthersAreSkippedAndNoted) {
  const char* labels[] = {"Mean",
                          "Average",
                          "Total",
                          "Sum",
                          "Median",
                          "Std. dev.",
                          "Max",
                          "Mittel",
                          "Mittelwert",
                          "Summe",
                          "Stabw.",
                          "Moyenne",
                          "\xC3\x89"
                          "cart-type",
                          "Somme",
                          "Media",
                          "Totale",
                          "Somma",
                          "Dev. st.",
                          "Promedio",
                          "Suma",
                          "M\xC3\xA1ximo",
                          "Desv. est.",
                          "Mean (n=3)",
                          "MEAN:"};
  for (const char* label : labels) {
    for (const char* second : {"", "SD,60,32,25\n", "n,3,3,3\n", "Min,95,70,40\n"}) {
      const DimensionTable table = read(
          std::string("Block,L (cm),I (cm),S (cm)\nB1,120,80,60\nB2,95,70,40\nB3,210,130,90\n\n") +
          label + ",142,93,63\n" + second);
      EXPECT_EQ(table.blocks.size(), 3u) << label << second;
      EXPECT_EQ(table.skipped_rows, *second ? 2u : 1u) << label << second;
      EXPECT_TRUE(contains(table.notes.at(1),
                           "row 6 skipped: \"" + std::string(label) + "\" is a sum of other rows"));
    }
  }
  const DimensionTable nameless =
      read("rock,L,I,S\ngneiss,3,2,1\ngneiss,4,2,1\nMean,3.5,2,1\nSD,0.5,0,0\n");
  EXPECT_EQ(nameless.blocks.size(), 2u);
  // The label may stand beside an empty name.
  const DimensionTable beside = read("site,block,L,I,S\nA,B1,3,2,1\nA,B2,4,2,1\nMean,,3.5,2,1\n");
  EXPECT_EQ(beside.blocks.size(), 2u);
}

TEST_F(Tables, WordsThatOnlyLookLikeLabelsStay) {
  EXPECT_EQ(read("block,L,I,S\nSD,3,2,1\nN,4,2,1\nSE,4,3,1\n").blocks.size(), 3u)
      << "names of blocks";
  EXPECT_EQ(read("weathering,L,I,S\nmedia,3,2,1\nmedia,4,2,1\nalta,4,3,1\n").blocks.size(), 3u);
  EXPECT_EQ(
      read("block,weathering,L,I,S\nB1,media,3,2,1\nB2,alta,4,2,1\nB3,alta,4,3,1\n").blocks.size(),
      3u);
}

TEST_F(Tables, NamelessRowsThatAreTheMeanOrSumAreNoted) {
  const std::string rows = "L,I,S\n1.20,0.80,0.60\n0.95,0.70,0.40\n2.10,1.30,0.90\n";
  for (const auto& [row, what] :
       {std::pair("1.417,0.933,0.633\n", "mean"), {"4.25,2.80,1.90\n", "sum"}}) {
    const DimensionTable table = read(rows + row);
    EXPECT_EQ(table.blocks.size(), 4u);
    EXPECT_TRUE(
        contains(table.notes.back(), "row 5 is the " + std::string(what) + " of the rows above"));
  }
  EXPECT_TRUE(read(rows + "1.5,0.9,0.7\n").notes.empty());
  EXPECT_TRUE(read("L,I,S\n1,0.8,0.6\n1,0.8,0.6\n1,0.8,0.6\n1,0.8,0.6\n").notes.empty())
      << "bricks";
}

TEST_F(Tables, UnitOfTheTableIsApplied) {
  expect_axes(read("L,I,S\n300,200,100\n", {.units = 0.01}).blocks.at(0), 3, 2, 1);
  expect_axes(read("L_cm,I_cm,S_cm\n300,200,100\n", {.units = 0.01}).blocks.at(0), 3, 2, 1);
  // Without a unit asked for, the header's is used and noted.
  const DimensionTable named = read("L_cm,I_cm,S_cm\n300,200,100\n");
  expect_axes(named.blocks.at(0), 3, 2, 1);
  ASSERT_EQ(named.notes.size(), 1u);
  EXPECT_TRUE(contains(named.notes[0], "cm"));
  // One that is not the header's is obeyed, and noted too.
  const DimensionTable other = read("L_cm,I_cm,S_cm\n300,200,100\n", {.units = 0.001});
  expect_axes(other.blocks.at(0), 0.3, 0.2, 0.1);
  ASSERT_EQ(other.notes.size(), 1u);
  EXPECT_TRUE(contains(other.notes[0], "cm") && contains(other.notes[0], "0.001"));
  for (const char* micron : {"um", "\xC2\xB5m", "\xCE\xBCm"}) {
    const std::string unit = std::string(" (") + micron + ")";
    const auto block =
        read("L" + unit + ",I" + unit + ",S" + unit + "\n300,200,100\n").blocks.at(0);
    EXPECT_NEAR(block.axes.L, 3e-4, 1e-18);
    EXPECT_EQ(block.axes_in_table_unit.L, 300.0);
  }
  EXPECT_TRUE(contains(refusal("L_cm,I_cm,S_mm\n3,2,1\n"), "different units"));
}

// 0.42/0.6 in any unit: ratios are of the numbers as they were written.
TEST_F(Tables, RatiosCarryNoRoundingOfTheUnit) {
  const auto block = read("L,I,S\n1,3,0.7\n", {.units = 1e-6}).blocks.at(0);
  EXPECT_EQ(block.axes_in_table_unit.S / block.axes_in_table_unit.I, 0.7);
  EXPECT_EQ(block.axes_in_table_unit.I / block.axes_in_table_unit.L, 1.0 / 3.0);
}

TEST_F(Tables, MassesAreReadWhereThereIsAColumn) {
  const DimensionTable kilograms = read("L,I,S,mass_kg\n3,2,1,450\n3,2,1,\n3,2,1,-4\n");
  ASSERT_EQ(kilograms.blocks.size(), 3u);
  EXPECT_EQ(kilograms.blocks[0].mass, 450.0);
  EXPECT_FALSE(kilograms.blocks[1].mass || kilograms.blocks[2].mass);
  EXPECT_EQ(kilograms.blocks_without_mass, 2u);
  ASSERT_EQ(kilograms.notes.size(), 2u);
  EXPECT_TRUE(contains(kilograms.notes[0], "row 3: mass is missing"));
  EXPECT_TRUE(contains(kilograms.notes[1], "row 4: mass = -4"));
  EXPECT_NEAR(*read("L,I,S,Mass (t)\n3,2,1,1.5\n").blocks.at(0).mass, 1500.0, 1e-12);
  EXPECT_NEAR(*read("L,I,S,weight [g]\n3,2,1,15\n", {.mass = "Weight"}).blocks.at(0).mass, 0.015,
              1e-15);
  EXPECT_EQ(*read("9 8 3 2 1\n", {.L = "3", .I = "4", .S = "5", .mass = "2"}).blocks.at(0).mass,
            8.0);
  EXPECT_TRUE(contains(refusal("L,I,S\n3,2,1\n", {.mass = "kg"}), "\"kg\""));
}

TEST_F(Tables, NamesComeFromTheColumnAskedFor) {
  EXPECT_EQ(read("Particle ID,L,I,S\n17,3,2,1\n", {.name = "particle id"}).blocks.at(0).name, "17");
  EXPECT_EQ(read("17 3 2 1\n", {.L = "2", .I = "3", .S = "4", .name = "1"}).blocks.at(0).name,
            "17");
}

TEST_F(Tables, WhatExcelWritesIsRead) {
  // Separator line, a heading over two lines, decimal commas, Windows line ends, empty rows at the
  // end.
  const DimensionTable table = read(
      "\xef\xbb\xbfsep=;\r\nid;\"L\r\n(cm)\";I (cm);S (cm);remark\r\n\"B "
      "\"\"7\"\"\";65,5;53;38;\"wet; "
      "mossy\"\r\nB8;70;60;\"50\";\r\n;;;;\r\n;;;;\r\n");
  ASSERT_EQ(table.blocks.size(), 2u);
  EXPECT_EQ(table.blocks[0].name, "B \"7\"");
  expect_axes(table.blocks[0], 0.655, 0.53, 0.38);
  expect_axes(table.blocks[1], 0.7, 0.6, 0.5);
  EXPECT_EQ(table.skipped_rows, 0u);
  // Line numbers count the lines of the file, that of the heading and old Macintosh ends too.
  const DimensionTable bad = read("id;\"L\n(m)\";I;S\nB1;1;1;0\nB2;3;2;1\n");
  EXPECT_TRUE(contains(bad.notes.back(), "row 3 skipped"));
  EXPECT_TRUE(contains(read("L,I,S\r3,2,1\r3,2,x\r").notes.at(0), "row 3 skipped"));
  // Blanks between, commas within.
  expect_axes(read("1,5 1,2 0,5\n0,9 0,8 0,7\n", {.L = "1", .I = "2", .S = "3"}).blocks.at(0), 1.5,
              1.2, 0.5);
  expect_axes(read("1, 2, 3\n", {.L = "3", .I = "2", .S = "1"}).blocks.at(0), 3, 2, 1);
}

TEST_F(Tables, WhatIsNoTextTableIsRefused) {
  EXPECT_TRUE(contains(refusal(std::string("PK\x03\x04\x14\0\0", 7)), "workbook"));
  EXPECT_TRUE(contains(refusal(std::string("\xff\xfeL\0,\0I\0", 8)), "UTF-16"));
  EXPECT_TRUE(contains(refusal(std::string("L,I,S\n\0\0\0", 9)), "no text"));
  EXPECT_TRUE(contains(refusal("L,I,S\n3,\"2,1\n3,2,1\n"), "row 2"));
}

TEST_F(Tables, CountsSayHowManyRowsWereLeftOutOrSorted) {
  const DimensionTable table = read("L,I,S\n3,2,1\n1,2,3\n0,2,1\nnan,2,1\n2,3,1\n");
  EXPECT_EQ(table.blocks.size(), 3u);
  EXPECT_EQ(table.skipped_rows, 2u);
  EXPECT_EQ(table.reordered_rows, 2u);
}

TEST_F(Tables, ColumnsByNumberNeedNoHeader) {
  const DimensionColumns columns{.L = "5", .I = "6", .S = "7"};
  const DimensionTable bare = read("1 2 3 4 0.9 0.8 0.7\n", columns);
  expect_axes(bare.blocks.at(0), 0.9, 0.8, 0.7);
  EXPECT_EQ(bare.blocks.at(0).name, "row 1");
  const DimensionTable headed = read("a b c d e f g\n1 2 3 4 0.9 0.8 0.7\n", columns);
  ASSERT_EQ(headed.blocks.size(), 1u);
  expect_axes(headed.blocks[0], 0.9, 0.8, 0.7);
}

TEST_F(Tables, ColumnsByOtherNames) {
  const DimensionTable table = read("a,b,c\n3,2,1\n", {.L = "A", .I = "B", .S = "C"});
  expect_axes(table.blocks.at(0), 3, 2, 1);
}

TEST_F(Tables, BadRowsAreSkippedAndNoted) {
  const DimensionTable table = read(
      "name,L,I,S\nok,3,2,1\nzero,3,0,1\nminus,3,-2,1\ntext,3,two,1\nempty,3,,1\n"
      "tail,3,2,1x\nnan,nan,2,1\ninf,inf,2,1\nlast,6,5,4\n");
  ASSERT_EQ(table.blocks.size(), 2u);
  EXPECT_EQ(table.blocks[1].name, "last");
  ASSERT_EQ(table.notes.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NE(table.notes[i].find("row " + std::to_string(i + 3) + " skipped"), std::string::npos)
        << table.notes[i];
  }
}

// Rows that a program with decimal commas writes between commas, and rows cut short.
TEST_F(Tables, ARowOfAnotherLengthThanTheHeaderIsRefusedWithItsLine) {
  const std::string split = refusal("L,I,S\n0,9,0,8,0,7\n2,2,1\n");
  EXPECT_TRUE(
      contains(split, "dims.csv:2: has 6 fields, but line 1 has 3; where commas are decimal"))
      << split;
  EXPECT_TRUE(contains(refusal("id;L;I;S\nB1;3;2;1\nB2;3;2\n"), "dims.csv:3: has 3 fields"));
  EXPECT_TRUE(contains(refusal("L I S\nB1 3 2 1\n"), "dims.csv:2: has 4 fields"));
  EXPECT_TRUE(contains(refusal("1,2,3\n4,5\n", {.L = "3", .I = "2", .S = "1"}), "dims.csv:2: "));
  // In quotes they are one field, and still may be 1.234 or 1234.
  EXPECT_TRUE(contains(refusal("L,I,S\n\"1,5\",\"1,2\",\"0,8\"\n"),
                       "dims.csv:2: L \"1,5\": where commas are decimal signs, separate"));
  EXPECT_TRUE(contains(refusal("L,I,S,mass\n3,2,1,\"12,5\"\n"), "dims.csv:2: mass \"12,5\""));
}

// What `clast classify -o DIR` writes is a table of its own.
TEST_F(Tables, NamesThatASpreadsheetWouldRunComeBack) {
  CsvWriter csv;
  csv.write_header("block,L_m,I_m,S_m");
  const std::vector<std::string> names = {"=1+1", "@x", "-B7", "+A", "'=2", "B, \"8\""};
  for (const std::string& name : names) {
    csv.write_cell(name);
    for (const double axis : {3.0, 2.0, 1.0}) csv.write_cell(axis);
    csv.end_row();
  }
  const DimensionTable table = read(csv.take_text());
  ASSERT_EQ(table.blocks.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(table.blocks[i].name, names[i]);
}

TEST_F(Tables, AxesOutOfOrderAreSortedAndNoted) {
  const DimensionTable table = read("L,I,S\n1,2,3\n3,2,1\n");
  expect_axes(table.blocks.at(0), 3, 2, 1);
  ASSERT_EQ(table.notes.size(), 1u);
  EXPECT_NE(table.notes[0].find("row 2"), std::string::npos);
}

TEST_F(Tables, WhatCannotBeReadIsRefused) {
  EXPECT_THROW(read_dimension_table(folder_ / "missing.csv"), InputError);
  EXPECT_NE(refusal("").find("empty"), std::string::npos);
  EXPECT_NE(refusal("# only a remark\n\n").find("empty"), std::string::npos);
  const std::string no_column = refusal("size,width,S\n3,2,1\n");
  EXPECT_NE(no_column.find("\"L\""), std::string::npos) << no_column;
  EXPECT_NE(no_column.find("\"width\""), std::string::npos) << no_column;
  EXPECT_NE(refusal("3,2,1\n").find("1 to 3"), std::string::npos);
  EXPECT_NE(refusal("3,2,1\n", {.L = "1", .I = "2", .S = "9"}).find("\"9\""), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n").find("no usable row"), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n0,0,0\n").find("row 2"), std::string::npos);
  EXPECT_NE(refusal("L,I,S\n3,2,1\n", {.units = 0.0}).find("unit"), std::string::npos);
}

// As Excel saves a sheet with accents in western Europe.
TEST_F(Tables, TextThatIsNotUtf8IsTakenForWindows1252) {
  const DimensionTable table =
      read("nom;L (\xb5m);I (\xb5m);S (\xb5m)\r\nCh\xe2teau \x96 \xc9tang;3;2;1\r\n\xe9;1;0;1\r\n",
           {.name = "nom"});
  ASSERT_EQ(table.blocks.size(), 1u);
  EXPECT_EQ(table.blocks[0].name, "Ch\xc3\xa2teau \xe2\x80\x93 \xc3\x89tang");
  EXPECT_NEAR(table.blocks[0].axes.L, 3e-6, 1e-20);
  ASSERT_FALSE(table.notes.empty());
  EXPECT_TRUE(contains(table.notes[0], "Windows-1252"));
  // UTF-8 stays as it is, without a word.
  const DimensionTable utf8 = read("name,L,I,S\nCh\xc3\xa2teau,3,2,1\n");
  EXPECT_EQ(utf8.blocks[0].name, "Ch\xc3\xa2teau");
  EXPECT_TRUE(utf8.notes.empty());
}

TEST_F(Tables, AColumnIsOneQuantity) {
  EXPECT_TRUE(contains(refusal("3 2 1\n", {.L = "1", .I = "1", .S = "3"}), "L and as I"));
  EXPECT_TRUE(contains(refusal("L,I,S\n3,2,1\n", {.S = "L"}), "L and as S"));
  EXPECT_TRUE(contains(refusal("L,I,S\n3,2,1\n", {.mass = "2"}), "I and as mass"));
}

TEST_F(Tables, AColumnThatStandsTwiceIsAskedFor) {
  for (const char* header : {"L,I,S,l", "L_m,I,S,L (m)"}) {
    const std::string said = refusal(std::string(header) + "\n3,2,1,9\n");
    EXPECT_TRUE(contains(said, "\"L\"") && contains(said, "1, 4")) << said;
  }
  EXPECT_TRUE(contains(refusal("L,I,S,mass,Mass_kg,MASS\n3,2,1,9,9,9\n"), "mass"));
  expect_axes(read("L,I,S,L\n3,2,1,9\n", {.L = "4"}).blocks.at(0), 9, 2, 1);
  // A name to the letter is no question.
  expect_axes(read("L_m,L_tape,I,S\n3,9,2,1\n", {.L = "L_tape"}).blocks.at(0), 9, 2, 1);
  expect_axes(read("L_cm,I_cm,S_cm,L_m\n300,200,100,3\n", {.L = "L_cm"}).blocks.at(0), 3, 2, 1);
}

TEST_F(Tables, AxesThatNoBlockHasAreSkipped) {
  const DimensionTable table = read(
      "L,I,S,mass\n1e301,2,1,5\n3,2,1e-301,5\n1.1e9,1,1,5\n1,1,0.9e-9,5\n1e9,1,1e-9,5\n1,1,1,"
      "1e200\n");
  ASSERT_EQ(table.blocks.size(), 2u);
  EXPECT_EQ(table.skipped_rows, 4u);
  EXPECT_EQ(table.blocks_without_mass, 1u);
  for (const char* part :
       {"row 2 skipped: L = 1e301 is more than 1e+09 m",
        "row 5 skipped: S = 0.9e-9 is less than 1e-09 m", "row 7: mass = 1e200"}) {
    bool said = false;
    for (const std::string& note : table.notes) said = said || note.find(part) != note.npos;
    EXPECT_TRUE(said) << part;
  }
  // The range is of metres, whatever the unit.
  EXPECT_EQ(read("L,I,S\n2e12,2e12,2e12\n", {.units = 1e-6}).blocks.size(), 1u);
}

TEST_F(Tables, AUnitThatMakesHugeBlocksIsDoubted) {
  const std::string note = read("L,I,S\n90,70,50\n80,60,50\n").notes.at(0);
  EXPECT_TRUE(contains(note, "90 m") && contains(note, "(0.9 m in cm, 0.09 m in mm)") &&
              contains(note, "`units`"));
  EXPECT_TRUE(contains(read("L,I,S\n90,70,50\n", {.units = 1.0}).notes.at(0), "90 m"));
  EXPECT_TRUE(contains(read("L_m,I_m,S_m\n90,70,50\n").notes.at(0), "90 m"));
  EXPECT_TRUE(contains(read("L,I,S\n0.9,0.7,0.5\n0.9,0.7,0.5\n0.9,70,0.5\n").notes.at(0),
                       "1 block is longer than 50 m, up to 70 m"));
  EXPECT_TRUE(read("L,I,S\n90,70,50\n", {.units = 0.01}).notes.empty());
  EXPECT_TRUE(read("L,I,S\n50,40,30\n").notes.empty());
}

}  // namespace
}  // namespace clast
