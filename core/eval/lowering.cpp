#include "core/eval/lowering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "core/base/stop.hpp"

namespace analogon {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

Opcode opcodeOf(Operation operation) {
    switch (operation) {
        // clang-format off
        case Operation::Negate: return Opcode::Negate;
        case Operation::Add: return Opcode::Add;
        case Operation::Subtract: return Opcode::Subtract;
        case Operation::Multiply: return Opcode::Multiply;
        case Operation::Divide: return Opcode::Divide;
        case Operation::Power: return Opcode::Power;
        case Operation::Less: return Opcode::Less;
        case Operation::LessEqual: return Opcode::LessEqual;
        case Operation::Greater: return Opcode::Greater;
        case Operation::GreaterEqual: return Opcode::GreaterEqual;
        case Operation::Equal: return Opcode::Equal;
        case Operation::NotEqual: return Opcode::NotEqual;
        case Operation::And: return Opcode::And;
        case Operation::Or: return Opcode::Or;
        case Operation::Not: return Opcode::Not;
        case Operation::If: return Opcode::Select;
        case Operation::Abs: return Opcode::Abs;
        case Operation::Sign: return Opcode::Sign;
        case Operation::Sqrt: return Opcode::Sqrt;
        case Operation::Exp: return Opcode::Exp;
        case Operation::Log: return Opcode::Log;
        case Operation::Log10: return Opcode::Log10;
        case Operation::Sin: return Opcode::Sin;
        case Operation::Cos: return Opcode::Cos;
        case Operation::Tan: return Opcode::Tan;
        case Operation::Asin: return Opcode::Asin;
        case Operation::Acos: return Opcode::Acos;
        case Operation::Atan: return Opcode::Atan;
        case Operation::Atan2: return Opcode::Atan2;
        case Operation::Sinh: return Opcode::Sinh;
        case Operation::Cosh: return Opcode::Cosh;
        case Operation::Tanh: return Opcode::Tanh;
        case Operation::Min: return Opcode::Min;
        case Operation::Max: return Opcode::Max;
        case Operation::Floor: return Opcode::Floor;
        case Operation::Ceil: return Opcode::Ceil;
        case Operation::Mod: return Opcode::Mod;
        case Operation::Rem: return Opcode::Rem;
        case Operation::Div: return Opcode::Div;
        case Operation::Table: return Opcode::Table;
        case Operation::TableDerivative: return Opcode::TableDerivative;
        default: break;
            // clang-format on
    }
    assert(false && "a leaf has no opcode");
    return Opcode::Copy;
}

bool isPiecewiseConstant(Opcode opcode) {
    switch (opcode) {
        case Opcode::Less:
        case Opcode::LessEqual:
        case Opcode::Greater:
        case Opcode::GreaterEqual:
        case Opcode::Equal:
        case Opcode::NotEqual:
        case Opcode::And:
        case Opcode::Or:
        case Opcode::Not:
        case Opcode::Sign:
        case Opcode::Floor:
        case Opcode::Ceil:
        case Opcode::Div:
            return true;
        default:
            return false;
    }
}

void indexBlocks(const std::vector<SolutionBlock>& blocks, std::vector<int>& blockOf) {
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (const ExpressionId unknown : blocks[b].unknowns) blockOf[unknown.value] = static_cast<int>(b);
}

}  // namespace

Lowering::Lowering(const Structure& structure, const InputLayout& layout, ProgramTables& tables)
    : structure_(structure), layout_(layout), tables_(&tables), pool_(*structure.pool), collect_(pool_) {
    shared_.assign(pool_.size(), none);
    local_.assign(pool_.size(), none);
    isPure_.assign(pool_.size(), -1);
    blockOf_.assign(pool_.size(), -1);
    initialBlockOf_.assign(pool_.size(), -1);
    indexBlocks(structure.blocks, blockOf_);
    indexBlocks(structure.initialBlocks, initialBlockOf_);
    for (const SolutionBlock& block : structure.parameterBlocks)
        parameterBlockOf_.emplace(block.unknowns.front().value, &block);
    for (const StartValue& start : structure.starts) startOf_.emplace(start.node.value, &start);
    for (std::size_t d = 0; d < structure.delays.size(); ++d)
        delayOf_.emplace(structure.delays[d].value, static_cast<int>(d));
    variableNode_.assign(structure.model->variables.size(), {});
    derivativeNode_.assign(structure.model->variables.size(), {});
    for (std::uint32_t id = 0; id < pool_.size(); ++id) {
        const ExpressionNode& node = pool_[{id}];
        if (node.operation == Operation::Variable) variableNode_[node.variable.value] = {id};
        if (node.operation == Operation::Derivative) derivativeNode_[node.variable.value] = {id};
    }
    createShared();
}

std::uint32_t Lowering::newRegister(const RegisterInfo& info) {
    registers_.push_back(info);
    const auto reg = static_cast<std::uint32_t>(registers_.size() - 1);
    if (info.isOwn)
        registers_.back().place = ownCount_++;
    else
        sharedRegisters_.push_back(reg);
    return reg;
}

/// Parameters, time, states and inputs have the same registers in all programs.
void Lowering::createShared() {
    const auto shareAt = [&](ExpressionId node, std::uint32_t reg) {
        if (node.valid()) shared_[node.value] = reg;
    };
    for (const VariableId p : structure_.parameters) {
        const std::uint32_t reg = newRegister({.stage = RegisterInfo::Parameter, .active = {1, 1}});
        parameterRegisters_.push_back(reg);
        shareAt(variableNode_[p.value], reg);
    }
    timeRegister_ = newRegister({.degree = 2});
    for (std::size_t i = 0; i < structure_.states.size(); ++i)
        stateRegisters_.push_back(newRegister({.active = {1, 1}, .degree = 1}));
    for (int i = 0; i < layout_.slots; ++i) slotRegisters_.push_back(newRegister({.active = {0, 1}, .degree = 1}));
    for (std::size_t i = 0; i < structure_.inputs.size(); ++i) {
        shareAt(variableNode_[structure_.inputs[i].value], slotRegisters_[i]);
        if (layout_.hasDerivatives)
            shareAt(derivativeNode_[structure_.inputs[i].value], slotRegisters_[structure_.inputs.size() + i]);
    }
}

void Lowering::begin(Given given) {
    for (const std::uint32_t node : localNodes_) local_[node] = none;
    localNodes_.clear();
    used_.clear();
    usedTapDelays_.clear();
    powers_.clear();
    program_ = {};
    ownCount_ = 0;
    given_ = given;
    isLowered_.assign(std::max(structure_.blocks.size(), structure_.initialBlocks.size()), 0);
    if (isPreludeClosed_) constants_.clear();
    if (given == Given::States)
        for (std::size_t i = 0; i < structure_.states.size(); ++i)
            define(variableNode_[structure_.states[i].value], stateRegisters_[i]);
}

Program Lowering::end() {
    program_.registerCount = ownCount_;
    return std::move(program_);
}

void Lowering::define(ExpressionId node, std::uint32_t reg) {
    local_[node.value] = reg;
    localNodes_.push_back(node.value);
    if (registers_[reg].isScoped) scopedNodes_.push_back(node);
}

std::uint32_t Lowering::constant(double value) {
    const auto [at, isNew] = constants_.try_emplace(std::bit_cast<std::uint64_t>(value), 0);
    if (!isNew) return at->second;
    if (isPreludeClosed_) {
        const std::uint32_t reg = newRegister({.stage = RegisterInfo::Parameter, .isOwn = true});
        program_.code.push_back(
            {.opcode = Opcode::LoadConstant, .dst = reg, .a = static_cast<std::uint32_t>(program_.constants.size())});
        program_.constants.push_back(value);
        return at->second = reg;
    }
    const std::uint32_t reg = newRegister({.stage = RegisterInfo::Parameter});
    preloads_.emplace_back(reg, value);
    return at->second = reg;
}

/// Whether an expression holds nothing but parameters, so that it means the same in every program.
bool Lowering::isPure(ExpressionId expression) {
    if (!expression.valid()) return true;
    std::int8_t& known = isPure_[expression.value];
    if (known >= 0) return known > 0;
    const ExpressionNode& node = pool_[expression];
    bool result = false;
    switch (node.operation) {
        case Operation::Variable:
            result = (*structure_.model)[node.variable].variability != FlatVariability::Continuous;
            break;
        case Operation::Derivative:
        case Operation::Time:
        case Operation::Delay:
            break;
        default:
            result = isPure(node.a) && isPure(node.b) && isPure(node.c);
    }
    known = result;
    return result;
}

std::uint32_t Lowering::lower(ExpressionId expression) {
    if (local_[expression.value] != none) return local_[expression.value];
    if (shared_[expression.value] != none) return shared_[expression.value];
    const ExpressionNode node = pool_[expression];
    if (node.operation == Operation::Constant) return constant(node.value);
    const std::uint32_t reg = lowerNode(expression, node);
    if (!isPreludeClosed_ && isPure(expression))
        shared_[expression.value] = reg;
    else
        define(expression, reg);
    return reg;
}

std::uint32_t Lowering::lowerNode(ExpressionId expression, const ExpressionNode& node) {
    switch (node.operation) {
        case Operation::Variable:
        case Operation::Derivative:
            return lowerLeaf(node);
        case Operation::Time:
            return timeRegister_;
        case Operation::Delay:
            return lowerDelay(expression);
        case Operation::NoEvent:
        case Operation::Smooth:
            return lower(node.a);
        case Operation::Power:
            return lowerPower(node);
        case Operation::Table:
        case Operation::TableDerivative:
            return emit(opcodeOf(node.operation), lower(node.a), static_cast<std::uint32_t>(node.value));
        default: {
            const std::uint32_t a = lower(node.a);
            const std::uint32_t b = node.b.valid() ? lower(node.b) : 0;
            const std::uint32_t c = node.c.valid() ? lower(node.c) : 0;
            return emit(opcodeOf(node.operation), a, b, c);
        }
    }
}

/// A name that has no register yet: a parameter that depends on others. Unknowns were defined by their blocks.
std::uint32_t Lowering::lowerLeaf(const ExpressionNode& node) {
    const auto block = parameterBlockOf_.find(variableNode_[node.variable.value].value);
    assert(block != parameterBlockOf_.end() && "an unknown is used before its block");
    return lower(block->second->expressions.front());
}

std::uint32_t Lowering::lowerDelay(ExpressionId expression) {
    const int number = delayOf_.at(expression.value);
    const DelaySlot& delay = layout_.delays[static_cast<std::size_t>(number)];
    if (delay.tap >= 0) usedTapDelays_.push_back(number);
    const std::uint32_t reg = slotRegisters_[static_cast<std::size_t>(delay.slot)];
    return delay.isNegated ? emit(Opcode::Negate, reg) : reg;
}

std::uint32_t Lowering::lowerPower(const ExpressionNode& node) {
    const std::uint32_t a = lower(node.a);
    if (pool_.isConstant(node.b)) {
        const double exponent = pool_[node.b].value;
        if (exponent == 0) return constant(1);
        if (exponent == 1) return a;
        if (exponent == 0.5) return emit(Opcode::Sqrt, a);
        if (exponent == 2) return emit(Opcode::Square, a);
        if (exponent == 3) return emit(Opcode::Multiply, emit(Opcode::Square, a), a);
        if (exponent == 4) return emit(Opcode::Square, emit(Opcode::Square, a));
        if (exponent == -1) return emit(Opcode::Divide, constant(1), a);
        if (exponent == -2) return emit(Opcode::Divide, constant(1), emit(Opcode::Square, a));
        return powerOf(a, exponent);
    }
    return emit(Opcode::Power, a, lower(node.b));
}

/// Beside a power its derivative is a quotient: a^(b - 1) = a^b / a, and at 0 it is 0 where b > 1, else infinite.
std::uint32_t Lowering::powerOf(std::uint32_t a, double exponent) {
    if (const auto higher = powers_.find({a, exponent + 1}); higher != powers_.end()) {
        const std::uint32_t quotient = emit(Opcode::Divide, higher->second, a);
        const std::uint32_t atZero =
            exponent > 0 ? constant(0) : emit(Opcode::Divide, constant(1), emit(Opcode::Abs, a));
        return emit(Opcode::Select, emit(Opcode::Equal, a, constant(0)), atZero, quotient);
    }
    return powers_[{a, exponent}] = emit(Opcode::Power, a, constant(exponent));
}

std::uint8_t Lowering::degreeOf(const Instruction& i) const {
    const auto degree = [this](std::uint32_t reg) { return registers_[reg].degree; };
    switch (i.opcode) {
        case Opcode::Copy:
        case Opcode::Negate:
            return degree(i.a);
        case Opcode::Add:
        case Opcode::Subtract:
            return std::max(degree(i.a), degree(i.b));
        case Opcode::Multiply:
            return std::min<std::uint8_t>(2, static_cast<std::uint8_t>(degree(i.a) + degree(i.b)));
        case Opcode::Divide:
            return degree(i.b) == 0 ? degree(i.a) : 2;
        case Opcode::Select:
            return degree(i.a) == 0 ? std::max(degree(i.b), degree(i.c)) : 2;
        default: {
            const int operands = registerOperands(i.opcode);
            std::uint8_t most = degree(i.a);
            if (operands > 1) most = std::max(most, degree(i.b));
            return most == 0 ? 0 : 2;
        }
    }
}

std::vector<Instruction>& Lowering::target(const RegisterInfo& info) {
    if (info.isScoped) return *scope_;
    return info.isOwn ? program_.code : prelude_.code;
}

const Instruction* Lowering::madeBy(std::uint32_t reg, Opcode opcode) const {
    const auto at = made_.find(reg);
    return at != made_.end() && at->second.opcode == opcode ? &at->second : nullptr;
}

std::optional<std::uint32_t> Lowering::shortened(Opcode opcode, std::uint32_t a, std::uint32_t b) {
    if (isPreludeClosed_) return std::nullopt;
    const auto isOfParameters = [&](std::uint32_t reg) { return registers_[reg].stage == RegisterInfo::Parameter; };
    // n/(p x) with p of parameters alone: (n/p)/x, where n/p does not wait for x.
    if (const Instruction* product = madeBy(b, Opcode::Multiply); opcode == Opcode::Divide && product) {
        const auto [p, x] =
            isOfParameters(product->a) ? std::pair(product->a, product->b) : std::pair(product->b, product->a);
        if (isOfParameters(p) && !isOfParameters(x) && !isOfParameters(a))
            return emit(Opcode::Divide, emit(Opcode::Divide, a, p), x);
    }
    // r (n/r)^2, the heat in a resistance at a voltage: n^2/r; likewise p x (m/x)^2.
    for (const auto& [factor, power] : {std::pair(a, b), std::pair(b, a)}) {
        const Instruction* const square = opcode == Opcode::Multiply ? madeBy(power, Opcode::Square) : nullptr;
        const Instruction* const quotient = square ? madeBy(square->a, Opcode::Divide) : nullptr;
        if (!quotient) continue;
        const std::uint32_t numerator = quotient->a, divisor = quotient->b;
        if (divisor == factor) return emit(Opcode::Divide, emit(Opcode::Square, numerator), divisor);
        const Instruction* const product = madeBy(factor, Opcode::Multiply);
        if (!product || (product->a != divisor && product->b != divisor)) continue;
        const std::uint32_t rest = product->a == divisor ? product->b : product->a;
        return emit(Opcode::Divide, emit(Opcode::Multiply, rest, emit(Opcode::Square, numerator)), divisor);
    }
    return std::nullopt;
}

std::uint32_t Lowering::emit(Opcode opcode, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    stopPoint();
    if (const std::optional<std::uint32_t> shorter = shortened(opcode, a, b)) return *shorter;
    // The reciprocal of what depends on parameters alone is found once, not at every step.
    if (opcode == Opcode::Divide && !isPreludeClosed_ && registers_[a].stage == RegisterInfo::Dynamic &&
        registers_[b].stage == RegisterInfo::Parameter) {
        const auto [at, isNew] = reciprocals_.try_emplace(b, 0);
        if (isNew) at->second = emit(Opcode::Divide, constant(1), b);
        return emit(Opcode::Multiply, a, at->second);
    }
    Instruction instruction{.opcode = opcode, .a = a, .b = b, .c = c};
    const std::uint32_t operands[] = {a, b, c};
    RegisterInfo info{.stage = RegisterInfo::Parameter};
    for (int k = 0; k < registerOperands(opcode); ++k) {
        const RegisterInfo& operand = registers_[operands[k]];
        info.stage = std::max(info.stage, operand.stage);
        info.isScoped = info.isScoped || operand.isScoped;
        for (std::size_t mode = 0; mode < 2; ++mode)
            if (operand.active[mode] && !isPiecewiseConstant(opcode)) {
                instruction.active[mode] |= static_cast<std::uint8_t>(1 << k);
                info.active[mode] = 1;
            }
    }
    for (std::size_t mode = 0; mode < 2; ++mode) instruction.kernel[mode] = kernelOf(opcode, instruction.active[mode]);
    info.degree = degreeOf(instruction);
    info.isOwn = info.stage == RegisterInfo::Dynamic || isPreludeClosed_;
    instruction.dst = newRegister(info);
    made_.emplace(instruction.dst, instruction);
    target(info).push_back(instruction);
    return instruction.dst;
}

std::string Lowering::nameOf(ExpressionId node) const {
    const ExpressionNode& n = pool_[node];
    const std::string& name = (*structure_.model)[n.variable].name;
    return n.operation == Operation::Derivative ? fmt::format("der({})", name) : name;
}

void Lowering::require(std::span<const ExpressionId> expressions) {
    const std::vector<SolutionBlock>& blocks = given_ == Given::States ? structure_.blocks : structure_.initialBlocks;
    const std::vector<int>& blockOf = given_ == Given::States ? blockOf_ : initialBlockOf_;
    std::vector<int> needed;
    std::vector<char> isListed(blocks.size(), 0);
    const auto list = [&](std::span<const ExpressionId> roots) {
        for (const ExpressionId leaf : collect_.leaves(roots)) {
            const int block = blockOf[leaf.value];
            if (block < 0 || isLowered_[static_cast<std::size_t>(block)] || isListed[static_cast<std::size_t>(block)])
                continue;
            isListed[static_cast<std::size_t>(block)] = 1;
            needed.push_back(block);
        }
    };
    list(expressions);
    for (std::size_t i = 0; i < needed.size(); ++i) list(blocks[static_cast<std::size_t>(needed[i])].expressions);
    std::sort(needed.begin(), needed.end());
    for (const int block : needed) {
        isLowered_[static_cast<std::size_t>(block)] = 1;
        used_.push_back(&blocks[static_cast<std::size_t>(block)]);
        lowerBlock(blocks[static_cast<std::size_t>(block)]);
    }
}

bool Lowering::isKnown(ExpressionId node) const {
    const ExpressionNode& n = pool_[node];
    if (n.operation != Operation::Variable && n.operation != Operation::Derivative) return true;
    return local_[node.value] != none || shared_[node.value] != none || parameterBlockOf_.count(node.value) > 0;
}

void Lowering::lowerBlock(const SolutionBlock& block) {
    if (block.isExplicit) {
        const ExpressionId unknown = block.unknowns.front();
        const std::uint32_t reg = lower(block.expressions.front());
        define(unknown, reg);
        if (registers_[reg].isOwn) program_.watched.emplace_back(reg, nameOf(unknown));
    } else if (block.isLinear) {
        lowerLinear(block);
    } else {
        lowerNonlinear(block);
    }
}

std::vector<std::uint32_t> Lowering::entriesOf(const std::vector<ExpressionId>& matrix) const {
    std::vector<std::uint32_t> entries;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        const ExpressionNode& e = pool_[matrix[i]];
        if (e.operation != Operation::Constant || e.value != 0) entries.push_back(static_cast<std::uint32_t>(i));
    }
    return entries;
}

void Lowering::lowerLinear(const SolutionBlock& block) {
    LinearBlock linear;
    RegisterInfo info{.isOwn = true};
    info.degree = 0;
    for (const ExpressionId entry : block.jacobian) linear.matrix.push_back(lower(entry));
    linear.entries = entriesOf(block.jacobian);
    for (const ExpressionId entry : block.constantTerm) linear.constant.push_back(lower(entry));
    for (const std::uint32_t reg : linear.matrix)
        if (registers_[reg].degree > 0) info.degree = 2;
    for (const auto* group : {&linear.matrix, &linear.constant})
        for (const std::uint32_t reg : *group) {
            linear.activeOf.push_back(registers_[reg].active);
            for (std::size_t mode = 0; mode < 2; ++mode) info.active[mode] |= registers_[reg].active[mode];
        }
    for (const std::uint32_t reg : linear.constant) info.degree = std::max(info.degree, registers_[reg].degree);
    linear.active = info.active;
    for (const ExpressionId unknown : block.unknowns) {
        const std::uint32_t reg = newRegister(info);
        linear.unknowns.push_back(reg);
        linear.names.push_back(nameOf(unknown));
        program_.watched.emplace_back(reg, linear.names.back());
        define(unknown, reg);
    }
    program_.code.push_back({.opcode = Opcode::SolveLinear, .a = static_cast<std::uint32_t>(tables_->linear.size())});
    tables_->linear.push_back(std::move(linear));
}

void Lowering::lowerNonlinear(const SolutionBlock& block) {
    NonlinearBlock nonlinear;
    for (const ExpressionId unknown : block.unknowns) {
        const auto start = startOf_.find(unknown.value);
        nonlinear.starts.push_back(start == startOf_.end() ? constant(0) : lower(start->second->value));
        nonlinear.nominal.push_back(start == startOf_.end() ? 1 : start->second->nominal);
        nonlinear.names.push_back(nameOf(unknown));
    }
    // Within the block its unknowns carry no tangents: those of the residuals are then the partial ones that
    // the implicit function theorem asks for.
    scope_ = &nonlinear.body;
    for (const ExpressionId unknown : block.unknowns) {
        const std::uint32_t reg = newRegister({.degree = 2, .isScoped = true, .isOwn = true});
        nonlinear.unknowns.push_back(reg);
        define(unknown, reg);
    }
    for (const ExpressionId residual : block.expressions) {
        const std::uint32_t reg = lower(residual);
        nonlinear.residuals.push_back(reg);
        nonlinear.activeOf.push_back(registers_[reg].active);
        for (std::size_t mode = 0; mode < 2; ++mode) nonlinear.active[mode] |= registers_[reg].active[mode];
    }
    for (const ExpressionId entry : block.jacobian) nonlinear.jacobian.push_back(lower(entry));
    nonlinear.entries = entriesOf(block.jacobian);
    scope_ = nullptr;
    for (const ExpressionId node : scopedNodes_) local_[node.value] = none;
    scopedNodes_.clear();
    powers_.clear();
    for (std::size_t i = 0; i < block.unknowns.size(); ++i) {
        RegisterInfo& info = registers_[nonlinear.unknowns[i]];
        info.isScoped = false;
        info.active = nonlinear.active;
        define(block.unknowns[i], nonlinear.unknowns[i]);
        program_.watched.emplace_back(nonlinear.unknowns[i], nonlinear.names[i]);
    }
    nonlinear.guess = guessCount_;
    guessCount_ += static_cast<std::uint32_t>(block.unknowns.size());
    program_.code.push_back(
        {.opcode = Opcode::SolveNonlinear, .a = static_cast<std::uint32_t>(tables_->nonlinear.size())});
    tables_->nonlinear.push_back(std::move(nonlinear));
}

void Lowering::closePrelude() {
    for (const std::uint32_t reg : sharedRegisters_) registers_[reg].place = sharedCount_++;
    isPreludeClosed_ = true;
    prelude_.registerCount = sharedCount_;
    for (Instruction& instruction : prelude_.code) relocate(instruction);
    for (auto& [reg, value] : preloads_) reg = place(reg);
}

void Lowering::relocate(Instruction& instruction) const {
    const int operands = registerOperands(instruction.opcode);
    if (operands > 0) instruction.a = place(instruction.a);
    if (operands > 1) instruction.b = place(instruction.b);
    if (operands > 2) instruction.c = place(instruction.c);
    if (operands > 0 || instruction.opcode == Opcode::LoadConstant) instruction.dst = place(instruction.dst);
}

void Lowering::finish(Program& program) {
    const auto placeAll = [this](std::vector<std::uint32_t>& registers) {
        for (std::uint32_t& reg : registers) reg = place(reg);
    };
    for (Instruction& instruction : program.code) {
        relocate(instruction);
        if (instruction.opcode == Opcode::SolveLinear) {
            LinearBlock& block = tables_->linear[instruction.a];
            placeAll(block.unknowns);
            placeAll(block.matrix);
            placeAll(block.constant);
        } else if (instruction.opcode == Opcode::SolveNonlinear) {
            NonlinearBlock& block = tables_->nonlinear[instruction.a];
            placeAll(block.unknowns);
            placeAll(block.residuals);
            placeAll(block.jacobian);
            placeAll(block.starts);
            for (Instruction& inner : block.body) relocate(inner);
        }
    }
    for (auto& [reg, name] : program.watched) reg = place(reg);
    program.registerCount += sharedCount_;
}

}  // namespace analogon
