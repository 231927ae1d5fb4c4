#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_view.hpp"

namespace analogon {

/// Whether a text is a table of the Modelica Standard Library: "#1" in the first line, then "double name(rows,cols)".
bool isModelicaTable(TextView text);

/// Its matrices; their columns have no names and are called c1, c2 …, the first is the time.
struct ModelicaTable {
    std::string name;
    Table table;
};
Outcome<std::vector<ModelicaTable>> readModelicaTables(TextView text, const std::string& file);

}  // namespace analogon
