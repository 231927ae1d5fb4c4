#include "core/flat/measured_variables.hpp"

#include <algorithm>

#include "core/flat/flattening.hpp"
#include "core/library/measured_signals.hpp"

namespace analogon {
namespace {

bool isLocalReal(const FlatVariable& variable) {
    return variable.type == FlatType::Real && variable.variability == FlatVariability::Continuous &&
           variable.causality == FlatCausality::Local;
}

/// Whether a block has neither an input nor a physical connector.
bool onlyProduces(const Flattening& work, const Instance& block) {
    for (std::size_t i = 0; i < work.records.size(); ++i) {
        const VariableRecord& record = work.records[i];
        if (!record.owner || &record.owner->component() != &block) continue;
        if (record.causality == syntax::Causality::Input || work.model.variables[i].isFlow) return false;
    }
    return true;
}

/// The equation of its block that sets a variable alone; the end where there is none.
auto settingEquation(FlatModel& model, VariableId variable) {
    const auto isIt = [&](ExpressionId side) {
        const ExpressionNode& node = (*model.pool)[side];
        return node.operation == Operation::Variable && node.variable == variable;
    };
    return std::find_if(model.equations.begin(), model.equations.end(), [&](const FlatEquation& e) {
        return !e.fromConnection && !e.isDiscrete && (isIt(e.left) || isIt(e.right));
    });
}

void driveByRecording(Flattening& work, VariableId id) {
    const VariableRecord& record = work.records[id.value];
    if (!record.owner || record.causality != syntax::Causality::Output) return;
    const Instance& block = record.owner->component();
    if (!block.parent || !onlyProduces(work, block)) return;
    const auto own = settingEquation(work.model, id);
    if (own == work.model.equations.end()) return;
    work.model.equations.erase(own);
    work.model.variables[id.value].causality = FlatCausality::Input;
}

}  // namespace

void takeMeasured(Flattening& work) {
    const MeasuredSignals& measured = work.library.measured(work.model.name);
    const auto each = [&](const std::vector<std::string>& names, const auto& take) {
        for (const std::string& name : names) {
            const VariableId id = work.model.find(name);
            if (id.valid() && isLocalReal(work.variable(id))) take(id);
        }
    };
    each(measured.driven, [&](VariableId id) { driveByRecording(work, id); });
    each(measured.compared, [&](VariableId id) { work.model.variables[id.value].causality = FlatCausality::Output; });
}

}  // namespace analogon
