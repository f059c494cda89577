// Scans of real stones, turned over in between: joined right, bracketed or refused.
//
// CLAST_JOIN_CASES is the number of cases of each kind, and CLAST_JOIN_KINDS names the kinds. Rows
// of the table CLAST_JOIN_TABLE are not computed again, so that an interrupted study continues.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "reconstruct/registration/registration.hpp"
#include "tests/reconstruct/join_study.hpp"
#include "tests/support/partial_scans.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

/// Rows of an earlier study by kind and number.
std::map<std::string, std::string> read_rows(const char* path) {
  std::map<std::string, std::string> rows;
  if (path == nullptr) return rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t end = line.find(',', line.find(',') + 1);
    rows[line.substr(0, end)] = line;
  }
  return rows;
}

std::string outcome_of(const std::string& line) {
  std::istringstream cells(line);
  std::string cell;
  for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
  return cell;
}

/// True if the study has a kind of cases: all kinds if none are named.
bool is_chosen(const std::string& kind) {
  const char* kinds = std::getenv("CLAST_JOIN_KINDS");
  if (kinds == nullptr) return true;
  return ("," + std::string(kinds) + ",").find("," + kind + ",") != std::string::npos;
}

TEST(JoinStudy, ScansAreJoinedRightOrRefusedAndNeverSilentlyWrong) {
  const char* cases = std::getenv("CLAST_JOIN_CASES");
  const char* table = std::getenv("CLAST_JOIN_TABLE");
  // Seeds of the figures; methods were tuned with others.
  constexpr std::uint64_t kBase = 700000;
  const std::map<std::string, std::string> known = read_rows(table);
  for (const JoinKind& kind : join_kinds()) {
    if (!is_chosen(kind.name)) continue;
    const std::size_t count = cases ? std::stoul(cases) : kind.quick_cases;
    std::map<std::string, std::size_t> outcomes;
    for (std::size_t number = 0; number < count; ++number) {
      const auto row = known.find(kind.name + "," + std::to_string(number));
      std::string line;
      if (row != known.end()) {
        line = row->second;
      } else {
        line = run_join_case(kind, number, kBase).text;
        if (table) std::ofstream(table, std::ios::app) << line << "\n";
      }
      ++outcomes[outcome_of(line)];
    }
    std::cout << kind.name << ":";
    for (const auto& [outcome, times] : outcomes) std::cout << "  " << outcome << " " << times;
    std::cout << std::endl;
    EXPECT_EQ(outcomes["wrong"], 0u) << kind.name;
    if (kind.name == "same") {
      EXPECT_GE(static_cast<double>(outcomes["right"] + outcomes["bracketed"]),
                std::floor(0.9 * static_cast<double>(count)));
    }
  }
}

TEST(FreeScale, IsEstimatedWithItsStandardError) {
  constexpr double kUnit = 0.31;
  Random random(16);
  const TriangleMesh rock = rock_mesh(12, {0.5, 0.4, 0.3}, 3);
  PartialScanRecipe recipe;
  recipe.points = 3000;
  recipe.ground_points = 0.0;
  ScanPair pair = make_scan_pair(PartialScanner(rock), recipe, recipe, 0.4, 0.8, random);
  for (Vec3& p : pair.second.points) p *= kUnit;
  RegistrationOptions options;
  options.free_scale = true;
  options.threads = 0;
  const Registration found =
      register_scans({{"top", pair.first.points}, {"bottom", pair.second.points}}, options);
  ASSERT_EQ(found.scales.size(), 1u);
  EXPECT_EQ(found.scales[0].scan, 1u);
  EXPECT_NEAR(found.scales[0].scale * kUnit, 1.0, 0.005);
  EXPECT_LT(std::abs(found.scales[0].scale - 1.0 / kUnit), 4.0 * found.scales[0].standard_error);
}

}  // namespace
}  // namespace clast
