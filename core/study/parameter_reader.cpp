#include "core/study/parameter_reader.hpp"

#include <algorithm>
#include <cmath>

#include "core/fit/clock.hpp"
#include "core/flat/range.hpp"
#include "core/study/default_bounds.hpp"

namespace analogon {

ParameterReader::ParameterReader(const Study& study, const StudyPlaces& places, const FlatModel& model,
                                 Diagnostics& said)
    : study_(study), places_(places), model_(model), said_(said) {
    for (const FlatVariable& variable : model.variables) {
        if (variable.type != FlatType::Real || variable.isFinal) continue;
        if (variable.variability == FlatVariability::Parameter) names_.push_back(variable.name);
        if (variable.variability == FlatVariability::Constant || variable.causality == FlatCausality::Input) continue;
        startNames_.push_back(variable.name);
    }
}

void ParameterReader::fault(const std::string& pointer, Text message, Text hint) {
    said_.push_back(places_.fault(pointer, std::move(message), std::move(hint)));
}

const FlatVariable* ParameterReader::settable(const std::string& name, const std::string& pointer) {
    return find(name, pointer, false);
}

const FlatVariable* ParameterReader::startable(const std::string& name, const std::string& pointer) {
    return find(name, pointer, true);
}

const FlatVariable* ParameterReader::find(const std::string& name, const std::string& pointer, bool isStart) {
    const VariableId id = model_.find(name);
    if (!id.valid()) {
        if (isStart)
            fault(pointer, phrase("the model '{}' has no parameter and no variable '{}'", study_.className, name),
                  meantOrAvailable(name, startNames_, phrase("There is no parameter.")));
        else
            fault(pointer, phrase("the model '{}' has no parameter '{}'", study_.className, name),
                  meantOrAvailable(name, names_, phrase("There is no parameter.")));
        return nullptr;
    }
    const FlatVariable& variable = model_[id];
    Text reason;
    if (variable.isStructural) reason = phrase("a size or a condition that has shaped the equations");
    if (variable.variability == FlatVariability::Continuous) reason = phrase("a variable");
    if (variable.variability == FlatVariability::Constant) reason = phrase("a constant");
    if (variable.type == FlatType::Integer)
        reason = variable.isStructural
                     ? phrase("an Integer that has shaped the equations, as the size of an array does")
                     : phrase("an Integer");
    else if (variable.type != FlatType::Real)
        reason = phrase("no real number");
    if (variable.isFinal) reason = phrase("declared final");
    if (variable.isFoundAtStart) reason = phrase("computed by an initial equation");
    if (variable.isProtected && name.find('.') != std::string::npos) reason = phrase("protected");
    if (reason.empty()) return &variable;
    fault(pointer, phrase("'{}' cannot be set or fitted: it is {}", name, reason),
          phrase("Only real parameters that are neither final nor protected can."));
    return nullptr;
}

bool ParameterReader::isWithin(const FlatVariable& variable, double value, const std::string& pointer) {
    if (isWithinRange(variable, value)) return true;
    const bool isBelow = variable.min && value < *variable.min;
    const double bound = isBelow ? *variable.min : *variable.max;
    if (variable.variability == FlatVariability::Parameter)
        fault(pointer,
              isBelow ? phrase("the parameter '{}' is {}, below its min {}", variable.name, value, bound)
                      : phrase("the parameter '{}' is {}, above its max {}", variable.name, value, bound),
              phrase("change the value, or the range where the parameter is declared"));
    else
        fault(pointer,
              isBelow ? phrase("'{}' begins at {}, below its min {}", variable.name, value, bound)
                      : phrase("'{}' begins at {}, above its max {}", variable.name, value, bound),
              phrase("change the value, or the range where the variable is declared"));
    return false;
}

void ParameterReader::read(std::vector<FitParameter>& fitted, std::vector<std::pair<std::string, double>>& set) {
    for (const auto& [name, parameter] : study_.parameters) {
        const std::string pointer = "/parameters/" + JsonPlaces::escape(name);
        if (isClock(name)) {
            checkClock(signalOfClock(name), pointer);
            continue;
        }
        const FlatVariable* variable = settable(name, pointer);
        if (!variable || (parameter.value && !isWithin(*variable, *parameter.value, pointer + "/value"))) continue;
        if (parameter.fit) tellWhatIsPassedOver(*variable, pointer);
        if (parameter.fit) {
            readFitted(name, parameter, *variable, pointer, fitted);
        } else if (parameter.value) {
            set.emplace_back(name, *parameter.value);
        }
    }
    tellDefaultBounds();
}

/// A fit takes the place of a binding to other parameters, and reaches what the model protects.
void ParameterReader::tellWhatIsPassedOver(const FlatVariable& variable, const std::string& pointer) {
    if (variable.isProtected)
        said_.push_back(places_.remark(
            pointer, phrase("'{}' is protected in the model; it is fitted all the same", variable.name)));
    if (variable.binding.valid() && !model_.pool->leaves(std::span(&variable.binding, 1)).empty())
        said_.push_back(places_.remark(
            pointer, phrase("the model sets '{}' to {}; the fit gives it a value of its own", variable.name,
                            model_.pool->print(variable.binding, [&](VariableId v) { return model_[v].name; }))));
}

/// The range of the declaration holds for a fit, too: a bound beyond it is taken back to it.
void ParameterReader::setBounds(const StudyParameter& parameter, const FlatVariable& variable,
                                const std::string& pointer, FitParameter& fitted) {
    if (const auto min = parameter.min ? parameter.min : variable.min) fitted.min = *min;
    if (const auto max = parameter.max ? parameter.max : variable.max) fitted.max = *max;
    if (variable.min && fitted.min < *variable.min) {
        said_.push_back(places_.remark(pointer + "/min",
                                       phrase("the lower bound {} of '{}' lies below the min {} of its declaration, "
                                              "which holds",
                                              fitted.min, variable.name, *variable.min)));
        fitted.min = *variable.min;
    }
    if (variable.max && fitted.max > *variable.max) {
        said_.push_back(places_.remark(pointer + "/max",
                                       phrase("the upper bound {} of '{}' lies above the max {} of its declaration, "
                                              "which holds",
                                              fitted.max, variable.name, *variable.max)));
        fitted.max = *variable.max;
    }
}

/// Of what nobody has bounded and nothing is known of beforehand.
void ParameterReader::setDefaultBounds(const FlatVariable& variable, double start, FitParameter& fitted) {
    const std::optional<DefaultBounds> bounds = defaultBounds(variable.min, variable.max, start);
    if (!bounds || !(bounds->min < bounds->max)) return;
    fitted.min = bounds->min;
    fitted.max = bounds->max;
    unbounded_.push_back(variable.name);
}

void ParameterReader::tellDefaultBounds() {
    if (!unbounded_.empty()) said_.push_back(places_.remark("/parameters", defaultBoundsRemark(unbounded_)));
}

void ParameterReader::readFitted(const std::string& name, const StudyParameter& parameter, const FlatVariable& variable,
                                 const std::string& pointer, std::vector<FitParameter>& all) {
    const std::optional<double> start = parameter.value ? parameter.value : model_.parameterValue(model_.find(name));
    if (!start)
        return fault(pointer, phrase("the parameter '{}' has no value to start from", name),
                     phrase("Give one in the model, or as \"value\" in the study."));
    if (!isWithinRange(variable, *start)) return;  // that is said of the model already
    FitParameter fitted;
    fitted.name = name;
    fitted.unit = variable.unit;
    fitted.scale = parameter.scale;
    fitted.prior = parameter.prior;
    setBounds(parameter, variable, pointer, fitted);
    if (!parameter.min && !parameter.max && !parameter.prior) setDefaultBounds(variable, *start, fitted);
    if (!(fitted.min < fitted.max))
        return fault(pointer, phrase("'{}' has no room between its bounds {} and {}", name, fitted.min, fitted.max),
                     phrase("Widen the bounds, or do not fit it: \"fit\": false."));
    // A start that was itself fitted to a bound may lie beyond it by the last digit.
    const double slack = 1e-9 * std::max(std::abs(*start), 1e-300);
    if (*start < fitted.min - slack || *start > fitted.max + slack)
        return fault(
            pointer,
            phrase("the start value {} of '{}' lies outside its bounds {} … {}", *start, name, fitted.min, fitted.max),
            phrase("Widen the bounds, or give another start as \"value\"."));
    fitted.start = std::clamp(*start, fitted.min, fitted.max);
    if (fitted.scale == ParameterScale::Logarithmic && fitted.start <= 0)
        return fault(pointer, phrase("'{}' starts at {}, where a logarithmic scale has no place", name, *start),
                     phrase("Start above 0, or use \"scale\": \"lin\"."));
    all.push_back(std::move(fitted));
}

void ParameterReader::checkClock(const std::string& output, const std::string& pointer) {
    if (!asksForClock(study_.experiments, output))
        fault(pointer, phrase("no experiment asks for the clock of the output '{}'", output),
              phrase("Map the output as {{\"column\": …, \"clock\": \"fit\"}}."));
}

Diagnostics outsideRange(const FlatModel& model, const Study& study) {
    const bool givesValues = std::any_of(study.parameters.begin(), study.parameters.end(),
                                         [](const auto& p) { return p.second.value.has_value(); });
    if (!givesValues) return outsideRange(model);
    FlatModel told = model;
    for (const auto& [name, parameter] : study.parameters) {
        const VariableId id = told.find(name);
        if (!parameter.value || !id.valid()) continue;
        FlatVariable& variable = told.variables[id.value];
        variable.binding = told.pool->constant(*parameter.value);
        variable.min.reset();
        variable.max.reset();
    }
    return outsideRange(told);
}

}  // namespace analogon
