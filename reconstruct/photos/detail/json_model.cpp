#include "reconstruct/photos/detail/json_model.hpp"

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"

namespace clast::photos_detail {

nlohmann::json load_json(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_text_file(file));
}

double parse_json_number(const nlohmann::json& value) {
  if (!value.is_string()) return value.get<double>();
  const std::optional<double> number = parse_number(value.get<std::string>());
  if (!number) throw InputError("\"" + value.get<std::string>() + "\" is not a number");
  return *number;
}

int parse_json_count(const nlohmann::json& value) {
  constexpr double kMost = 1e6;
  const double number = parse_json_number(value);
  if (!(number >= 0.0 && number <= kMost)) {
    throw InputError(value.dump() + " is not a whole number from 0 to 1000000");
  }
  return static_cast<int>(number);
}

Vec3 parse_json_vector(const nlohmann::json& value) {
  return {parse_json_number(value.at(0)), parse_json_number(value.at(1)),
          parse_json_number(value.at(2))};
}

std::string parse_json_id(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace clast::photos_detail
