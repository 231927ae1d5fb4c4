#include "ui/document/model_facts.hpp"

#include <algorithm>

#include "core/flat/declared.hpp"
#include "core/study/parameter_reader.hpp"

namespace analogon::ui {

std::string unitOf(const std::vector<SignalFact>& facts, const std::string& signal) {
    const auto found = std::find_if(facts.begin(), facts.end(), [&](const SignalFact& f) { return f.name == signal; });
    return found == facts.end() ? std::string() : found->unit;
}

namespace {

/// What the simulation alone knows, "pre(v)", "initial()" and "$when1": nobody measures it or asks for it.
bool isOfEvents(const FlatVariable& v) {
    return v.isProtected && (v.causality == FlatCausality::Input || v.name.starts_with('$'));
}

}  // namespace

ModelFacts modelFacts(const Study& study) {
    ModelFacts facts;
    const Outcome<Library> library = studyLibrary(study);
    facts.messages = library.diagnostics();
    if (!library) return facts;
    Outcome<FlatModel> flat = flatten(*library, study.className);
    facts.messages.insert(facts.messages.end(), flat.diagnostics().begin(), flat.diagnostics().end());
    const bool isWhole = flat.hasValue();
    if (!isWhole) flat = declared(*library, study.className);
    for (Diagnostic& fault : isWhole ? outsideRange(*flat, study) : Diagnostics())
        facts.messages.push_back(std::move(fault));
    for (std::size_t i = 0; i < flat->variables.size(); ++i) {
        if (isOfEvents(flat->variables[i])) continue;
        const FlatVariable& v = flat->variables[i];
        if (flat->isInput({static_cast<std::uint32_t>(i)}))
            facts.inputs.push_back({v.name, flat->unitOf(v), v.description});
        if (v.causality == FlatCausality::Output) facts.outputs.push_back({v.name, flat->unitOf(v), v.description});
        if (v.variability == FlatVariability::Continuous && v.type != FlatType::String)
            facts.variables.push_back({v.name, flat->unitOf(v), v.description});
        const bool isListed =
            v.variability == FlatVariability::Parameter && v.type == FlatType::Real && !v.isFinal && !v.isProtected;
        if (!isListed) continue;
        const auto value = flat->parameterValue(VariableId{static_cast<std::uint32_t>(i)});
        facts.parameters.push_back({v.name, v.unit, v.description, value, v.min, v.max});
    }
    if (!isWhole) facts.variables.clear();  // there is nothing to simulate them with
    return facts;
}

}  // namespace analogon::ui
