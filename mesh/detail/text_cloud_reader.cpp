#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/files/delimited_text.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "mesh/coordinate_columns.hpp"
#include "mesh/detail/cloud_readers.hpp"

namespace clast::mesh_detail {
namespace {

/// A line longer than this is no line of points.
constexpr std::size_t kMaxLineLength = 1 << 20;
constexpr std::size_t kBlock = 1 << 20;

/// Lines of a stream, read in blocks.
class Lines {
 public:
  explicit Lines(std::istream& stream) : stream_(stream) {}

  /// The next line without its end (LF or CR LF); false at the end of the file.
  bool next(std::string_view& line) {
    while (true) {
      const std::size_t end = text_.find('\n', begin_);
      if (end != std::string::npos) {
        line = std::string_view(text_).substr(begin_, end - begin_);
        begin_ = end + 1;
        break;
      }
      if (at_end_) {
        if (begin_ >= text_.size()) return false;
        line = std::string_view(text_).substr(begin_);
        begin_ = text_.size();
        break;
      }
      if (text_.size() - begin_ > kMaxLineLength) {
        throw InputError("line " + std::to_string(number_ + 1) +
                         ": is longer than a megabyte; this is not a text file of points");
      }
      refill();
    }
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return true;
  }
  std::size_t number() const { return number_; }

 private:
  void refill() {
    text_.erase(0, begin_);
    begin_ = 0;
    const std::size_t kept = text_.size();
    text_.resize(kept + kBlock);
    stream_.read(text_.data() + kept, static_cast<std::streamsize>(kBlock));
    text_.resize(kept + static_cast<std::size_t>(stream_.gcount()));
    at_end_ = !stream_;
  }

  std::istream& stream_;
  std::string text_;
  std::size_t begin_ = 0;
  std::size_t number_ = 0;
  bool at_end_ = false;
};

/// Formats a text, which may hold bytes of any kind, in quotes for a message.
/// @param most  bytes
std::string quoted(std::string_view text, std::size_t most = 40) {
  return "\"" + escape_nonprintable(text.substr(0, most)) + (text.size() > most ? "..." : "") +
         "\"";
}

std::string_view trimmed_field(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The fields of a line, without blanks and quotes around them.
/// @param separator  ' ': any number of blanks and tabs
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  while (true) {
    const std::size_t begin = line.find_first_not_of(separator == '\t' ? " " : " \t");
    line.remove_prefix(std::min(begin, line.size()));
    if (line.empty() && separator == ' ') return;
    std::size_t from = 0;
    if (line.starts_with('"')) from = std::min(line.find('"', 1), line.size());
    const std::size_t end =
        std::min(separator == ' ' ? line.find_first_of(" \t", from) : line.find(separator, from),
                 line.size());
    std::string_view field = trimmed_field(line.substr(0, end));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') {
      field = trimmed_field(field.substr(1, field.size() - 2));
    }
    fields.push_back(field);
    if (end == line.size()) return;
    line.remove_prefix(end + 1);
  }
}

/// A line before the points.
struct HeadLine {
  std::string text;  ///< UTF-8, without the sign of a remark
  std::size_t number = 0;
  bool remark = false;
};

/// Finds out which columns hold the points, and reads them.
class LinesOfPoints {
 public:
  LinesOfPoints(PointBatcher& sink, const std::vector<std::string>& columns)
      : sink_(sink), asked_(columns) {}

  void read(std::string_view line, std::size_t number) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return;
    const std::string_view text = line.substr(begin);
    const bool remark = text.starts_with('#') || text.starts_with("//");
    if (!columns_known_) {
      if (remark || is_before_points(text)) {
        take_head(text, number, remark);
        return;
      }
      choose_columns(line, number);
    } else if (remark) {
      return;
    }
    split_fields(line, separator_, fields_);
    if (fields_.size() == 1 && is_next_count(fields_[0])) return;
    check_fields(number);
    const Vec3 point = point_in(number);
    count_up(point.x());
    if (!named_ && points_ <= kSurveyed) survey_columns();
    ++points_of_scan_;
    sink_.add_point(point);
  }

  /// Returns the units that the headings declare.
  /// @throws InputError  what was taken for x numbers the points
  std::vector<LengthUnitDeclaration> finish() const {
    if (points_ >= kNoChance && counting_ && !named_) {
      throw InputError("column " + std::to_string(columns_.axes[0] + 1) +
                       ", which was read as x, holds point numbers; name the columns in a first "
                       "line, such as \"id x y z\", or give `columns`");
    }
    if (points_ >= kNoChance && !named_ && numbers_come_first()) {
      throw InputError(
          "column 1 holds only whole numbers, unlike three or more columns after it: does it hold "
          "point numbers instead of x? Name the columns in a first line, such as "
          "\"id x y z\", or give `columns`");
    }
    return columns_.unit_declarations;
  }

  /// Refuses a scan that holds another number of points than the line before it says.
  void check_count() const {
    if (counts_ == 0 || points_of_scan_ == counted_) return;
    throw InputError(std::to_string(counted_) + " points are announced before a scan, but " +
                     std::to_string(points_of_scan_) + " follow; the file may be cut short");
  }

 private:
  /// Properties of the first values of a column without a heading.
  struct ColumnSurvey {
    bool whole = true;        ///< all
    bool beyond_one = false;  ///< some, so that they are no normals
  };
  /// Points whose columns are surveyed.
  static constexpr std::size_t kSurveyed = 1000;

  void survey_columns() {
    surveyed_.resize(std::max(surveyed_.size(), fields_.size()));
    for (std::size_t k = 0; k < fields_.size(); ++k) {
      const std::optional<double> value = parse_number_field(fields_[k], separator_);
      if (!value || !std::isfinite(*value)) continue;
      surveyed_[k].whole = surveyed_[k].whole && *value == std::round(*value);
      surveyed_[k].beyond_one = surveyed_[k].beyond_one || std::abs(*value) > 1.0;
    }
  }
  bool numbers_come_first() const {
    return surveyed_[0].whole &&
           std::count_if(surveyed_.begin(), surveyed_.end(), [](const ColumnSurvey& column) {
             return !column.whole && column.beyond_one;
           }) >= 3;
  }

  /// Minimum run of consecutive integers in the x column that is taken for point numbers.
  static constexpr std::size_t kNoChance = 100;
  /// Lines of words before the points at most.
  static constexpr std::size_t kMaxHeadingLength = 20;
  static constexpr const char* kColumnsAdvice =
      "give `columns`, three names or numbers from 1, those of x, y and z";

  void count_up(double x) {
    if (points_ == 1) step_ = x - last_x_;
    counting_ =
        counting_ && x == std::round(x) && (points_ == 0 || (step_ >= 1.0 && x - last_x_ == step_));
    last_x_ = x;
    ++points_;
  }

  /// A file of several scans has their numbers of points before each.
  bool is_next_count(std::string_view field) {
    const std::optional<double> count = parse_number(field);
    if (!count || *count != std::round(*count) || counts_ == 0 || points_of_scan_ != counted_) {
      return false;
    }
    set_count(*count);
    return true;
  }
  void set_count(double count) {
    counted_ = static_cast<std::size_t>(std::clamp(count, 0.0, 1e15));
    points_of_scan_ = 0;
    ++counts_;
  }

  /// True if the line is not a point: a heading, or the number of points.
  bool is_before_points(std::string_view text) {
    if (head_lines_ >= kMaxHeadingLength) return false;
    split_fields(text, detect_separator(text), fields_);
    const auto numbers = std::count_if(fields_.begin(), fields_.end(), [&](std::string_view field) {
      return parse_number_field(field, detect_separator(text)).has_value();
    });
    if (fields_.size() == 1 && numbers == 1) return true;
    constexpr std::ptrdiff_t kCoordinates = 3;
    std::string_view first = text.substr(0, text.find_first_of(" \t,;"));
    if (first.size() > 1 && first.front() == '"') first = first.substr(1, first.find('"', 1) - 1);
    return !parse_number(first) && !parse_number_field(fields_[0], detect_separator(text)) &&
           numbers < kCoordinates;
  }

  void take_head(std::string_view text, std::size_t number, bool remark) {
    if (text.size() == 5 && text.starts_with("sep=")) {
      said_separator_ = text.back();
      return;
    }
    if (!remark) ++head_lines_;
    if (text.starts_with("ncols") || text.starts_with("NCOLS") || text.starts_with("nrows")) {
      throw InputError("is an Esri grid of heights, not a point cloud; read it as a terrain");
    }
    if (const auto count = parse_number(trimmed_field(text))) set_count(*count);
    const auto keep = [&](std::string_view line) {
      // The last lines count.
      if (head_.size() >= kMaxHeadingLength) head_.erase(head_.begin());
      head_.push_back({to_utf8(line), number, remark});
    };
    if (text.starts_with('#')) keep(text);  // may be the name of the first column
    if (remark) text.remove_prefix(std::min(text.find_first_not_of("#/ \t"), text.size()));
    keep(text);
  }

  /// The headings nearest to the points that name all axes decide; headings that do not are asked
  /// about, and without any the first three columns are x, y and z.
  void choose_columns(std::string_view line, std::size_t number) {
    columns_known_ = true;
    const bool tabs = std::any_of(head_.begin(), head_.end(), [](const HeadLine& head) {
      return head.text.find('\t') != std::string::npos;
    });
    separator_ = said_separator_.value_or(detect_separator(line));
    if (separator_ == '\t' && !tabs) separator_ = ' ';  // numbers hold no blanks
    split_fields(line, separator_, fields_);
    if (separator_ != ',') drop_empty_end(fields_);
    const std::size_t count = fields_.size();
    std::vector<std::string_view> headings;
    for (auto head = head_.rbegin(); head != head_.rend(); ++head) {
      if (!take_headings(*head, count, headings)) continue;
      for (auto units = head_.rbegin(); units != head; ++units) take_units(*units);
      return;
    }
    if (!asked_.empty()) {
      columns_ = select_coordinate_columns(asked_, {}, count);
      named_ = true;
      return;
    }
    for (auto head = head_.rbegin(); head != head_.rend(); ++head) refuse_unknown(*head, count);
    counted_line_ = number;
  }

  /// @return whether the line holds the headings of the columns
  bool take_headings(const HeadLine& head, std::size_t count,
                     std::vector<std::string_view>& headings) {
    for (const char separator : {separator_, detect_separator(head.text)}) {
      split_fields(head.text, separator, headings);
      drop_empty_end(headings);
      if (!asked_.empty()) {
        if (headings.size() != count) continue;
        columns_ = select_coordinate_columns(asked_, headings, count);
      } else if (const auto named = fits(headings.size(), count) ? find_coordinate_columns(headings)
                                                                 : std::nullopt) {
        columns_ = *named;
      } else {
        continue;
      }
      named_ = true;
      fields_per_line_ = headings.size();
      counted_line_ = head.number;
      return true;
    }
    return false;
  }

  /// A row below the headings may hold their units: "m;m;ft".
  void take_units(const HeadLine& head) {
    std::vector<std::string_view> units;
    split_fields(head.text, separator_, units);
    for (std::size_t axis = 0; axis < 3 && columns_.axes[axis] < units.size(); ++axis) {
      const std::string unit(units[columns_.axes[axis]]);
      const ColumnHeading heading = parse_heading("x [" + unit + "]");
      if (!heading.length_unit) continue;
      LengthUnitDeclaration declared{.source = "unit \"" + escape_nonprintable(unit) +
                                               "\" of line " + std::to_string(head.number)};
      (axis < 2 ? declared.plan : declared.height) =
          DeclaredUnit{heading.length_unit->factor, heading.length_unit->name};
      columns_.unit_declarations.push_back(std::move(declared));
    }
  }

  /// Columns behind the others may have no heading or be left out, and between commas each line
  /// must have as many fields as the heading. One heading less is that of the first column in files
  /// of R, where it holds the numbers of the rows.
  bool fits(std::size_t headings, std::size_t count) const {
    if (headings == count || separator_ == ',') return true;
    if (headings > count) return separator_ != ' ';  // empty ones at the end may be left out
    const std::optional<double> first = parse_number(fields_[0]);
    const bool row_number = !first || *first == std::round(*first);
    return headings > 2 && (headings + 1 < count || (headings + 1 == count && !row_number));
  }

  static void drop_empty_end(std::vector<std::string_view>& fields) {
    while (fields.size() > 3 && fields.back().empty()) fields.pop_back();
  }

  static constexpr std::size_t kQuotedHeading = 200;

  void refuse_unknown(const HeadLine& head, std::size_t count) {
    std::vector<std::string_view> headings;
    split_fields(head.text, separator_, headings);
    drop_empty_end(headings);
    const auto axes = std::count_if(headings.begin(), headings.end(), [](std::string_view heading) {
      return parse_coordinate_axis(heading).has_value();
    });
    // Remarks are sentences more often than headings.
    const bool heading = head.remark ? axes > 2 && headings.size() + 1 == count
                                     : axes > 1 || (headings.size() == count &&
                                                    is_possible_heading_row(headings, separator_));
    if (!heading) return;
    throw InputError("line " + std::to_string(head.number) + ": the heading " +
                     quoted(head.text, kQuotedHeading) + " does not say which of the " +
                     std::to_string(count) + " columns are x, y and z; " + kColumnsAdvice);
  }

  /// Between commas each line has as many fields as the first, since a decimal comma would split a
  /// number; a comma behind the last one counts for nothing.
  void check_fields(std::size_t number) {
    if (separator_ != ',') return;
    if (fields_per_line_ == 0) {
      fields_per_line_ = fields_.size();
      counted_line_ = number;
    }
    const bool closed = fields_.size() == fields_per_line_ + 1 && fields_.back().empty();
    if (fields_.size() == fields_per_line_ || closed) return;
    throw InputError("line " + std::to_string(number) + ": has " + std::to_string(fields_.size()) +
                     " fields, but line " + std::to_string(counted_line_) + " has " +
                     std::to_string(fields_per_line_) + "; " + kDecimalCommaHint);
  }

  /// Refuses a row whose name says that it sums up the others.
  void refuse_summary(std::size_t number) const {
    const auto& axes = columns_.axes;
    if (fields_.empty() || std::find(axes.begin(), axes.end(), 0) != axes.end()) return;
    const std::string_view name = trimmed_field(fields_[0]);
    if (parse_number(name) || detect_summary_row_label(name) != SummaryRowLabel::kCertain) return;
    throw InputError("line " + std::to_string(number) + ": " + quoted(name) +
                     " is a sum of other rows; remove that row");
  }

  Vec3 point_in(std::size_t number) const {
    refuse_summary(number);
    Vec3 point = Vec3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t column = columns_.axes[axis];
      if (column >= fields_.size()) {
        throw InputError("line " + std::to_string(number) +
                         ": fewer than three numbers; a line must be x y z");
      }
      const std::optional<double> value = parse_number_field(fields_[column], separator_);
      if (!value) {
        throw InputError(
            "line " + std::to_string(number) + ": " +
            (fields_[column].empty() ? "the field for " + std::string(1, "xyz"[axis]) + " is empty"
                                     : quoted(fields_[column]) + " is not a number, where " +
                                           "xyz"[axis] + " is needed") +
            "; each line must hold x y z" + (named_ ? "" : ", or " + std::string(kColumnsAdvice)));
      }
      point[static_cast<Eigen::Index>(axis)] = *value;
    }
    return point;
  }

  PointBatcher& sink_;
  const std::vector<std::string>& asked_;  ///< `columns`; empty: the headings decide
  std::vector<HeadLine> head_;
  std::size_t head_lines_ = 0;
  std::optional<char> said_separator_;
  char separator_ = ' ';
  bool columns_known_ = false;
  bool named_ = false;  ///< by headings or by the user
  CoordinateColumns columns_;
  std::vector<std::string_view> fields_;
  std::size_t fields_per_line_ = 0;  ///< between commas; 0 until one line is counted
  std::size_t counted_line_ = 0;
  std::size_t counted_ = 0;  ///< points that the last count before a scan says
  std::size_t counts_ = 0;
  std::size_t points_of_scan_ = 0;
  std::size_t points_ = 0;
  std::vector<ColumnSurvey> surveyed_;
  double last_x_ = 0.0, step_ = 0.0;
  bool counting_ = true;  ///< so far
};

}  // namespace

CloudSummary read_text_cloud(std::istream& stream, PointBatcher& sink,
                             const std::vector<std::string>& columns, bool has_point_counts) {
  Lines lines(stream);
  LinesOfPoints points(sink, columns);
  std::string_view line;
  while (lines.next(line)) {
    if (lines.number() == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (lines.number() == 1 && line.find('\0') != std::string_view::npos) {
      throw InputError("is not plain text, or is text in UTF-16; save it as text in UTF-8");
    }
    points.read(line, lines.number());
  }
  CloudSummary summary;
  summary.unit_declarations = points.finish();
  if (has_point_counts) points.check_count();
  return sink.finish(std::move(summary));
}

}  // namespace clast::mesh_detail
