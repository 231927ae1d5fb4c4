#include "ui/document/told_values.hpp"

#include <algorithm>

namespace analogon::ui {

namespace {

/// Units say how a number is shown, and no value.
bool tellsValue(const syntax::Modification& modification) {
    const std::string name = modification.name.text();
    return name != "unit" && name != "displayUnit" && name != "quantity";
}

}  // namespace

bool isAnyValueTold(const Study& study, const syntax::ClassDefinition& model) {
    return std::any_of(study.parameters.begin(), study.parameters.end(),
                       [](const auto& entry) { return entry.second.value.has_value(); }) ||
           !model.bases.empty() ||
           std::any_of(model.components.begin(), model.components.end(), [](const syntax::Component& component) {
               // what somebody has drawn or taken from elsewhere may hold values of its own
               return !component.type.text().starts_with("Analogon.") || component.binding ||
                      component.variability == syntax::Variability::Parameter ||
                      std::any_of(component.modifications.begin(), component.modifications.end(), tellsValue);
           });
}

}  // namespace analogon::ui
