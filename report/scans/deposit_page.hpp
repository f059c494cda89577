#pragma once
/// Page of a deposit, on which its segmentation is looked at and corrected.
#include <string>
#include <vector>

#include "library/block.hpp"
#include "reconstruct/field_scan.hpp"
#include "report/maps/deposit_map.hpp"

namespace clast {

/// Deposit and blocks of which its page is made.
struct DepositPageContents {
  std::string name;                   ///< id of the scan
  std::string file;                   ///< path of the scan
  const FieldScan* scan = nullptr;    ///< points, block of each point, and parts left out
  double unit = 1.0;                  ///< metres per unit of its points
  std::string up = "z";               ///< up axis of its points
  std::vector<std::string> ids = {};  ///< block ids in the order of `FieldDeposit::block_of_point`
  const std::vector<Block>* blocks = nullptr;  ///< those that were made, in the same order
  std::vector<DepositEdit> edits = {};         ///< corrections that were applied
  std::string stem = "deposit";   ///< file name of the page and its map layers without extension
  std::string next_command = {};  ///< command that applies the saved corrections
};

/// Page of a deposit and its map.
struct DepositPage {
  std::string html;  ///< self-contained page
  report_detail::DepositMap map;
};

/// Makes the page and the map of a deposit. Pages of blocks are linked as blocks/ID.html.
DepositPage make_deposit_page(const DepositPageContents& deposit);

}  // namespace clast
