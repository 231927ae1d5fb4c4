#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/eval/program_code.hpp"
#include "core/eval/system.hpp"

namespace analogon {

/// Loops over the rows of a table, one row a step: whole stretches of a record without a call in between. Only for
/// slots that do not depend on the parameters, and are continuous from row to row or held in each.
struct RowCode {
    RowLayout layout;
    bool isExact{};        // by the recurrence, else Runge-Kutta
    CompiledProgram walk;  // outputs at the begin of the row into the result, then the step to the next row
    CompiledProgram step;  // the step alone
    CompiledProgram
        tabulation;  // from slots (layout.slots a row) what depends on them alone; layout.tabulated() results
    // The exact recurrence: places of the matrix in the scratch memory of `walk`, by entry, and by entry and lane.
    std::vector<std::uint32_t> entries, tangents;
};

/// `held`: slots of which the value of a row lasts to the next one (empty: none; the matrix of exact steps tells by
/// itself). Null: the target is not to be had, or other slots jump from row to row.
std::shared_ptr<const RowCode> compileRows(const SystemPrograms& programs, int lanes, bool isExact, VectorTarget target,
                                           const std::vector<char>& held = {});

}  // namespace analogon
