#pragma once

#include <array>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "core/eval/block_factors.hpp"
#include "core/eval/program.hpp"
#include "core/eval/vector_code.hpp"

namespace analogon {

struct SystemCode;
struct RecurrenceCode;
struct RowCode;

/// Memory on lines of the cache, so that wide vectors do not straddle them.
template <class T>
struct LineAllocator {
    using value_type = T;
    LineAllocator() = default;
    template <class U>
    LineAllocator(const LineAllocator<U>&) {}
    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
    void deallocate(T* at, std::size_t) { ::operator delete(at, line); }
    friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
    static constexpr std::align_val_t line{64};
};
using LineVector = std::vector<double, LineAllocator<double>>;

/// The registers of one evaluation thread. Tangents are padded to `lanes` a register so that loops over them
/// have a fixed width.
struct Registers {
    int directions{};  // asked for
    int lanes{};       // directions rounded up to a multiple of 4
    LineVector values;
    LineVector tangents;          // register r, direction k at [r * lanes + k]
    std::vector<double> guesses;  // last solutions of the nonlinear blocks
    std::vector<char> hasGuess;   // by the same places
    std::vector<double> matrix, vector, trial, start, scale, rowScale, rows;  // scratch of the solvers
    std::vector<int> pivots;
    std::vector<BlockFactors> linear, nonlinear;  // by the number of the block, of those that are large
    std::string failure;
    bool failedToSolve{};

    VectorTarget target{};
    struct Code {
        int runs{};                              // before it was made
        std::shared_ptr<const SystemCode> made;  // null: not yet
        std::array<LineVector, 3> scratch;       // of its functions: derivative, output, step
        struct Body {
            LineVector values, tangents;
        };
        std::vector<Body> bodies;  // scratch of the bodies of the nonlinear blocks
    };
    std::array<Code, 2> code;  // by TangentMode

    std::shared_ptr<const RecurrenceCode> recurrence;  // with its matrices in the scratch memory
    LineVector recurrenceScratch;

    std::shared_ptr<const RowCode> rowCode;
    std::array<LineVector, 3> rowScratch;  // walk, step, tabulation

    void resize(std::size_t registers, std::size_t guessCount);
};

/// Runs programs on registers. `mode` says whether input registers carry tangents. A block that cannot be
/// solved ends the run with false and its unknown in `failure`.
bool runValues(const Program& program, const ProgramTables& tables, Registers& registers);
bool runTangents(const Program& program, const ProgramTables& tables, Registers& registers, TangentMode mode);

// One straight stretch of code without blocks, for the solvers.
void runBodyValues(const std::vector<Instruction>& code, const ProgramTables& tables, Registers& registers);
void runBodyTangents(const std::vector<Instruction>& code, const ProgramTables& tables, Registers& registers,
                     TangentMode mode);

// The blocks (solvers.cpp). With tangents when `mode` >= 0.
bool solveLinear(std::size_t number, const ProgramTables& tables, Registers& registers, int mode);
bool solveNonlinear(std::size_t number, const ProgramTables& tables, Registers& registers, int mode);

/// LU factors with scaled partial pivoting, row-major in place (Golub & Van Loan, section 3.4). False when
/// singular to working precision.
bool factorise(std::span<double> matrix, std::span<int> pivots, std::span<double> scale);
/// Solves with the factors, in place; `stride` is the distance of two entries of the right-hand side and
/// `width` the number of right-hand sides beside each other.
void substitute(std::span<const double> matrix, std::span<const int> pivots, double* right, int stride, int width);

}  // namespace analogon
