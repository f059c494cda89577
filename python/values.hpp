#pragma once
/// Conversion of tables and JSON to Python values.
#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

#include "core/files/table_values.hpp"
#include "study/campaign/key_table.hpp"

namespace clast::python_detail {

/// Converts a table to three dicts with the column names as keys: values as NumPy arrays, units and
/// meanings as texts.
pybind11::tuple make_table_dicts(TableValues table);

/// Converts JSON to dict, list, str, int, float, bool or None.
pybind11::object to_python_object(const nlohmann::ordered_json& json);

pybind11::dict key_tables_to_dict(const std::vector<KeyTable>& tables);

}  // namespace clast::python_detail
