#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/text/dialect.hpp"
#include "core/measure/text/preamble.hpp"
#include "core/measure/text/row_frame.hpp"

namespace analogon {

struct LayoutColumn {
    std::string name, unit{}, comment{};
    std::string header{};    // as written, with the unit
    int line{}, position{};  // where the header stands (1-based); 0: nowhere
    CellKind kind{CellKind::Blank};
};

/// What stands where in a text: found by structure. Rows of a constant number of cells and of constant kinds are data;
/// what is in front of them is the header, and in front of that the preamble.
struct Layout {
    char separator{','};
    NumberMarks marks;
    std::vector<LayoutColumn> columns;
    PreambleFacts facts;
    std::size_t offset{};   // of the first row of data
    int linesBefore{};      // lines in front of it
    int headerLine{};       // of the names; 0: there are none
    int unitsLine{};        // of the units row; 0: there is none
    std::size_t remarks{};  // columns behind the last one that may hold remarks, and have no cells in most rows
    bool arePadded{};       // rows may end early: what is missing is empty
    Diagnostics warnings;
};

/// `unframed`: what stood around the rows of the text; null: nothing.
Outcome<Layout> findLayout(TextView text, const std::string& file, const ReadOptions& options, Questions& asked,
                           const UnframedText* unframed = nullptr);

/// What was found out, in one line.
Text described(const Layout& layout);

}  // namespace analogon
