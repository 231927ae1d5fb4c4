#include "core/eval/system_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace analogon {
namespace {

class Builder {
public:
    Builder(const Structure& structure, SystemPrograms& out) : out_(out) { out_.structure = structure; }
    Diagnostics run();

private:
    const Structure& s() const { return out_.structure; }
    const ExpressionPool& pool() const { return *s().pool; }
    std::string nameOf(VariableId id) const { return (*s().model)[id].name; }

    void layOutInputs();
    std::vector<char> differentiatedInputs() const;
    void layOutDelay(ExpressionId delay, std::map<std::pair<int, std::uint32_t>, int>& inputDelays,
                     std::map<std::pair<std::uint32_t, std::uint32_t>, int>& tapDelays);
    void describeSignals();
    SignalInfo signal(VariableId id, double value) const;
    double valueOf(ExpressionId expression, std::map<std::uint32_t, double>& parameters) const;
    ExpressionId expressionOf(VariableId id) const;
    void lowerPrograms();
    void lowerInitial();
    void lowerDerivative();
    void lowerOutputs();
    void lowerRoots();
    void lowerDelayTimes();
    std::vector<ExpressionId> relations(const std::vector<const SolutionBlock*>& blocks) const;
    void place();

    SystemPrograms& out_;
    std::vector<const SolutionBlock*> usedBlocks_;
    std::vector<std::uint32_t> initialStates_, derivatives_, outputs_, taps_, roots_, delayTimes_;
    Diagnostics faults_;
};

/// By input; empty: none is.
std::vector<char> Builder::differentiatedInputs() const {
    LeafCollector collect(pool());
    std::vector<char> differentiated;
    const auto look = [&](std::span<const ExpressionId> roots) {
        for (const ExpressionId leaf : collect.leaves(roots)) {
            const ExpressionNode& node = pool()[leaf];
            if (node.operation != Operation::Derivative) continue;
            differentiated.resize(s().inputs.size());
            for (std::size_t i = 0; i < s().inputs.size(); ++i)
                if (s().inputs[i] == node.variable) differentiated[i] = 1;
        }
    };
    for (const SolutionBlock& block : s().blocks) look(block.expressions);
    for (const SolutionBlock& block : s().initialBlocks) look(block.expressions);
    look(s().stateDerivatives);
    std::vector<ExpressionId> aliases;
    for (const auto& [variable, stand] : s().aliases) aliases.push_back(stand);
    look(aliases);
    if (std::count(differentiated.begin(), differentiated.end(), 0) == std::ssize(differentiated)) return {};
    return differentiated;
}

void Builder::layOutDelay(ExpressionId delay, std::map<std::pair<int, std::uint32_t>, int>& inputDelays,
                          std::map<std::pair<std::uint32_t, std::uint32_t>, int>& tapDelays) {
    const ExpressionNode node = pool()[delay];
    DelaySlot slot{.signal = node.a, .time = node.b};
    ExpressionNode signal = pool()[node.a];
    if (signal.operation == Operation::Negate) {
        slot.isNegated = true;
        signal = pool()[signal.a];
    }
    if (signal.operation == Operation::Variable)
        for (std::size_t i = 0; i < s().inputs.size(); ++i)
            if (s().inputs[i] == signal.variable) slot.input = static_cast<int>(i);
    int next = static_cast<int>(out_.delays.size());
    if (slot.input >= 0) {
        next = inputDelays.emplace(std::pair(slot.input, node.b.value), next).first->second;
    } else {
        slot.isNegated = false;
        const auto tap = std::find(out_.layout.taps.begin(), out_.layout.taps.end(), node.a);
        slot.tap = static_cast<int>(tap - out_.layout.taps.begin());
        if (tap == out_.layout.taps.end()) out_.layout.taps.push_back(node.a);
        next = tapDelays.emplace(std::pair(node.a.value, node.b.value), next).first->second;
    }
    if (next == static_cast<int>(out_.delays.size())) out_.delays.push_back({slot.input, slot.tap});
    slot.slot = next;  // offset by the sampled inputs below
    out_.layout.delays.push_back(slot);
}

void Builder::layOutInputs() {
    InputLayout& layout = out_.layout;
    layout.inputs = static_cast<int>(s().inputs.size());
    layout.differentiated = differentiatedInputs();
    layout.hasDerivatives = !layout.differentiated.empty();
    std::map<std::pair<int, std::uint32_t>, int> inputDelays;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> tapDelays;
    for (const ExpressionId delay : s().delays) layOutDelay(delay, inputDelays, tapDelays);
    const int sampled = layout.inputs * (layout.hasDerivatives ? 2 : 1);
    for (DelaySlot& slot : layout.delays) slot.slot += sampled;
    layout.slots = sampled + static_cast<int>(out_.delays.size());
}

SignalInfo Builder::signal(VariableId id, double value) const {
    const FlatVariable& variable = (*s().model)[id];
    SignalInfo info;
    info.name = variable.name;
    info.unit = variable.unit;
    if (variable.nominal && *variable.nominal != 0) info.nominal = std::fabs(*variable.nominal);
    info.min = variable.min;
    info.max = variable.max;
    info.value = value;
    return info;
}

/// Value of an expression over parameters, at the model's own parameter values.
double Builder::valueOf(ExpressionId expression, std::map<std::uint32_t, double>& parameters) const {
    return pool().evaluate(expression, [&](const ExpressionNode& node) {
        const auto at = parameters.find(node.variable.value);
        return node.operation == Operation::Variable && at != parameters.end() ? at->second : std::nan("");
    });
}

void Builder::describeSignals() {
    std::map<std::uint32_t, double> parameters;
    for (std::size_t i = 0; i < s().parameters.size(); ++i) {
        parameters[s().parameters[i].value] = s().parameterValues[i];
        out_.parameters.push_back(signal(s().parameters[i], s().parameterValues[i]));
    }
    for (const SolutionBlock& block : s().parameterBlocks)
        parameters[pool()[block.unknowns.front()].variable.value] = valueOf(block.expressions.front(), parameters);
    std::map<std::uint32_t, const StartValue*> starts;
    for (const StartValue& start : s().starts)
        if (pool()[start.node].operation == Operation::Variable) starts[pool()[start.node].variable.value] = &start;
    for (const VariableId state : s().states) {
        const auto start = starts.find(state.value);
        SignalInfo info = signal(state, start == starts.end() ? 0 : valueOf(start->second->value, parameters));
        if (start != starts.end()) info.nominal = start->second->nominal;
        out_.states.push_back(std::move(info));
    }
    for (const VariableId input : s().inputs) out_.inputs.push_back(signal(input, 0));
    for (const VariableId output : s().outputs) out_.outputs.push_back(signal(output, 0));
    for (std::size_t i = 0; i < out_.layout.taps.size(); ++i) {
        SignalInfo info;
        info.name = pool().print(out_.layout.taps[i], [this](VariableId id) { return nameOf(id); });
        out_.tapSignals.push_back(std::move(info));
    }
}

/// What stands for a variable: itself or its alias.
ExpressionId Builder::expressionOf(VariableId id) const {
    for (const auto& [variable, stand] : s().aliases)
        if (variable == id) return stand;
    return out_.lowering->variableNode(id);
}

void Builder::lowerInitial() {
    Lowering& lower = *out_.lowering;
    lower.begin(Lowering::Given::Nothing);
    std::vector<ExpressionId> states;
    for (const VariableId state : s().states) states.push_back(lower.variableNode(state));
    lower.require(states);
    for (const ExpressionId state : states) initialStates_.push_back(lower.registerOf(state));
    out_.initial = lower.end();
}

void Builder::lowerDerivative() {
    Lowering& lower = *out_.lowering;
    lower.begin(Lowering::Given::States);
    lower.require(s().stateDerivatives);
    out_.isLinearTimeInvariant = true;
    for (const ExpressionId derivative : s().stateDerivatives) {
        derivatives_.push_back(lower.registerOf(derivative));
        if (lower.info(derivatives_.back()).degree > 1) out_.isLinearTimeInvariant = false;
    }
    for (const int number : lower.usedTapDelays()) {
        const DelaySlot& delay = out_.layout.delays[static_cast<std::size_t>(number)];
        const std::string text = pool().print(delay.signal, [this](VariableId id) { return nameOf(id); });
        faults_.push_back(error(phrase("The delayed signal {} acts on a state of the model.", text), {},
                                phrase("Only inputs of the model can be delayed there; delays of other signals may "
                                       "lead to outputs alone.")));
    }
    usedBlocks_ = lower.usedBlocks();
    out_.derivative = lower.end();
}

void Builder::lowerOutputs() {
    Lowering& lower = *out_.lowering;
    lower.begin(Lowering::Given::States);
    std::vector<ExpressionId> results;
    for (const VariableId output : s().outputs) results.push_back(expressionOf(output));
    results.insert(results.end(), out_.layout.taps.begin(), out_.layout.taps.end());
    lower.require(results);
    for (std::size_t i = 0; i < results.size(); ++i)
        (i < s().outputs.size() ? outputs_ : taps_).push_back(lower.registerOf(results[i]));
    usedBlocks_.insert(usedBlocks_.end(), lower.usedBlocks().begin(), lower.usedBlocks().end());
    out_.output = lower.end();
}

/// The relations (and signs) outside noEvent that decide something in these blocks.
std::vector<ExpressionId> Builder::relations(const std::vector<const SolutionBlock*>& blocks) const {
    std::vector<ExpressionId> found, stack;
    std::vector<char> isSeen(pool().size(), 0);
    for (const SolutionBlock* block : blocks)
        for (const ExpressionId root : block->expressions) stack.push_back(root);
    while (!stack.empty()) {
        const ExpressionId id = stack.back();
        stack.pop_back();
        if (!id.valid() || std::exchange(isSeen[id.value], 1)) continue;
        const ExpressionNode& node = pool()[id];
        switch (node.operation) {
            case Operation::NoEvent:
            case Operation::Smooth:
            case Operation::Delay:
                continue;
            case Operation::Less:
            case Operation::LessEqual:
            case Operation::Greater:
            case Operation::GreaterEqual:
            case Operation::Sign:
                found.push_back(id);
                break;
            default:
                break;
        }
        stack.push_back(node.a);
        stack.push_back(node.b);
        stack.push_back(node.c);
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Event indicators: a - b of each relation, a of sign(a). Relations over parameters alone never change.
void Builder::lowerRoots() {
    Lowering& lower = *out_.lowering;
    lower.begin(Lowering::Given::States);
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> known;
    for (const ExpressionId relation : relations(usedBlocks_)) {
        const ExpressionNode node = pool()[relation];
        std::vector<ExpressionId> sides{node.a};
        if (node.operation != Operation::Sign) sides.push_back(node.b);
        lower.require(sides);
        const std::uint32_t a = lower.registerOf(node.a);
        const std::uint32_t b = sides.size() > 1 ? lower.registerOf(node.b) : lower.number(0);
        if (lower.info(a).stage == RegisterInfo::Parameter && lower.info(b).stage == RegisterInfo::Parameter) continue;
        if (!known.emplace(std::pair(std::min(a, b), std::max(a, b)), true).second) continue;
        roots_.push_back(lower.difference(a, b));
    }
    out_.root = lower.end();
}

void Builder::lowerDelayTimes() {
    Lowering& lower = *out_.lowering;
    lower.begin(Lowering::Given::Nothing);
    delayTimes_.assign(out_.delays.size(), 0);
    const int sampled = out_.layout.slots - static_cast<int>(out_.delays.size());
    LeafCollector collect(pool());
    for (const DelaySlot& delay : out_.layout.delays) {
        for (const ExpressionId leaf : collect.leaves(delay.time))
            if ((*s().model)[pool()[leaf].variable].variability == FlatVariability::Continuous) {
                faults_.push_back(
                    error(phrase("A delay time depends on '{}', which varies in time.", nameOf(pool()[leaf].variable)),
                          {}, phrase("Use a parameter as the delay time.")));
                return;
            }
        delayTimes_[static_cast<std::size_t>(delay.slot - sampled)] = lower.registerOf(delay.time);
    }
    lower.end();
}

void Builder::place() {
    Lowering& lower = *out_.lowering;
    lower.closePrelude();
    out_.prelude = std::move(lower.prelude());
    out_.registerCount = out_.prelude.registerCount;
    for (Program* program : {&out_.initial, &out_.derivative, &out_.output, &out_.root}) {
        lower.finish(*program);
        out_.registerCount = std::max(out_.registerCount, program->registerCount);
    }
    const auto results = [&](const std::vector<std::uint32_t>& from, std::vector<ResultRegister>& to) {
        for (const std::uint32_t reg : from) to.push_back({lower.place(reg), lower.info(reg).active});
    };
    results(initialStates_, out_.initialStates);
    results(derivatives_, out_.stateDerivatives);
    results(outputs_, out_.outputResults);
    results(taps_, out_.tapResults);
    results(roots_, out_.rootRegisters);
    results(delayTimes_, out_.delayTimes);
    if (!s().parameters.empty()) out_.firstParameter = lower.place(lower.parameterRegister(0));
    if (!s().states.empty()) out_.firstState = lower.place(lower.stateRegister(0));
    if (out_.layout.slots > 0) out_.firstSlot = lower.place(lower.slotRegister(0));
    out_.timeRegister = lower.place(lower.timeRegister());
    out_.preloads = lower.preloads();
    out_.guessCount = lower.guessCount();
}

Diagnostics Builder::run() {
    layOutInputs();
    out_.tables.lookups = out_.tables.slopes = pool().tables();
    for (LookupTable& slope : out_.tables.slopes) ++slope.order;
    out_.lowering = std::make_unique<Lowering>(out_.structure, out_.layout, out_.tables);
    describeSignals();
    lowerInitial();
    lowerDerivative();
    lowerOutputs();
    lowerRoots();
    lowerDelayTimes();
    if (faults_.empty()) place();
    return faults_;
}

}  // namespace

Diagnostics buildPrograms(const Structure& structure, SystemPrograms& out) { return Builder(structure, out).run(); }

Observation buildObservation(const SystemPrograms& s) {
    Observation out;
    out.tables.lookups = s.tables.lookups;
    out.tables.slopes = s.tables.slopes;
    Lowering& lower = *s.lowering;
    lower.useTables(out.tables);
    lower.begin(Lowering::Given::States);
    const Structure& structure = s.structure;
    std::vector<std::pair<std::string, ExpressionId>> wanted;
    const FlatModel& model = *structure.model;
    for (std::uint32_t i = 0; i < model.variables.size(); ++i) {
        const ExpressionId node = lower.variableNode({i});
        if (node.valid()) wanted.emplace_back(model.variables[i].name, node);
    }
    std::unordered_map<std::uint32_t, ExpressionId> aliasOf;
    for (const auto& [variable, stand] : structure.aliases) aliasOf.emplace(lower.variableNode(variable).value, stand);
    for (std::size_t i = 0; i < structure.states.size(); ++i)
        wanted.emplace_back(fmt::format("der({})", model[structure.states[i]].name), structure.stateDerivatives[i]);
    for (auto& [name, node] : wanted)
        if (const auto alias = aliasOf.find(node.value); alias != aliasOf.end()) node = alias->second;
    std::vector<std::uint32_t> registers;
    for (const auto& [name, node] : wanted) {
        lower.require({&node, 1});
        if (!lower.isKnown(node)) continue;
        if (out.handleOf.emplace(name, static_cast<int>(registers.size())).second)
            registers.push_back(lower.registerOf(node));
    }
    for (const auto& [variable, value] : structure.folded) {
        const std::string& name = model[variable].name;
        if (out.handleOf.count(name)) continue;
        out.handleOf.emplace(name, static_cast<int>(registers.size()));
        registers.push_back(lower.number(value));
    }
    out.program = lower.end();
    lower.finish(out.program);
    for (const std::uint32_t reg : registers) out.results.push_back(lower.place(reg));
    out.guessCount = lower.guessCount();
    return out;
}

namespace {

void printCode(const std::vector<Instruction>& code, const Program& program, int indent, const ProgramTables& tables,
               std::string& text) {
    for (const Instruction& i : code) {
        text += std::string(static_cast<std::size_t>(indent), ' ');
        if (i.opcode == Opcode::LoadConstant) {
            text += fmt::format("r{} = {}\n", i.dst, program.constants[i.a]);
        } else if (i.opcode == Opcode::SolveLinear) {
            const LinearBlock& block = tables.linear[i.a];
            text += fmt::format("linear {} unknowns:", block.unknowns.size());
            for (std::size_t k = 0; k < block.unknowns.size(); ++k)
                text += fmt::format(" r{} {}", block.unknowns[k], block.names[k]);
            text += "\n";
        } else if (i.opcode == Opcode::SolveNonlinear) {
            const NonlinearBlock& block = tables.nonlinear[i.a];
            text += fmt::format("newton {} unknowns:", block.unknowns.size());
            for (std::size_t k = 0; k < block.unknowns.size(); ++k)
                text += fmt::format(" r{} {}", block.unknowns[k], block.names[k]);
            text += "\n";
            printCode(block.body, program, indent + 2, tables, text);
        } else {
            const int operands = registerOperands(i.opcode);
            text += fmt::format("r{} = {} r{}", i.dst, nameOf(i.opcode), i.a);
            if (operands > 1) text += fmt::format(" r{}", i.b);
            if (operands > 2) text += fmt::format(" r{}", i.c);
            text += "\n";
        }
    }
}

}  // namespace

std::string print(const SystemPrograms& s) {
    std::string text;
    for (const auto& [reg, value] : s.preloads) text += fmt::format("r{} = {}\n", reg, value);
    const auto list = [&](const char* what, std::uint32_t first, const std::vector<SignalInfo>& signals) {
        for (std::size_t i = 0; i < signals.size(); ++i)
            text += fmt::format("r{} = {} {}\n", first + i, what, signals[i].name);
    };
    list("parameter", s.firstParameter, s.parameters);
    text += fmt::format("r{} = time\n", s.timeRegister);
    list("state", s.firstState, s.states);
    list("input", s.firstSlot, s.inputs);
    const auto section = [&](const char* title, const Program& program, const std::vector<ResultRegister>& results,
                             const std::vector<SignalInfo>& signals) {
        text += fmt::format("{}\n", title);
        printCode(program.code, program, 2, s.tables, text);
        for (std::size_t i = 0; i < results.size(); ++i)
            text += fmt::format("  -> r{} {}\n", results[i].place, i < signals.size() ? signals[i].name : "");
    };
    section("from parameters", s.prelude, {}, {});
    section("start", s.initial, s.initialStates, s.states);
    section("derivatives of", s.derivative, s.stateDerivatives, s.states);
    section("outputs", s.output, s.outputResults, s.outputs);
    if (!s.rootRegisters.empty()) section("events", s.root, s.rootRegisters, {});
    return text;
}

}  // namespace analogon
