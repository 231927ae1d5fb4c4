#include "core/eval/machine.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

/// Value of an instruction that is no block.
inline double valueOf(const Instruction& i, const double* v, const ProgramTables& tables, const double* constants) {
    const double a = v[i.a];
    switch (i.opcode) {
        // clang-format off
        case Opcode::LoadConstant: return constants[i.a];
        case Opcode::Copy: return a;
        case Opcode::Negate: return -a;
        case Opcode::Add: return a + v[i.b];
        case Opcode::Subtract: return a - v[i.b];
        case Opcode::Multiply: return a * v[i.b];
        case Opcode::Divide: return a / v[i.b];
        case Opcode::Power: return std::pow(a, v[i.b]);
        case Opcode::Square: return a * a;
        case Opcode::Less: return a < v[i.b];
        case Opcode::LessEqual: return a <= v[i.b];
        case Opcode::Greater: return a > v[i.b];
        case Opcode::GreaterEqual: return a >= v[i.b];
        case Opcode::Equal: return a == v[i.b];
        case Opcode::NotEqual: return a != v[i.b];
        case Opcode::And: return a != 0 && v[i.b] != 0;
        case Opcode::Or: return a != 0 || v[i.b] != 0;
        case Opcode::Not: return a == 0;
        case Opcode::Select: return a != 0 ? v[i.b] : v[i.c];
        case Opcode::Abs: return std::fabs(a);
        case Opcode::Sign: return (a > 0) - (a < 0);
        case Opcode::Sqrt: return std::sqrt(a);
        case Opcode::Exp: return std::exp(a);
        case Opcode::Log: return std::log(a);
        case Opcode::Log10: return std::log10(a);
        case Opcode::Sin: return std::sin(a);
        case Opcode::Cos: return std::cos(a);
        case Opcode::Tan: return std::tan(a);
        case Opcode::Asin: return std::asin(a);
        case Opcode::Acos: return std::acos(a);
        case Opcode::Atan: return std::atan(a);
        case Opcode::Atan2: return std::atan2(a, v[i.b]);
        case Opcode::Sinh: return std::sinh(a);
        case Opcode::Cosh: return std::cosh(a);
        case Opcode::Tanh: return std::tanh(a);
        case Opcode::Min: return v[i.b] < a ? v[i.b] : a;
        case Opcode::Max: return v[i.b] > a ? v[i.b] : a;
        case Opcode::Floor: return std::floor(a);
        case Opcode::Ceil: return std::ceil(a);
        case Opcode::Mod: return a - std::floor(a / v[i.b]) * v[i.b];
        case Opcode::Rem: return a - std::trunc(a / v[i.b]) * v[i.b];
        case Opcode::Div: return std::trunc(a / v[i.b]);
        case Opcode::Table: return tables.lookups[i.b].value(a);
        case Opcode::TableDerivative: return tables.lookups[i.b].derivative(a);
        case Opcode::SolveLinear:
        case Opcode::SolveNonlinear: break;
            // clang-format on
    }
    return 0;
}

/// Partial derivatives of an instruction in its operands.
struct Slopes {
    double a{}, b{};
};

/// Where a value is finite and its slope is not (the root at 0), the slope counts as 0: a fit that passes
/// through such a point should not end there.
inline double finiteOrZero(double slope) { return std::isfinite(slope) ? slope : 0; }

inline Slopes powerSlopes(double a, double b, double value) {
    Slopes s;
    s.a = a != 0 ? b * value / a : finiteOrZero(b * std::pow(a, b - 1));
    s.b = a > 0 ? value * std::log(a) : 0;
    return s;
}

inline Slopes slopesOf(const Instruction& i, const double* v, const ProgramTables& tables, double value) {
    const double a = v[i.a];
    switch (i.opcode) {
        // clang-format off
        case Opcode::Copy: return {1, 0};
        case Opcode::Negate: return {-1, 0};
        case Opcode::Add: return {1, 1};
        case Opcode::Subtract: return {1, -1};
        case Opcode::Multiply: return {v[i.b], a};
        case Opcode::Divide: { const double r = 1 / v[i.b]; return {r, -value * r}; }
        case Opcode::Power: return powerSlopes(a, v[i.b], value);
        case Opcode::Square: return {2 * a, 0};
        case Opcode::Abs: return {static_cast<double>((a > 0) - (a < 0)), 0};
        case Opcode::Sqrt: return {finiteOrZero(0.5 / value), 0};
        case Opcode::Exp: return {value, 0};
        case Opcode::Log: return {1 / a, 0};
        case Opcode::Log10: return {1 / (a * 2.302585092994045684), 0};
        case Opcode::Sin: return {std::cos(a), 0};
        case Opcode::Cos: return {-std::sin(a), 0};
        case Opcode::Tan: return {1 + value * value, 0};
        case Opcode::Asin: return {finiteOrZero(1 / std::sqrt(1 - a * a)), 0};
        case Opcode::Acos: return {finiteOrZero(-1 / std::sqrt(1 - a * a)), 0};
        case Opcode::Atan: return {1 / (1 + a * a), 0};
        case Opcode::Atan2: {
            const double b = v[i.b], r = 1 / (a * a + b * b);
            return {finiteOrZero(b * r), finiteOrZero(-a * r)};
        }
        case Opcode::Sinh: return {std::cosh(a), 0};
        case Opcode::Cosh: return {std::sinh(a), 0};
        case Opcode::Tanh: return {1 - value * value, 0};
        case Opcode::Min: return v[i.b] < a ? Slopes{0, 1} : Slopes{1, 0};
        case Opcode::Max: return v[i.b] > a ? Slopes{0, 1} : Slopes{1, 0};
        case Opcode::Mod: return {1, -std::floor(a / v[i.b])};
        case Opcode::Rem: return {1, -std::trunc(a / v[i.b])};
        case Opcode::Table: return {tables.lookups[i.b].derivative(a), 0};
        case Opcode::TableDerivative: return {tables.slopes[i.b].derivative(a), 0};
        default: return {};
            // clang-format on
    }
}

/// The instructions of `code` on values and tangents; L > 0 fixes the number of lanes for the compiler, 0 takes
/// it from the registers. Always inlined, so that it takes the instruction set of the function around it.
template <int L>
[[gnu::always_inline]] inline bool runLoop(const std::vector<Instruction>& code, const double* constants,
                                           const ProgramTables& tables, Registers& registers, TangentMode mode) {
    double* const v = registers.values.data();
    double* const d = registers.tangents.data();
    const std::size_t n = L > 0 ? static_cast<std::size_t>(L) : static_cast<std::size_t>(registers.lanes);
    for (const Instruction& i : code) {
        double* __restrict const out = d + i.dst * n;
        const double* __restrict const da = d + i.a * n;
        const double* __restrict const db = d + i.b * n;
        switch (i.kernel[mode]) {
            case Kernel::Value:
                if (i.opcode == Opcode::SolveLinear) {
                    if (!solveLinear(i.a, tables, registers, mode)) return false;
                } else if (i.opcode == Opcode::SolveNonlinear) {
                    if (!solveNonlinear(i.a, tables, registers, mode)) return false;
                } else {
                    v[i.dst] = valueOf(i, v, tables, constants);
                }
                break;
            case Kernel::AddBoth:
                v[i.dst] = v[i.a] + v[i.b];
                for (std::size_t k = 0; k < n; ++k) out[k] = da[k] + db[k];
                break;
            case Kernel::AddOne: {
                v[i.dst] = v[i.a] + v[i.b];
                const double* __restrict const from = i.active[mode] == 1 ? da : db;
                for (std::size_t k = 0; k < n; ++k) out[k] = from[k];
                break;
            }
            case Kernel::SubtractBoth:
                v[i.dst] = v[i.a] - v[i.b];
                for (std::size_t k = 0; k < n; ++k) out[k] = da[k] - db[k];
                break;
            case Kernel::SubtractFirst:
                v[i.dst] = v[i.a] - v[i.b];
                for (std::size_t k = 0; k < n; ++k) out[k] = da[k];
                break;
            case Kernel::SubtractSecond:
                v[i.dst] = v[i.a] - v[i.b];
                for (std::size_t k = 0; k < n; ++k) out[k] = -db[k];
                break;
            case Kernel::MultiplyBoth: {
                const double a = v[i.a], b = v[i.b];
                v[i.dst] = a * b;
                for (std::size_t k = 0; k < n; ++k) out[k] = b * da[k] + a * db[k];
                break;
            }
            case Kernel::MultiplyOne: {
                const bool isFirst = i.active[mode] == 1;
                const double factor = isFirst ? v[i.b] : v[i.a];
                v[i.dst] = v[i.a] * v[i.b];
                const double* __restrict const from = isFirst ? da : db;
                for (std::size_t k = 0; k < n; ++k) out[k] = factor * from[k];
                break;
            }
            case Kernel::DivideBoth: {
                const double value = v[i.a] / v[i.b], r = 1 / v[i.b];
                v[i.dst] = value;
                for (std::size_t k = 0; k < n; ++k) out[k] = r * (da[k] - value * db[k]);
                break;
            }
            case Kernel::DivideFirst: {
                const double r = 1 / v[i.b];
                v[i.dst] = v[i.a] / v[i.b];
                for (std::size_t k = 0; k < n; ++k) out[k] = r * da[k];
                break;
            }
            case Kernel::DivideSecond: {
                const double value = v[i.a] / v[i.b], s = -value / v[i.b];
                v[i.dst] = value;
                for (std::size_t k = 0; k < n; ++k) out[k] = s * db[k];
                break;
            }
            case Kernel::Negate:
                v[i.dst] = -v[i.a];
                for (std::size_t k = 0; k < n; ++k) out[k] = -da[k];
                break;
            case Kernel::Square: {
                const double s = 2 * v[i.a];
                v[i.dst] = v[i.a] * v[i.a];
                for (std::size_t k = 0; k < n; ++k) out[k] = s * da[k];
                break;
            }
            case Kernel::Select: {
                const bool isFirst = v[i.a] != 0;
                v[i.dst] = isFirst ? v[i.b] : v[i.c];
                const double* __restrict const from = isFirst ? db : d + i.c * n;
                const bool moves = (i.active[mode] & (isFirst ? 2u : 4u)) != 0;
                for (std::size_t k = 0; k < n; ++k) out[k] = moves ? from[k] : 0;
                break;
            }
            case Kernel::Unary: {
                const double value = valueOf(i, v, tables, constants);
                const double s = slopesOf(i, v, tables, value).a;
                v[i.dst] = value;
                for (std::size_t k = 0; k < n; ++k) out[k] = s * da[k];
                break;
            }
            case Kernel::Binary: {
                const double value = valueOf(i, v, tables, constants);
                const Slopes s = slopesOf(i, v, tables, value);
                const unsigned active = i.active[mode];
                v[i.dst] = value;
                if (active == 1)
                    for (std::size_t k = 0; k < n; ++k) out[k] = s.a * da[k];
                else if (active == 2)
                    for (std::size_t k = 0; k < n; ++k) out[k] = s.b * db[k];
                else
                    for (std::size_t k = 0; k < n; ++k) out[k] = s.a * da[k] + s.b * db[k];
                break;
            }
        }
    }
    return true;
}

using TangentRun = bool (*)(const std::vector<Instruction>&, const double*, const ProgramTables&, Registers&,
                            TangentMode);

template <int L>
bool runPlain(const std::vector<Instruction>& code, const double* constants, const ProgramTables& tables,
              Registers& registers, TangentMode mode) {
    return runLoop<L>(code, constants, tables, registers, mode);
}

#if defined(__x86_64__) && defined(__GNUC__)
// Wider vectors where the processor has them. Without fused multiply-add, so that results are the same
// everywhere to the last bit.
template <int L>
[[gnu::target("avx2")]] bool runWide(const std::vector<Instruction>& code, const double* constants,
                                     const ProgramTables& tables, Registers& registers, TangentMode mode) {
    return runLoop<L>(code, constants, tables, registers, mode);
}
bool hasWideVectors() { return __builtin_cpu_supports("avx2"); }
#else
template <int L>
bool runWide(const std::vector<Instruction>& code, const double* constants, const ProgramTables& tables,
             Registers& registers, TangentMode mode) {
    return runLoop<L>(code, constants, tables, registers, mode);
}
bool hasWideVectors() { return false; }
#endif

template <int L>
TangentRun chooseRun() {
    static const TangentRun run = hasWideVectors() ? runWide<L> : runPlain<L>;
    return run;
}

bool dispatch(const std::vector<Instruction>& code, const std::vector<double>& constants, const ProgramTables& tables,
              Registers& registers, TangentMode mode) {
    TangentRun run{};
    switch (registers.lanes) {
        case 4:
            run = chooseRun<4>();
            break;
        case 8:
            run = chooseRun<8>();
            break;
        case 12:
            run = chooseRun<12>();
            break;
        case 16:
            run = chooseRun<16>();
            break;
        default:
            run = chooseRun<0>();
    }
    return run(code, constants.data(), tables, registers, mode);
}

bool values(const std::vector<Instruction>& code, const std::vector<double>& constants, const ProgramTables& tables,
            Registers& registers) {
    double* const v = registers.values.data();
    for (const Instruction& i : code) {
        if (i.opcode == Opcode::SolveLinear) {
            if (!solveLinear(i.a, tables, registers, -1)) return false;
        } else if (i.opcode == Opcode::SolveNonlinear) {
            if (!solveNonlinear(i.a, tables, registers, -1)) return false;
        } else {
            v[i.dst] = valueOf(i, v, tables, constants.data());
        }
    }
    return true;
}

}  // namespace

void Registers::resize(std::size_t registers, std::size_t guessCount) {
    if (values.size() < registers) {
        values.resize(registers, 0);
        tangents.resize(registers * static_cast<std::size_t>(lanes), 0);
    }
    if (guesses.size() < guessCount) {
        guesses.resize(guessCount, 0);
        hasGuess.resize(guessCount, 0);
    }
}

bool runValues(const Program& program, const ProgramTables& tables, Registers& registers) {
    return values(program.code, program.constants, tables, registers);
}

bool runTangents(const Program& program, const ProgramTables& tables, Registers& registers, TangentMode mode) {
    return dispatch(program.code, program.constants, tables, registers, mode);
}

void runBodyValues(const std::vector<Instruction>& code, const ProgramTables& tables, Registers& registers) {
    values(code, {}, tables, registers);
}

void runBodyTangents(const std::vector<Instruction>& code, const ProgramTables& tables, Registers& registers,
                     TangentMode mode) {
    dispatch(code, {}, tables, registers, mode);
}

}  // namespace analogon
