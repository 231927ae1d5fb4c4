#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/flat/expression.hpp"

/// The register program a system is lowered to: straight-line code in single assignment form. A machine-code
/// back end can take the same programs; nothing outside core/eval sees them.
namespace analogon {

enum class Opcode : std::uint8_t {
    LoadConstant,  // dst := constants[a]
    Copy,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Square,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Not,
    Select,  // dst := a != 0 ? b : c
    Abs,
    Sign,
    Sqrt,
    Exp,
    Log,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Min,
    Max,
    Floor,
    Ceil,
    Mod,
    Rem,
    Div,
    Table,            // b: number of the table
    TableDerivative,  // b: number of the table
    SolveLinear,      // a: number of the linear block
    SolveNonlinear    // a: number of the nonlinear block
};

const char* nameOf(Opcode opcode);
/// How many of the operands a, b, c are registers.
int registerOperands(Opcode opcode);

/// What carries tangents: inputs only when the caller gives directions for them.
enum TangentMode : int { InputsConstant = 0, InputsVary = 1 };

/// What a step with tangents does: the common operations are told apart by which operands carry tangents, so
/// that one jump leads to code that does nothing else.
enum class Kernel : std::uint8_t {
    Value,  // no operand carries tangents, or a block
    AddBoth,
    AddOne,  // tangents of a; for b the operands are exchanged
    SubtractBoth,
    SubtractFirst,
    SubtractSecond,
    MultiplyBoth,
    MultiplyOne,  // tangents of a; for b the operands are exchanged
    DivideBoth,
    DivideFirst,
    DivideSecond,
    Negate,
    Square,
    Select,
    Unary,  // anything else with one operand that carries tangents
    Binary  // anything else with two operands
};

/// dst := opcode(a, b, c), operands are registers unless said otherwise.
struct Instruction {
    Opcode opcode{};
    std::array<std::uint8_t, 2> active{};  // by TangentMode: bits of the operands a (1), b (2), c (4) with tangents
    std::array<Kernel, 2> kernel{};        // by TangentMode
    std::uint32_t dst{}, a{}, b{}, c{};
};

/// matrix * unknowns + constant = 0, matrix row-major.
struct LinearBlock {
    std::vector<std::uint32_t> unknowns, matrix, constant;
    std::vector<std::uint32_t> entries;                 // of the matrix that are not 0 in every model: row * n + column
    std::array<std::uint8_t, 2> active{};               // whether the block has tangents at all, by TangentMode
    std::vector<std::array<std::uint8_t, 2>> activeOf;  // of matrix, then of constant
    std::vector<std::string> names;
};

/// residuals(unknowns) = 0; `body` computes residuals and Jacobian from the unknowns' registers.
struct NonlinearBlock {
    std::vector<std::uint32_t> unknowns, residuals, jacobian, starts;
    std::vector<std::uint32_t> entries;  // of the Jacobian, as of a linear block
    std::vector<double> nominal;
    std::vector<Instruction> body;
    std::array<std::uint8_t, 2> active{};
    std::vector<std::array<std::uint8_t, 2>> activeOf;  // of residuals
    std::uint32_t guess{};                              // where the workspace keeps the last solution
    std::vector<std::string> names;
};

struct Program {
    std::vector<Instruction> code;
    std::vector<double> constants;                               // of LoadConstant
    std::vector<std::pair<std::uint32_t, std::string>> watched;  // registers of named unknowns, in order
    std::uint32_t registerCount{};                               // it uses registers below this
};

/// The kernel for an opcode whose operands in `active` carry tangents.
Kernel kernelOf(Opcode opcode, unsigned active);

/// What programs refer to by number.
struct ProgramTables {
    std::vector<LookupTable> lookups;
    std::vector<LookupTable> slopes;  // their derivatives, beside them
    std::vector<LinearBlock> linear;
    std::vector<NonlinearBlock> nonlinear;
};

}  // namespace analogon
