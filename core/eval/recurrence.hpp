#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/eval/program_emitter.hpp"

namespace analogon {

/// x' = A x + B u + c at some parameters, with K tangents: row-major n x (n + m + 1), [A B c].
struct LinearRates {
    int states{}, slots{}, directions{};
    std::vector<double> matrix;
    std::vector<double> tangents;  // each entry's K tangents

    int columns() const { return states + slots + 1; }
};

/// x(t + h) = F x + G0 u(t) + G1 u(t + h) + g for inputs that run linearly in between (first-order hold: Franklin,
/// Powell & Workman, Digital Control of Dynamic Systems, section 4.3), row-major n x (n + 2 m + 1), with tangents. From
/// the exponential of an augmented matrix (Van Loan, IEEE Trans. Autom. Control 23 (1978) 395-404), by scaling and
/// squaring.
struct LinearRecurrence {
    std::vector<double> matrix, tangents;
};
LinearRecurrence recurrenceOf(const LinearRates& rates, double h);
/// The same where some inputs keep the value that they have at t (zero-order hold): what multiplied u(t + h) multiplies
/// u(t) as well, and u(t + h) counts for nothing.
void holdInputs(LinearRecurrence& recurrence, std::size_t states, std::size_t slots, const std::vector<char>& held);

/// The recurrence as code on the registers of the states.
struct RecurrenceCode {
    CompiledProgram program;
    std::uint32_t begin{}, end{};         // first of u at the begin and the end, in the scratch memory
    std::vector<std::uint32_t> entries;   // by entry of the matrix
    std::vector<std::uint32_t> tangents;  // by entry and lane
};

/// One step from and to the registers of the states, with u at its begin and end. `entries` and `tangents` receive the
/// places in the scratch memory as in RecurrenceCode.
void emitRecurrence(const SystemPrograms& programs, ProgramEmitter& emitter,
                    const std::vector<VectorCode::Entity>& begin, const std::vector<VectorCode::Entity>& end,
                    std::vector<std::uint32_t>& entries, std::vector<std::uint32_t>& tangents);

/// Null: the target is not to be had.
std::shared_ptr<const RecurrenceCode> compileRecurrence(const SystemPrograms& programs, int lanes, VectorTarget target);

}  // namespace analogon
