#include "reconstruct/deposit/deposit_edits.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "reconstruct/cloud/cloud.hpp"

namespace clast {

using namespace reconstruct_detail;

namespace {

/// Largest distance of a place from the nearest point of the scan, in point spacings.
constexpr double kEditReach = 5.0;

/// Projection along the direction in which a line was drawn.
class CutView {
 public:
  explicit CutView(const Vec3& direction) {
    across_ = direction.unitOrthogonal();
    up_ = direction.normalized().cross(across_);
  }

  Vec2 projected(const Vec3& point) const { return {across_.dot(point), up_.dot(point)}; }

 private:
  Vec3 across_, up_;
};

/// Line of a cut in the plane of its view.
class CutLine {
 public:
  explicit CutLine(const DepositEdit& edit) : view_(edit.view) {
    for (const Vec3& point : edit.line) corners_.push_back(view_.projected(point));
  }

  /// True if a point is to the left of the nearest part of the line.
  bool is_left(const Vec3& point) const {
    const Vec2 p = view_.projected(point);
    double nearest = std::numeric_limits<double>::infinity();
    double side = 0.0;
    const std::size_t last = corners_.size() - 2;
    for (std::size_t i = 0; i <= last; ++i) {
      const Vec2 along = direction(i), offset = p - corners_[i];
      const double length = (corners_[i + 1] - corners_[i]).norm();
      double t = offset.dot(along);
      // At a corner, the line turns: its two segments decide together.
      Vec2 tangent = along;
      if (t < 0.0 && i > 0) {
        t = 0.0;
        tangent += direction(i - 1);
      } else if (t > length && i < last) {
        t = length;
        tangent += direction(i + 1);
      }
      const Vec2 gap = offset - t * along;
      if (gap.squaredNorm() >= nearest) continue;
      nearest = gap.squaredNorm();
      side = cross(tangent, gap);
    }
    return side > 0.0;
  }

 private:
  Vec2 direction(std::size_t segment) const {
    return (corners_[segment + 1] - corners_[segment]).normalized();
  }

  CutView view_;
  std::vector<Vec2> corners_;
};

/// Segmentation while edits are applied. A group of labels is a block.
class EditedSegmentation {
 public:
  EditedSegmentation(std::vector<std::uint32_t> labels, std::span<const Vec3> points,
                     double spacing)
      : labels_(std::move(labels)), points_(points), reach_(kEditReach * spacing) {
    for (const std::uint32_t label : labels_) {
      while (group_.size() <= label) group_.push_back(static_cast<std::uint32_t>(group_.size()));
    }
    if (group_.empty()) group_.push_back(0);
    first_new_ = static_cast<std::uint32_t>(group_.size());
    sources_ = group_;
    accepted_by_.assign(group_.size(), 0);
  }

  /// Applies an edit. Returns the reason if it does not fit, otherwise an empty text.
  std::string apply(const DepositEdit& edit, std::size_t number) {
    std::vector<std::uint32_t> blocks;
    for (const Vec3& place : edit.points) {
      const std::optional<std::uint32_t> block = block_near(place);
      if (!block) {
        return "no point of the scan is within " + format_significant(reach_, 2) + " m of " +
               format_point(place) + "; name a block by a point on its surface, or remove the edit";
      }
      if (*block == 0) {
        return "only ground is at " + format_point(place) +
               ", no block; name a point on a block, or remove the edit";
      }
      blocks.push_back(*block);
    }
    switch (edit.kind) {
      case DepositEditKind::kAccept:
        accepted_by_[blocks[0]] = number;
        return {};
      case DepositEditKind::kDrop:
        unite(blocks[0], 0);
        return {};
      case DepositEditKind::kMerge:
        return merge(std::move(blocks));
      case DepositEditKind::kCut:
        return cut(blocks[0], CutLine(edit));
    }
    return {};
  }

  /// Numbers the blocks without gaps: those of the given labels first, then new ones by their first
  /// point.
  EditedLabels result() {
    EditedLabels edited;
    constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(group_.size(), kUnset);
    const auto add = [&](std::uint32_t group) {
      if (number[group] != kUnset) return;
      number[group] = static_cast<std::uint32_t>(edited.sources.size());
      edited.sources.push_back(sources_[group]);
      edited.accepted_by.push_back(accepted_by_[group]);
    };
    add(0);
    for (std::uint32_t& label : labels_) label = group_[label];
    std::vector<bool> is_used(group_.size(), false);
    for (const std::uint32_t group : labels_) is_used[group] = true;
    for (std::uint32_t group = 0; group < first_new_; ++group) {
      if (is_used[group]) add(group);
    }
    for (const std::uint32_t group : labels_) add(group);
    for (std::uint32_t& label : labels_) label = number[label];
    edited.labels = std::move(labels_);
    return edited;
  }

 private:
  /// Group of the nearest point; empty if it is too far.
  std::optional<std::uint32_t> block_near(const Vec3& place) {
    if (!tree_) tree_.emplace(points_);
    const std::vector<PointTree::Neighbour> nearest = tree_->nearest_neighbours(place, 1);
    if (nearest.empty() || nearest.front().distance > reach_) return {};
    return group_[labels_[nearest.front().point]];
  }

  /// Adds the labels of one group to another.
  void unite(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t& group : group_) {
      if (group == from) group = to;
    }
    accepted_by_[from] = accepted_by_[to] = 0;
  }

  std::string merge(std::vector<std::uint32_t> blocks) {
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    if (blocks.size() < 2) return "its points are on one block already; remove the edit";
    for (std::size_t i = 1; i < blocks.size(); ++i) unite(blocks[i], blocks[0]);
    return {};
  }

  std::string cut(std::uint32_t block, const CutLine& line) {
    std::optional<bool> kept_side;
    std::vector<std::size_t> other_side;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (group_[labels_[i]] != block) continue;
      const bool left = line.is_left(points_[i]);
      if (!kept_side) kept_side = left;
      if (left != *kept_side) other_side.push_back(i);
    }
    if (other_side.empty()) {
      return "its line leaves the whole block on one side; draw it across the block";
    }
    const auto label = static_cast<std::uint32_t>(group_.size());
    for (const std::size_t i : other_side) labels_[i] = label;
    group_.push_back(label);
    sources_.push_back(sources_[block]);
    accepted_by_.push_back(0);
    accepted_by_[block] = 0;
    return {};
  }

  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> group_;    ///< of each label; 0: ground
  std::vector<std::uint32_t> sources_;  ///< label before the edits, of each label
  std::vector<std::size_t> accepted_by_;
  std::uint32_t first_new_ = 0;  ///< lowest label that no point had before the edits
  std::span<const Vec3> points_;
  double reach_;
  std::optional<PointTree> tree_;
};

/// Refuses an edit.
[[noreturn]] void refuse_edit(std::span<const DepositEdit> edits, std::size_t number,
                              const std::string& reason) {
  const DepositEdit& edit = edits[number - 1];
  const std::string place = edit.points.empty() ? "" : " at " + format_point(edit.points[0]);
  throw InputError("edit " + std::to_string(number) + " of " + std::to_string(edits.size()) + " (" +
                   name_of(edit.kind) + place + "): " + reason);
}

}  // namespace

std::string name_of(DepositEditKind kind) {
  switch (kind) {
    case DepositEditKind::kAccept:
      return "accept";
    case DepositEditKind::kDrop:
      return "drop";
    case DepositEditKind::kMerge:
      return "merge";
    case DepositEditKind::kCut:
      return "cut";
  }
  return {};
}

void DepositEdit::check() const {
  const auto is_finite = [](const Vec3& v) { return v.allFinite(); };
  const bool merges = kind == DepositEditKind::kMerge, cuts = kind == DepositEditKind::kCut;
  if (merges ? points.size() < 2 : points.size() != 1) {
    throw InputError("points: " + format_count(points.size(), "point") + ", but `" + name_of(kind) +
                     "` needs " + (merges ? "two or more" : "one"));
  }
  if (!std::all_of(points.begin(), points.end(), is_finite)) {
    throw InputError("points: a coordinate is not finite");
  }
  if (cuts ? line.size() < 2 : !line.empty()) {
    throw InputError("line: " + format_count(line.size(), "point") + ", but `" + name_of(kind) +
                     "` needs " + (cuts ? "two or more" : "none"));
  }
  if (!std::all_of(line.begin(), line.end(), is_finite)) {
    throw InputError("line: a coordinate is not finite");
  }
  if (!view.allFinite() || view.isZero(0.0)) {
    throw InputError("view: " + format_point(view) + " is no direction");
  }
  const CutView seen(view);
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (seen.projected(line[i]) == seen.projected(line[i - 1])) {
      throw InputError("line: points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                       " are the same in the direction of view");
    }
  }
}

EditedLabels apply_deposit_edits(std::vector<std::uint32_t> labels, std::span<const Vec3> points,
                                 double spacing, std::span<const DepositEdit> edits) {
  EditedSegmentation segmentation(std::move(labels), points, spacing);
  EditMisfits misfits;
  for (std::size_t number = 1; number <= edits.size(); ++number) {
    try {
      edits[number - 1].check();
    } catch (const InputError& error) {
      refuse_edit(edits, number, error.what());
    }
    const std::string reason = segmentation.apply(edits[number - 1], number);
    if (!reason.empty()) misfits[number] = reason;
  }
  EditedLabels edited = segmentation.result();
  edited.misfits = std::move(misfits);
  return edited;
}

void check_edits_fit(std::span<const DepositEdit> edits, const EditMisfits& misfits) {
  if (!misfits.empty()) refuse_edit(edits, misfits.begin()->first, misfits.begin()->second);
}

}  // namespace clast
