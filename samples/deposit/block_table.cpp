#include "samples/deposit/block_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/files/delimited_text.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"

namespace clast {

const TableColumns<TrueBlock>& true_block_columns() {
  using Block = TrueBlock;
  static const TableColumns<Block> kColumns = concatenated_columns<Block>(
      {{{"block", "", "number of the block in truth.ply, from 1",
         [](const Block& b) { return std::uint64_t{b.block}; }}},
       array_columns<Block>({"x_m", "y_m", "z_m"}, "m", "centroid of the body", &Block::centre),
       array_columns<Block>({"L_m", "I_m", "S_m"}, "m", "sides of its smallest box", &Block::axes),
       {{"volume_m3", "m^3", "volume", [](const Block& b) { return b.volume; }},
        {"visible_fraction", "", "fraction of its surface that was seen",
         [](const Block& b) { return b.visible_fraction; }},
        {"points", "", "number of its points",
         [](const Block& b) { return std::uint64_t{b.points}; }},
        {"eligible", "", "1 if it counts for precision and recall",
         [](const Block& b) { return std::uint64_t{b.is_eligible() ? 1u : 0u}; }},
        {"class", "", "Sneed-Folk class",
         [](const Block& b) {
           return sneed_folk_class({b.axes[0], b.axes[1], b.axes[2]});
         }},
        {"shape", "", "kind of shape, or the name of the scan from which it was made",
         [](const Block& b) { return b.shape; }}}});
  return kColumns;
}

HeadedTable::HeadedTable(const std::filesystem::path& path) : file_(path.string()) {
  const DecodedText content = decode_table_text(read_text_file(path), file_);
  DelimitedTextReader reader(content.text, file_);
  Record record;
  while (reader.read_record(record)) {
    std::vector<std::string> fields(record.fields.begin(), record.fields.end());
    if (columns_.empty()) {
      columns_ = std::move(fields);
    } else {
      rows_.push_back(std::move(fields));
    }
  }
  if (columns_.empty()) throw InputError(file_ + " is empty; it must begin with a heading");
}

bool HeadedTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t HeadedTable::index_of(const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
  std::string known;
  for (const std::string& name : columns_) known += (known.empty() ? "" : ", ") + name;
  throw InputError(file_ + " has no column \"" + column + "\"; it has " + known);
}

std::string HeadedTable::text(std::size_t row, const std::string& column) const {
  return rows_[row][index_of(column)];
}

double HeadedTable::number(std::size_t row, const std::string& column) const {
  const std::string cell = text(row, column);
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (const std::optional<double> value = parse_number(cell)) return *value;
  throw InputError(file_ + ", row " + std::to_string(row + 1) + ", column " + column + ": \"" +
                   cell + "\" is not a number");
}

std::vector<TrueBlock> read_true_blocks(const std::filesystem::path& folder) {
  const HeadedTable table(folder / kTrueBlocksFile);
  std::vector<TrueBlock> blocks;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    TrueBlock block;
    block.block = static_cast<std::size_t>(table.number(row, "block"));
    block.shape = table.text(row, "shape");
    block.centre = {table.number(row, "x_m"), table.number(row, "y_m"), table.number(row, "z_m")};
    block.axes = {table.number(row, "L_m"), table.number(row, "I_m"), table.number(row, "S_m")};
    block.volume = table.number(row, "volume_m3");
    block.visible_fraction = table.number(row, "visible_fraction");
    block.points = static_cast<std::size_t>(table.number(row, "points"));
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace clast
