#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include "core/delimited_text.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "mesh/detail/cloud_readers.hpp"

namespace clast::mesh_detail {
namespace {

/// A line longer than this is no line of points.
constexpr std::size_t kLongestLine = 1 << 20;
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
      if (text_.size() - begin_ > kLongestLine) {
        throw InputError("line " + std::to_string(number_ + 1) +
                         ": has no end within a megabyte; this is not a text of points");
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

/// What a message repeats of a word, which may be bytes of any kind.
std::string quoted(std::string_view word) {
  constexpr std::size_t kQuoted = 40;
  return "\"" + printable(word.substr(0, kQuoted)) + "\"";
}

/// How the words of a line are separated: as the fields of any table, but blanks separate too.
struct Separation {
  std::string_view separators;
  char separator = ',';  ///< of `number_in_field`

  /// Takes the next word off `line`; empty at its end.
  std::string_view word(std::string_view& line) const {
    const std::size_t begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos) return line = {};
    line.remove_prefix(begin);
    const std::string_view found = line.substr(0, line.find_first_of(separators));
    line.remove_prefix(found.size());
    return found;
  }
};

Separation separation_of(std::string_view line) {
  const char separator = separator_of(line);
  return {separator == ';' ? " \t;" : separator == ',' ? " \t," : " \t", separator};
}

std::size_t fields_in(std::string_view line, char separator) {
  return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), separator));
}

/// Words that stand for x, y and z in a heading.
constexpr std::array<std::array<std::string_view, 4>, 3> kAxisNames = {
    {{"x", "easting", "east", "e"},
     {"y", "northing", "north", "n"},
     {"z", "height", "elevation", "h"}}};

/// Columns of x, y and z in a heading; none when it does not name them all.
std::optional<std::array<std::size_t, 3>> columns_in(std::string_view heading) {
  constexpr Separation kAny{" \t,;"};
  std::array<std::size_t, 3> columns{};
  std::array<bool, 3> found{};
  std::size_t column = 0;
  for (std::string_view word = kAny.word(heading); !word.empty(); word = kAny.word(heading)) {
    std::string name;  // without quotes and unit: "X", x_m, x[m]
    for (const char c : word) {
      if (c == '_' || c == '[' || c == '(') break;
      if (c != '"') name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& names = kAxisNames[axis];
      if (found[axis] || std::find(names.begin(), names.end(), name) == names.end()) continue;
      columns[axis] = column;
      found[axis] = true;
    }
    ++column;
  }
  return found[0] && found[1] && found[2] ? std::optional(columns) : std::nullopt;
}

class LinesOfPoints {
 public:
  explicit LinesOfPoints(PointSink& sink) : sink_(sink) {}

  void read(std::string_view line, std::size_t number) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return;
    const std::string_view text = line.substr(begin);
    if (text.starts_with('#') || text.starts_with("//")) return;
    if (!separation_known_) {
      if (is_heading(text, number)) return;
      separation_ = separation_of(text);
      separation_known_ = true;
    }
    check_fields(text, number);
    const Vec3 point = point_in(text, number);
    count_up(point.x());
    sink_.add(point);
  }

  /// @throws InputError  what was taken for x numbers the points
  void check_columns() const {
    if (points_ < kNoChance || !counting_) return;
    throw InputError("column " + std::to_string(columns_[0] + 1) +
                     ", which was taken for x, numbers the points; name the columns in a first "
                     "line, such as \"id x y z\"");
  }

 private:
  /// So many values of x each one more than the last number the points.
  static constexpr std::size_t kNoChance = 100;
  /// Lines of words before the points at most.
  static constexpr std::size_t kLongestHeading = 20;

  void count_up(double x) {
    counting_ = counting_ && x == std::round(x) && (points_ == 0 || x == last_x_ + 1.0);
    last_x_ = x;
    ++points_;
  }

  /// The lines before the first point: a heading, or the number of points.
  bool is_heading(std::string_view text, std::size_t number) {
    constexpr Separation kAny{" \t,;"};
    std::string_view rest = text;
    const bool starts_with_number = number_in(kAny.word(rest)).has_value();
    const bool alone = kAny.word(rest).empty();
    if (lines_before_ >= kLongestHeading || (starts_with_number && !alone)) return false;
    ++lines_before_;
    if (const auto named = columns_in(text)) {
      columns_ = *named;
      if (separator_of(text) == ',') {
        fields_ = fields_in(text, ',');
        counted_line_ = number;
      }
    }
    return true;
  }

  /// Between commas each line has as many fields as the first, since a decimal comma would split a
  /// number; and no field up to z is empty, which would shift those behind it.
  void check_fields(std::string_view line, std::size_t number) {
    const char separator = separation_.separator;
    if (separator != ',' && separator != ';') return;
    const std::size_t fields = fields_in(line, separator);
    if (fields_ == 0) {
      fields_ = fields;
      counted_line_ = number;
    }
    if (separator == ',' && fields != fields_) {
      throw InputError("line " + std::to_string(number) + ": has " + std::to_string(fields) +
                       " fields, but line " + std::to_string(counted_line_) + " has " +
                       std::to_string(fields_) + "; " + kDecimalCommaAdvice);
    }
    const std::size_t last = *std::max_element(columns_.begin(), columns_.end());
    for (std::size_t field = 0; field <= last && !line.empty(); ++field) {
      const std::size_t end = std::min(line.find(separator), line.size());
      if (line.substr(0, end).find_first_not_of(" \t") == std::string_view::npos) {
        throw InputError("line " + std::to_string(number) + ": field " + std::to_string(field + 1) +
                         " is empty, and one behind it is needed; fill it in");
      }
      line.remove_prefix(std::min(end + 1, line.size()));
    }
  }

  Vec3 point_in(std::string_view line, std::size_t number) const {
    Vec3 point = Vec3::Zero();
    std::size_t left = 3;
    for (std::size_t column = 0; left > 0; ++column) {
      const std::string_view word = separation_.word(line);
      if (word.empty()) break;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (columns_[axis] != column) continue;
        const std::optional<double> value = number_in_field(word, separation_.separator);
        if (!value) {
          throw InputError("line " + std::to_string(number) + ": " + quoted(word) +
                           " stands where " + "xyz"[axis] + " is needed; a line must be x y z");
        }
        point[static_cast<Eigen::Index>(axis)] = *value;
        --left;
      }
    }
    if (left > 0) {
      throw InputError("line " + std::to_string(number) +
                       ": fewer than three numbers; a line must be x y z");
    }
    return point;
  }

  PointSink& sink_;
  Separation separation_{" \t,;"};
  bool separation_known_ = false;
  std::size_t lines_before_ = 0;
  std::size_t fields_ = 0;  ///< of each line between commas; 0 until one is counted
  std::size_t counted_line_ = 0;
  std::size_t points_ = 0;
  double last_x_ = 0.0;
  bool counting_ = true;  ///< so far
  std::array<std::size_t, 3> columns_ = {0, 1, 2};
};

}  // namespace

CloudSummary read_text_cloud(std::istream& stream, PointSink& sink) {
  Lines lines(stream);
  LinesOfPoints points(sink);
  std::string_view line;
  while (lines.next(line)) {
    if (lines.number() == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    points.read(line, lines.number());
  }
  points.check_columns();
  return sink.finish({});
}

}  // namespace clast::mesh_detail
