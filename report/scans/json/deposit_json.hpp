#pragma once
/// Data of the page of a deposit for its scripts.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "reconstruct/deposit/deposit.hpp"
#include "report/scans/deposit_plan.hpp"

namespace clast::report_detail {

/// Deposit for the scripts of its page. Places are in m.
struct DepositViewContents {
  std::span<const Vec3> points;
  std::span<const std::uint32_t> block_of_point;  ///< from 1; 0: none
  const std::vector<std::string>& ids;            ///< of the blocks
  const std::vector<std::uint32_t>& accepted;     ///< blocks that an edit accepts, from 1
  const std::vector<LeftOutPart>& left_out;
  const std::vector<DepositEdit>& edits;
};

/// Maximum number of points of a 3-D view.
inline constexpr std::size_t kMaxViewPoints = 150'000;

/// Formats the data of the page of a deposit as JSON. Members:
/// - `ids` of the blocks 1, 2, ...
/// - `accepted`: numbers of the blocks that an edit accepts.
/// - `edits` that were applied, as in a file of edits.
/// - `leftOut`: `at` [3] and `points` of each part that is left out.
/// - `plan` {columns, rows, cell, low [2], blocks uint32}: block of each cell, row-major from the
///   largest y.
/// - `cloud` {origin [3], step, count, places uint16 [n][3], blocks uint32 [n], shades uint8 [n]}:
///   selected points, at least some of each block, in steps from the origin, with their brightness.
std::string format_deposit_json(const DepositViewContents& deposit, const DepositPlan& plan);

/// Converts corrections to the content of a file of edits.
nlohmann::ordered_json deposit_edits_json(const std::vector<DepositEdit>& edits);

}  // namespace clast::report_detail
