#include "pipeline/picked_pairs_file.hpp"

#include <string>

#include "core/error.hpp"
#include "core/files/delimited_text.hpp"
#include "core/files/text_file.hpp"
#include "core/printable.hpp"

namespace clast {

std::vector<NamedPair> read_picked_pairs(const std::filesystem::path& file) {
  constexpr std::size_t kFields = 8;
  const DecodedText decoded = decode_table_text(read_text_file(file), file.string());
  DelimitedTextReader reader(decoded.text, file.string());
  std::vector<NamedPair> pairs;
  bool is_first = true;
  for (Record record; reader.read_record(record); is_first = false) {
    const std::string where = file.string() + ", line " + std::to_string(record.line);
    if (record.fields.size() != kFields) {
      throw InputError(where + ": has " + std::to_string(record.fields.size()) +
                       " columns; expected scan_a, x, y, z, scan_b, x, y, z");
    }
    if (is_first && !parse_number_field(record.fields[1], reader.separator())) continue;
    const auto point = [&](std::size_t first) {
      Vec3 found;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string_view field = record.fields[first + axis];
        const std::optional<double> number = parse_number_field(field, reader.separator());
        if (!number) {
          throw InputError(where + ": \"" + escape_nonprintable(std::string(field)) +
                           "\" is not a coordinate");
        }
        found[static_cast<Eigen::Index>(axis)] = *number;
      }
      return found;
    };
    pairs.push_back(
        {std::string(record.fields[0]), point(1), std::string(record.fields[4]), point(5)});
  }
  if (pairs.empty()) throw InputError(file.string() + ": holds no picked places");
  return pairs;
}

}  // namespace clast
