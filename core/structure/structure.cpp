#include "core/structure/structure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/guard.hpp"
#include "core/structure/alias.hpp"
#include "core/structure/delay.hpp"
#include "core/structure/fold.hpp"
#include "core/structure/index_reduction.hpp"
#include "core/structure/initial.hpp"
#include "core/structure/rewrite.hpp"
#include "core/structure/solution_order.hpp"

namespace analogon {
namespace {

void append(Diagnostics& to, const Diagnostics& more) { to.insert(to.end(), more.begin(), more.end()); }

void listStates(const ReducedSystem& reduced, Structure& out) {
    const EquationSystem& system = reduced.system;
    for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
        if (!reduced.isState[u]) continue;
        out.states.push_back((*system.pool)[system.unknowns[u].node].variable);
        out.stateDerivatives.push_back(system.unknowns[u].derivative);
    }
}

void listStarts(const ReducedSystem& reduced, Structure& out) {
    const EquationSystem& system = reduced.system;
    std::vector<char> isWanted(system.unknowns.size(), 0);
    for (std::size_t u = 0; u < isWanted.size(); ++u) isWanted[u] = reduced.isState[u];
    for (const auto* blocks : {&out.blocks, &out.initialBlocks})
        for (const SolutionBlock& block : *blocks)
            if (!block.isExplicit)
                for (const ExpressionId z : block.unknowns) isWanted[static_cast<std::size_t>(system.unknownOf(z))] = 1;
    for (std::size_t u = 0; u < isWanted.size(); ++u) {
        if (!isWanted[u]) continue;
        const Unknown& unknown = system.unknowns[u];
        out.starts.push_back(
            {unknown.node, unknown.start.valid() ? unknown.start : system.pool->constant(0), unknown.nominal});
    }
}

/// A system free of differentiated constraints whose state x is a node Variable has no other kind of state.
Diagnostics unnamedStates(const ReducedSystem& reduced) {
    Diagnostics faults;
    for (std::size_t u = 0; u < reduced.isState.size(); ++u)
        if (reduced.isState[u] &&
            (*reduced.system.pool)[reduced.system.unknowns[u].node].operation != Operation::Variable)
            faults.push_back(error(phrase("{} would have to be a state; give it a name of its own in the model.",
                                          reduced.system.nameOf(static_cast<int>(u))),
                                   reduced.system.unknowns[u].declared));
    return faults;
}

}  // namespace

namespace {

Outcome<Structure> analysed(const std::shared_ptr<const FlatModel>& model, const StructureOptions& options) {
    Structure out;
    if (!model->events.refusals.empty()) return model->events.refusals.front();  // one says what the model is
    for (const FlatEvents::Check& check : model->events.checks)
        if (!check.isTerminate)
            out.warnings.push_back(warning(
                phrase("the assertion is not checked: its condition changes while the model runs"), check.span));
    Outcome<FoldedModel> folded = fold(*model, options);
    if (!folded) return folded.diagnostics();
    out.equationsBefore = static_cast<int>(folded->system.equations.size());
    out.parameters = folded->parameters;
    out.parameterValues = folded->parameterValues;
    out.parameterBlocks = folded->parameterBlocks;
    out.folded = folded->folded;

    Outcome<AliasedSystem> aliased = eliminateAliases(std::move(*folded));
    if (!aliased) return aliased.diagnostics();
    out.equationsAfter = static_cast<int>(aliased->system.equations.size());
    out.aliases = std::move(aliased->aliases);
    append(out.warnings, aliased->warnings);

    Outcome<ReducedSystem> reduced = reduceIndex(std::move(aliased->system), aliased->redundant);
    if (!reduced) return reduced.diagnostics();
    out.indexReduction = reduced->differentiated;
    if (Diagnostics faults = unnamedStates(*reduced); !faults.empty()) return faults;

    EquationSystem& system = reduced->system;
    Outcome<std::vector<SolutionBlock>> blocks = orderSolution(system, system.equations, reduced->isState);
    if (!blocks) return blocks.diagnostics();
    out.blocks = std::move(*blocks);
    Outcome<std::vector<SolutionBlock>> initial = orderInitialisation(*reduced, out.warnings);
    if (!initial) return initial.diagnostics();
    out.initialBlocks = std::move(*initial);

    listStates(*reduced, out);
    listStarts(*reduced, out);
    out.pool = system.pool;
    for (std::uint32_t i = 0; i < model->variables.size(); ++i) {
        if (model->variables[i].causality == FlatCausality::Input) out.inputs.push_back({i});
        if (model->variables[i].causality == FlatCausality::Output) out.outputs.push_back({i});
    }
    out.model = system.model;
    delayInputsInstead(out);
    out.delays = delaysOf(out);
    return out;
}

}  // namespace

Outcome<Structure> analyse(std::shared_ptr<const FlatModel> model, const StructureOptions& options) {
    return guardedOutcome([&] { return analysed(model, options); });
}

namespace {

std::string nodeText(const Structure& s, ExpressionId id) {
    return s.pool->print(id, [&](VariableId v) { return (*s.model)[v].name; });
}

void printBlocks(const Structure& s, const char* title, const std::vector<SolutionBlock>& blocks, std::string& text) {
    if (blocks.empty()) return;
    text += fmt::format("{}\n", title);
    for (const SolutionBlock& block : blocks) {
        if (block.isExplicit) {
            text += fmt::format("  {} := {}\n", nodeText(s, block.unknowns[0]), nodeText(s, block.expressions[0]));
            continue;
        }
        std::string unknowns;
        for (const ExpressionId z : block.unknowns) unknowns += (unknowns.empty() ? "" : ", ") + nodeText(s, z);
        text += fmt::format("  solve {} for {}  ({} torn from {})\n", block.isLinear ? "linear" : "nonlinear", unknowns,
                            block.unknowns.size(), block.torn.size());
        for (const ExpressionId r : block.expressions) text += fmt::format("    0 = {}\n", nodeText(s, r));
    }
}

}  // namespace

std::string print(const Structure& s) {
    std::string text = fmt::format("{}: {} equations, {} after alias elimination, {} differentiated\n", s.model->name,
                                   s.equationsBefore, s.equationsAfter, s.indexReduction);
    const auto list = [&](const char* title, const std::vector<VariableId>& ids) {
        if (ids.empty()) return;
        text += title;
        for (const VariableId id : ids) text += " " + (*s.model)[id].name;
        text += "\n";
    };
    list("inputs", s.inputs);
    list("outputs", s.outputs);
    list("parameters", s.parameters);
    list("states", s.states);
    printBlocks(s, "from parameters", s.parameterBlocks, text);
    printBlocks(s, "at the start", s.initialBlocks, text);
    printBlocks(s, "equations", s.blocks, text);
    if (!s.states.empty()) text += "derivatives\n";
    for (std::size_t i = 0; i < s.states.size(); ++i)
        text += fmt::format("  der({}) := {}\n", (*s.model)[s.states[i]].name, nodeText(s, s.stateDerivatives[i]));
    if (!s.aliases.empty()) text += "aliases\n";
    for (const auto& [variable, stand] : s.aliases)
        text += fmt::format("  {} = {}\n", (*s.model)[variable].name, nodeText(s, stand));
    return text;
}

}  // namespace analogon
