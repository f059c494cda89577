#pragma once
/// Conversion of tables and JSON to Python values.
#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

#include "core/files/table_values.hpp"
#include "study/campaign/key_table.hpp"

namespace clast::python_detail {

/// Returns (values, units, meanings), three dicts with the column names as keys. Values are NumPy
/// arrays of float64, int64 or texts. Units and meanings are texts.
pybind11::tuple make_table_dicts(TableValues table);

/// Converts JSON to dict, list, str, int, float, bool or None.
pybind11::object to_python_object(const nlohmann::ordered_json& json);

pybind11::dict key_tables_to_dict(const std::vector<KeyTable>& tables);

}  // namespace clast::python_detail
