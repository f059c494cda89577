#include "python/values.hpp"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "python/arrays.hpp"

namespace clast::python_detail {

namespace py = pybind11;

namespace {

py::array array_of_numbers(std::vector<double> numbers) {
  return make_owning_array(std::move(numbers));
}

py::array array_of_numbers(const std::vector<std::uint64_t>& counts) {
  return make_owning_array(std::vector<std::int64_t>(counts.begin(), counts.end()));
}

py::array array_of_numbers(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(text);
  return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = "str");
}

}  // namespace

py::tuple make_table_dicts(TableValues table) {
  py::dict values, units, meanings;
  for (ColumnValues& column : table) {
    const py::str name(column.name);
    values[name] =
        std::visit([](auto& held) { return array_of_numbers(std::move(held)); }, column.values);
    units[name] = column.unit;
    meanings[name] = column.meaning;
  }
  return py::make_tuple(values, units, meanings);
}

py::object to_python_object(const nlohmann::ordered_json& json) {
  // Texts that are not UTF-8 never get here: libraries convert what they read.
  return py::module_::import("json").attr("loads")(json.dump());
}

py::dict key_tables_to_dict(const std::vector<KeyTable>& tables) {
  py::dict keys;
  for (const KeyTable& table : tables) keys[py::str(table.name)] = table.key_names();
  return keys;
}

}  // namespace clast::python_detail
