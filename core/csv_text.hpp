#pragma once
/// Tables as comma-separated text.
#include <cstdint>
#include <string>
#include <string_view>

namespace clast {

/// CSV after RFC 4180, with "\n" line ends. Numbers are the shortest text that reads back to the
/// same bits (-0 is written as 0); what is not known is an empty cell.
/// @cite rfc4180
class CsvText {
 public:
  void cell(std::string_view text);
  void cell(const char* text) { cell(std::string_view(text)); }
  void cell(double value);  ///< empty when it is not finite
  void count(std::uint64_t value);
  void empty_cells(int count);
  void end_row();
  /// @param names  with commas between them
  void header(std::string_view names);

  /// What was written since the last call.
  std::string take();

 private:
  void begin_cell();

  std::string text_;
  bool first_ = true;
};

}  // namespace clast
