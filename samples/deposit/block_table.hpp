#pragma once
/// Tables of blocks: true blocks, and the bodies that a program states.
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/table.hpp"
#include "samples/deposit/deposit.hpp"

namespace clast {

/// Name of the table of true blocks in the folder of a deposit.
inline constexpr const char* kTrueBlocksFile = "blocks.csv";

/// Columns of blocks.csv.
const TableColumns<TrueBlock>& true_block_columns();

/// Table with a heading, column by column.
class HeadedTable {
 public:
  /// @throws InputError  if the file is missing or not a table, or has no heading
  explicit HeadedTable(const std::filesystem::path& path);

  std::size_t row_count() const { return rows_.size(); }
  bool has(const std::string& column) const;
  /// @throws InputError  if there is no such column; the message names those that exist
  std::string text(std::size_t row, const std::string& column) const;
  /// Returns a number; NaN if the cell is empty.
  /// @throws InputError  as `text`, or if the cell is neither empty nor a number
  double number(std::size_t row, const std::string& column) const;

 private:
  std::size_t index_of(const std::string& column) const;

  std::string file_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace clast
