#include <algorithm>
#include <cmath>

#include "core/eval/program_emitter.hpp"
#include "core/eval/runge_kutta_code.hpp"

namespace analogon {

/// What a call of a block needs to know.
struct CompiledProgram::Block {
    const ProgramTables* tables{};
    std::uint32_t number{};
    bool isLinear{};
    int mode{-1};
};

CompiledProgram::CompiledProgram() = default;
CompiledProgram::CompiledProgram(CompiledProgram&&) noexcept = default;
CompiledProgram& CompiledProgram::operator=(CompiledProgram&&) noexcept = default;
CompiledProgram::~CompiledProgram() = default;

namespace {

using Entity = VectorCode::Entity;
using Op = VectorCode::Operation;
constexpr Entity none = VectorCode::none;

bool runBlock(Registers* registers, const void* data) {
    const auto& block = *static_cast<const CompiledProgram::Block*>(data);
    return block.isLinear ? solveLinear(block.number, *block.tables, *registers, block.mode)
                          : solveNonlinear(block.number, *block.tables, *registers, block.mode);
}

// Values and slopes as the interpreter has them (machine.cpp).
double finiteOrZero(double slope) { return std::isfinite(slope) ? slope : 0; }
double powerSlopeA(double a, double b, double value) {
    return a != 0 ? b * value / a : finiteOrZero(b * std::pow(a, b - 1));
}
double powerSlopeB(double a, double, double value) { return a > 0 ? value * std::log(a) : 0; }
double asinSlope(double a) { return finiteOrZero(1 / std::sqrt(1 - a * a)); }
double acosSlope(double a) { return finiteOrZero(-1 / std::sqrt(1 - a * a)); }
double atan2SlopeA(double a, double b) { return finiteOrZero(b / (a * a + b * b)); }
double atan2SlopeB(double a, double b) { return finiteOrZero(-a / (a * a + b * b)); }
double modulo(double a, double b) { return a - std::floor(a / b) * b; }
double remainder(double a, double b) { return a - std::trunc(a / b) * b; }
double quotient(double a, double b) { return std::trunc(a / b); }
double minusFloor(double a, double b) { return -std::floor(a / b); }
double minusTrunc(double a, double b) { return -std::trunc(a / b); }
double tableValue(const void* table, double a) { return static_cast<const LookupTable*>(table)->value(a); }
double tableSlope(const void* table, double a) { return static_cast<const LookupTable*>(table)->derivative(a); }

using Unary = double (*)(double);
using Binary = double (*)(double, double);
using Ternary = double (*)(double, double, double);
using Looked = double (*)(const void*, double);
template <class Function>
const void* address(Function function) {
    return reinterpret_cast<const void*>(function);
}

}  // namespace

Entity ProgramEmitter::unary(Unary function, Entity a) { return code_.call(address(function), nullptr, a); }
Entity ProgramEmitter::binary(Binary function, Entity a, Entity b) {
    return code_.call(address(function), nullptr, a, b);
}
Entity ProgramEmitter::ternary(Ternary function, Entity a, Entity b, Entity c) {
    return code_.call(address(function), nullptr, a, b, c);
}
Entity ProgramEmitter::lookUp(Looked function, const LookupTable& table, Entity a) {
    return code_.call(address(function), &table, a);
}

Entity ProgramEmitter::valueOf(const Instruction& i, const Program& program, Entity a, Entity b, Entity c) {
    switch (i.opcode) {
        // clang-format off
        case Opcode::LoadConstant: return constant(program.constants[i.a]);
        case Opcode::Copy: return a;
        case Opcode::Negate: return negative(a);
        case Opcode::Add: return emit(Op::Add, a, b);
        case Opcode::Subtract: return emit(Op::Subtract, a, b);
        case Opcode::Multiply: return emit(Op::Multiply, a, b);
        case Opcode::Divide: return emit(Op::Divide, a, b);
        case Opcode::Power: return binary(std::pow, a, b);
        case Opcode::Square: return emit(Op::Multiply, a, a);
        case Opcode::Less: return emit(Op::Less, a, b);
        case Opcode::LessEqual: return emit(Op::LessEqual, a, b);
        case Opcode::Greater: return emit(Op::Less, b, a);
        case Opcode::GreaterEqual: return emit(Op::LessEqual, b, a);
        case Opcode::Equal: return emit(Op::Equal, a, b);
        case Opcode::NotEqual: return emit(Op::NotEqual, a, b);
        case Opcode::And: return emit(Op::Select, a, emit(Op::NotEqual, b, constant(0)), constant(0));
        case Opcode::Or: return emit(Op::Select, a, constant(1), emit(Op::NotEqual, b, constant(0)));
        case Opcode::Not: return emit(Op::Equal, a, constant(0));
        case Opcode::Select: return emit(Op::Select, a, b, c);
        case Opcode::Abs: return emit(Op::Absolute, a);
        case Opcode::Sign: return emit(Op::Subtract, emit(Op::Less, constant(0), a), emit(Op::Less, a, constant(0)));
        case Opcode::Sqrt: return emit(Op::SquareRoot, a);
        case Opcode::Exp: return unary(std::exp, a);
        case Opcode::Log: return unary(std::log, a);
        case Opcode::Log10: return unary(std::log10, a);
        case Opcode::Sin: return unary(std::sin, a);
        case Opcode::Cos: return unary(std::cos, a);
        case Opcode::Tan: return unary(std::tan, a);
        case Opcode::Asin: return unary(std::asin, a);
        case Opcode::Acos: return unary(std::acos, a);
        case Opcode::Atan: return unary(std::atan, a);
        case Opcode::Atan2: return binary(std::atan2, a, b);
        case Opcode::Sinh: return unary(std::sinh, a);
        case Opcode::Cosh: return unary(std::cosh, a);
        case Opcode::Tanh: return unary(std::tanh, a);
        case Opcode::Min: return emit(Op::Select, emit(Op::Less, b, a), b, a);
        case Opcode::Max: return emit(Op::Select, emit(Op::Less, a, b), b, a);
        case Opcode::Floor: return unary(std::floor, a);
        case Opcode::Ceil: return unary(std::ceil, a);
        case Opcode::Mod: return binary(modulo, a, b);
        case Opcode::Rem: return binary(remainder, a, b);
        case Opcode::Div: return binary(quotient, a, b);
        case Opcode::Table: return lookUp(tableValue, s_.tables.lookups[i.b], a);
        case Opcode::TableDerivative: return lookUp(tableSlope, s_.tables.lookups[i.b], a);
        case Opcode::SolveLinear:
        case Opcode::SolveNonlinear: break;
            // clang-format on
    }
    return none;
}

Entity ProgramEmitter::slopeA(const Instruction& i, Entity a, Entity b, Entity value) {
    switch (i.opcode) {
        // clang-format off
        case Opcode::Power: return ternary(powerSlopeA, a, b, value);
        case Opcode::Abs: return emit(Op::Subtract, emit(Op::Less, constant(0), a), emit(Op::Less, a, constant(0)));
        case Opcode::Sqrt: return emit(Op::Select, value, emit(Op::Divide, constant(0.5), value), constant(0));
        case Opcode::Exp: return value;
        case Opcode::Log: return emit(Op::Divide, constant(1), a);
        case Opcode::Log10: return emit(Op::Divide, constant(1 / 2.302585092994045684), a);
        case Opcode::Sin: return unary(std::cos, a);
        case Opcode::Cos: return negative(unary(std::sin, a));
        case Opcode::Tan: return emit(Op::MultiplyAdd, value, value, constant(1));
        case Opcode::Asin: return unary(asinSlope, a);
        case Opcode::Acos: return unary(acosSlope, a);
        case Opcode::Atan: return emit(Op::Divide, constant(1), emit(Op::MultiplyAdd, a, a, constant(1)));
        case Opcode::Atan2: return binary(atan2SlopeA, a, b);
        case Opcode::Sinh: return unary(std::cosh, a);
        case Opcode::Cosh: return unary(std::sinh, a);
        case Opcode::Tanh: return emit(Op::NegativeMultiply, value, value, constant(1));
        case Opcode::Min: return emit(Op::Equal, emit(Op::Less, b, a), constant(0));
        case Opcode::Max: return emit(Op::Equal, emit(Op::Less, a, b), constant(0));
        case Opcode::Mod:
        case Opcode::Rem: return constant(1);
        case Opcode::Table: return lookUp(tableSlope, s_.tables.lookups[i.b], a);
        case Opcode::TableDerivative: return lookUp(tableSlope, s_.tables.slopes[i.b], a);
        default: return constant(0);
            // clang-format on
    }
}

Entity ProgramEmitter::slopeB(const Instruction& i, Entity a, Entity b, Entity value) {
    switch (i.opcode) {
        // clang-format off
        case Opcode::Power: return ternary(powerSlopeB, a, b, value);
        case Opcode::Atan2: return binary(atan2SlopeB, a, b);
        case Opcode::Min: return emit(Op::Less, b, a);
        case Opcode::Max: return emit(Op::Less, a, b);
        case Opcode::Mod: return binary(minusFloor, a, b);
        case Opcode::Rem: return binary(minusTrunc, a, b);
        default: return constant(0);
            // clang-format on
    }
}

void ProgramEmitter::instruction(const Instruction& i, const Program& program) {
    const int operands = registerOperands(i.opcode);
    const Entity a = operands > 0 ? value(i.a) : none;
    const Entity b = operands > 1 ? value(i.b) : none;
    const Entity c = operands > 2 ? value(i.c) : none;
    const Entity result = valueOf(i, program, a, b, c);
    if (lanes_ > 0 && i.active[mode_] != 0) tangentsOf(i, a, b, result);
    bind(i.dst, result);
}

/// d dst = factor * d from
void ProgramEmitter::scaled(const Instruction& i, Entity factor, std::uint32_t from) {
    perChunk(i.dst,
             [&](std::size_t c, int width) { return code_.emit(Op::Multiply, width, factor, tangent(from, c)); });
}

void ProgramEmitter::tangentsOf(const Instruction& i, Entity a, Entity b, Entity value) {
    const auto same = [&](std::uint32_t from) {
        perChunk(i.dst, [&](std::size_t c, int) { return tangent(from, c); });
    };
    const auto minus = [&](std::uint32_t from) {
        perChunk(i.dst,
                 [&](std::size_t c, int width) { return code_.emit(Op::Subtract, width, zero(c), tangent(from, c)); });
    };
    const auto both = [&](Op operation) {
        perChunk(i.dst, [&](std::size_t c, int width) {
            return code_.emit(operation, width, tangent(i.a, c), tangent(i.b, c));
        });
    };
    const auto twoProducts = [&](Entity first, Entity second) {
        perChunk(i.dst, [&](std::size_t c, int width) {
            const Entity part = code_.emit(Op::Multiply, width, first, tangent(i.a, c));
            return code_.emit(Op::MultiplyAdd, width, second, tangent(i.b, c), part);
        });
    };
    const unsigned active = i.active[mode_];
    switch (i.kernel[mode_]) {
        case Kernel::Value:
            break;
        case Kernel::AddBoth:
            both(Op::Add);
            break;
        case Kernel::AddOne:
            same(active == 1 ? i.a : i.b);
            break;
        case Kernel::SubtractBoth:
            both(Op::Subtract);
            break;
        case Kernel::SubtractFirst:
            same(i.a);
            break;
        case Kernel::SubtractSecond:
            minus(i.b);
            break;
        case Kernel::MultiplyBoth:
            twoProducts(b, a);
            break;
        case Kernel::MultiplyOne:
            scaled(i, active == 1 ? b : a, active == 1 ? i.a : i.b);
            break;
        case Kernel::DivideBoth: {
            const Entity inverse = emit(Op::Divide, constant(1), b);
            perChunk(i.dst, [&](std::size_t c, int width) {
                const Entity rest = code_.emit(Op::NegativeMultiply, width, value, tangent(i.b, c), tangent(i.a, c));
                return code_.emit(Op::Multiply, width, inverse, rest);
            });
            break;
        }
        case Kernel::DivideFirst:
            scaled(i, emit(Op::Divide, constant(1), b), i.a);
            break;
        case Kernel::DivideSecond:
            scaled(i, negative(emit(Op::Divide, value, b)), i.b);
            break;
        case Kernel::Negate:
            minus(i.a);
            break;
        case Kernel::Square:
            scaled(i, emit(Op::Add, a, a), i.a);
            break;
        case Kernel::Select:
            perChunk(i.dst, [&](std::size_t c, int width) {
                const Entity first = active & 2u ? tangent(i.b, c) : zero(c);
                const Entity second = active & 4u ? tangent(i.c, c) : zero(c);
                return code_.emit(Op::Select, width, a, first, second);
            });
            break;
        case Kernel::Unary:
            if (i.opcode == Opcode::Copy) {
                same(i.a);
            } else {
                scaled(i, slopeA(i, a, b, value), i.a);
            }
            break;
        case Kernel::Binary:
            if (active == 1) {
                scaled(i, slopeA(i, a, b, value), i.a);
            } else if (active == 2) {
                scaled(i, slopeB(i, a, b, value), i.b);
            } else {
                const Entity first = slopeA(i, a, b, value);
                twoProducts(first, slopeB(i, a, b, value));
            }
            break;
    }
}

/// All that a block reads goes to its registers.
void ProgramEmitter::settleReads(const Instruction& i, std::vector<Entity>& reads) {
    const auto read = [&](std::uint32_t reg, bool isActive) {
        reads.push_back(settle(reg));
        for (std::size_t c = 0; c < chunks_.size() && isActive; ++c) reads.push_back(settleTangent(reg, c));
    };
    if (i.opcode == Opcode::SolveLinear) {
        const LinearBlock& linear = s_.tables.linear[i.a];
        for (std::size_t k = 0; k < linear.matrix.size(); ++k) read(linear.matrix[k], linear.activeOf[k][mode_] != 0);
        for (std::size_t k = 0; k < linear.constant.size(); ++k)
            read(linear.constant[k], linear.activeOf[linear.matrix.size() + k][mode_] != 0);
        return;
    }
    const NonlinearBlock& nonlinear = s_.tables.nonlinear[i.a];
    std::vector<char> isInner(s_.registerCount, 0);
    for (const std::uint32_t reg : nonlinear.unknowns) isInner[reg] = 1;
    for (const Instruction& inner : nonlinear.body) isInner[inner.dst] = 1;
    std::map<std::uint32_t, bool> outer;  // with whether tangents are read
    for (const Instruction& inner : nonlinear.body) {
        const std::uint32_t operands[] = {inner.a, inner.b, inner.c};
        for (int k = 0; k < registerOperands(inner.opcode); ++k)
            if (!isInner[operands[k]]) {
                bool& isActive = outer[operands[k]];
                isActive = isActive || (inner.active[mode_] >> k & 1u) != 0;
            }
    }
    for (const auto* group : {&nonlinear.starts, &nonlinear.residuals, &nonlinear.jacobian})
        for (const std::uint32_t reg : *group)
            if (!isInner[reg]) outer.try_emplace(reg, false);
    for (std::size_t k = 0; k < nonlinear.residuals.size(); ++k)
        if (nonlinear.activeOf[k][mode_] && !isInner[nonlinear.residuals[k]]) outer[nonlinear.residuals[k]] = true;
    for (const auto& [reg, isActive] : outer) read(reg, isActive);
}

void ProgramEmitter::block(const Instruction& i) {
    const bool isLinear = i.opcode == Opcode::SolveLinear;
    std::vector<Entity> reads;
    settleReads(i, reads);
    auto call = std::make_unique<CompiledProgram::Block>();
    *call = {&s_.tables, i.a, isLinear, lanes_ > 0 ? static_cast<int>(mode_) : -1};
    code_.block(runBlock, call.get(), std::move(reads));
    out_.blocks.push_back(std::move(call));
    const auto& unknowns = isLinear ? s_.tables.linear[i.a].unknowns : s_.tables.nonlinear[i.a].unknowns;
    const bool isActive = (isLinear ? s_.tables.linear[i.a].active : s_.tables.nonlinear[i.a].active)[mode_] != 0;
    // Taken away at once: the next stage of a step solves into the same places.
    for (const std::uint32_t reg : unknowns) {
        const Entity there = code_.add(VectorCode::Space::Values, reg, 1, true);
        bind(reg, emit(Op::Move, there));
        for (std::size_t c = 0; c < chunks_.size() && isActive; ++c) {
            const Entity tangentThere = tangentHome(reg, c, true);
            bindTangent(reg, c, code_.emit(Op::Move, chunks_[c].width, tangentThere));
        }
    }
}

namespace {

bool compileProgram(const SystemPrograms& s, const Program& program, int lanes, TangentMode mode, VectorTarget target,
                    std::initializer_list<const std::vector<ResultRegister>*> results, CompiledProgram& out) {
    ProgramEmitter emitter(s, lanes, target, out, mode);
    emitter.run(program);
    for (const auto* group : results)
        for (const ResultRegister& result : *group) emitter.storeResult(result);
    return emitter.finish();
}

bool compileBody(const SystemPrograms& s, const NonlinearBlock& block, int lanes, TangentMode mode, VectorTarget target,
                 CompiledProgram& out) {
    ProgramEmitter emitter(s, lanes, target, out, mode);
    emitter.runBody(block);
    return emitter.finish();
}

/// One step as a function of its own, the arguments in the scratch memory.
bool compileStep(const SystemPrograms& s, int lanes, VectorTarget target, CompiledProgram& out,
                 StepArguments& arguments) {
    ProgramEmitter emitter(s, lanes, target, out);
    const auto declare = [&](std::uint32_t& offset) {
        const Entity e = emitter.inMemory(1);
        offset = emitter.offsetOf(e);
        return e;
    };
    StepPoints points;
    points.full = declare(arguments.fullStep);
    points.half = declare(arguments.halfStep);
    points.third = declare(arguments.thirdStep);
    points.sixth = declare(arguments.sixthStep);
    for (int p = 0; p < 3; ++p) points.time[p] = declare(arguments.time[p]);
    for (int p = 0; p < 3; ++p)
        for (int i = 0; i < s.layout.slots; ++i) {
            std::uint32_t offset{};
            points.slots[p].push_back(declare(offset));
            if (i == 0) arguments.slots[p] = offset;
        }
    emitRungeKutta(s, emitter, points);
    return emitter.finish();
}

}  // namespace

std::shared_ptr<const SystemCode> compileCode(const SystemPrograms& s, int lanes, TangentMode mode,
                                              VectorTarget target) {
    if (target == VectorTarget::Interpreter) return nullptr;
    auto code = std::make_shared<SystemCode>();
    if (!compileProgram(s, s.derivative, lanes, mode, target, {&s.stateDerivatives}, code->derivative) ||
        !compileProgram(s, s.output, lanes, mode, target, {&s.outputResults, &s.tapResults}, code->output)) {
        return nullptr;
    }
    code->tables = &s.tables;
    code->bodies.resize(s.tables.nonlinear.size());
    for (std::size_t i = 0; i < code->bodies.size(); ++i)
        if (!compileBody(s, s.tables.nonlinear[i], 0, mode, target, code->bodies[i].values) ||
            !compileBody(s, s.tables.nonlinear[i], lanes, mode, target, code->bodies[i].tangents))
            return nullptr;
    if (mode == InputsConstant && !compileStep(s, lanes, target, code->step, code->arguments)) return nullptr;
    return code;
}

}  // namespace analogon
