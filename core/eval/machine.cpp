#include "core/eval/machine.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

/// Value of an instruction that is neither a block nor a constant.
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
        case Opcode::TableDerivative: {
            LookupTable slope = tables.lookups[i.b];
            ++slope.order;
            return {slope.derivative(a), 0};
        }
        default: return {};
            // clang-format on
    }
}

/// out := sa * da + sb * db over the lanes; L > 0 fixes their number for the compiler.
template <int L>
struct Lanes {
    int count;
    int width() const { return L > 0 ? L : count; }
    void zero(double* __restrict out) const {
        for (int k = 0; k < width(); ++k) out[k] = 0;
    }
    void copy(double* __restrict out, const double* __restrict a) const {
        for (int k = 0; k < width(); ++k) out[k] = a[k];
    }
    void scale(double* __restrict out, double s, const double* __restrict a) const {
        for (int k = 0; k < width(); ++k) out[k] = s * a[k];
    }
    void combine(double* __restrict out, double s, const double* __restrict a, double t,
                 const double* __restrict b) const {
        for (int k = 0; k < width(); ++k) out[k] = s * a[k] + t * b[k];
    }
};

template <int L>
inline void stepTangents(const Instruction& i, unsigned active, double* v, double* d, Lanes<L> lanes,
                         const ProgramTables& tables) {
    const double value = valueOf(i, v, tables, nullptr);
    v[i.dst] = value;
    const auto at = [&](std::uint32_t reg) {
        return d + static_cast<std::size_t>(reg) * static_cast<std::size_t>(lanes.width());
    };
    double* out = at(i.dst);
    switch (i.opcode) {  // the bulk of every program
        case Opcode::Add:
            if (active == 3) return lanes.combine(out, 1, at(i.a), 1, at(i.b));
            return lanes.copy(out, at(active == 1 ? i.a : i.b));
        case Opcode::Multiply:
            if (active == 3) return lanes.combine(out, v[i.b], at(i.a), v[i.a], at(i.b));
            return active == 1 ? lanes.scale(out, v[i.b], at(i.a)) : lanes.scale(out, v[i.a], at(i.b));
        case Opcode::Select: {
            const bool first = v[i.a] != 0;
            if (!(active & (first ? 2u : 4u))) return lanes.zero(out);
            return lanes.copy(out, at(first ? i.b : i.c));
        }
        default:
            break;
    }
    const Slopes s = slopesOf(i, v, tables, value);
    switch (active) {
        case 1:
            return lanes.scale(out, s.a, at(i.a));
        case 2:
            return lanes.scale(out, s.b, at(i.b));
        default:
            return lanes.combine(out, s.a, at(i.a), s.b, at(i.b));
    }
}

template <int L>
bool runWith(const std::vector<Instruction>& code, const std::vector<double>& constants, const ProgramTables& tables,
             Registers& registers, TangentMode mode) {
    double* const v = registers.values.data();
    double* const d = registers.tangents.data();
    const Lanes<L> lanes{registers.lanes};
    for (const Instruction& i : code) {
        if (i.opcode == Opcode::SolveLinear) {
            if (!solveLinear(tables.linear[i.a], registers, mode)) return false;
        } else if (i.opcode == Opcode::SolveNonlinear) {
            if (!solveNonlinear(tables.nonlinear[i.a], tables, registers, mode)) return false;
        } else if (const unsigned active = i.active[mode]) {
            stepTangents(i, active, v, d, lanes, tables);
        } else {
            v[i.dst] = valueOf(i, v, tables, constants.data());
        }
    }
    return true;
}

bool dispatch(const std::vector<Instruction>& code, const std::vector<double>& constants, const ProgramTables& tables,
              Registers& registers, TangentMode mode) {
    switch (registers.lanes) {
        case 4:
            return runWith<4>(code, constants, tables, registers, mode);
        case 8:
            return runWith<8>(code, constants, tables, registers, mode);
        case 12:
            return runWith<12>(code, constants, tables, registers, mode);
        case 16:
            return runWith<16>(code, constants, tables, registers, mode);
        default:
            return runWith<0>(code, constants, tables, registers, mode);
    }
}

bool values(const std::vector<Instruction>& code, const std::vector<double>& constants, const ProgramTables& tables,
            Registers& registers) {
    double* const v = registers.values.data();
    for (const Instruction& i : code) {
        if (i.opcode == Opcode::SolveLinear) {
            if (!solveLinear(tables.linear[i.a], registers, -1)) return false;
        } else if (i.opcode == Opcode::SolveNonlinear) {
            if (!solveNonlinear(tables.nonlinear[i.a], tables, registers, -1)) return false;
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
