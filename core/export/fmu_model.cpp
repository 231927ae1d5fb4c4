#include "core/export/fmu_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/unit.hpp"
#include "core/report/svg_plot.hpp"

namespace analogon {

namespace {

using Kind = FmuVariable::Kind;

std::string attribute(const char* name, const std::string& value) {
    return fmt::format(" {}=\"{}\"", name, escapeHtml(value));
}

/// Units of angles: FMI counts the radian among the base units, where SI and our units count it as 1.
bool isOfAngle(std::string_view unit) {
    for (const std::string_view start : {"rad", "deg", "rpm", "krpm"})
        if (unit.starts_with(start) && !unit.starts_with("degC") && !unit.starts_with("degF")) return true;
    return false;
}

/// The base unit in SI, or nothing where it has fractional powers or is no known unit.
std::string baseUnit(const std::string& unit) {
    static constexpr std::array names{"m", "kg", "s", "A", "K", "mol", "cd"};
    const std::optional<Dimension> dimension = dimensionOf(unit);
    if (!dimension) return {};
    std::string text, si = analogon::text(*dimension);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double power = (*dimension)[i];
        if (power != std::round(power)) return {};
        if (power != 0) text += fmt::format(" {}=\"{}\"", names[i], static_cast<int>(power));
    }
    if (isOfAngle(unit)) {
        const auto isSeconds = [&](double power) {
            Dimension expected{};
            expected[2] = power;
            return *dimension == expected;
        };
        const char* const angle = isSeconds(0) ? "rad" : isSeconds(-1) ? "rad/s" : isSeconds(-2) ? "rad/s2" : nullptr;
        if (angle) {
            text += " rad=\"1\"";
            si = angle;
        }
    }
    const Outcome<UnitConversion> conversion = convertUnit(unit, si);
    if (!conversion) return {};
    if (conversion->factor != 1) text += fmt::format(" factor=\"{}\"", conversion->factor);
    if (conversion->offset != 0) text += fmt::format(" offset=\"{}\"", conversion->offset);
    return fmt::format("<BaseUnit{}/>", text);
}

std::string unitDefinitions(const FmuModel& model) {
    std::set<std::string> units;
    for (const FmuVariable& v : model.variables)
        if (!v.unit.empty()) units.insert(v.unit);
    if (units.empty()) return {};
    std::string text = "  <UnitDefinitions>\n";
    for (const std::string& unit : units) {
        const std::string base = baseUnit(unit);
        text += fmt::format("    <Unit{}{}\n", attribute("name", unit), base.empty() ? "/>" : ">" + base + "</Unit>");
    }
    return text + "  </UnitDefinitions>\n";
}

/// How an FMU can be run, with the files to compile.
std::string interfaceElement(const char* element, const FmuModel& model, const char* more) {
    return fmt::format("  <{0}{1}{2}>\n    <SourceFiles>\n      <File name=\"fmu.c\"/>\n    </SourceFiles>\n  </{0}>\n",
                       element, attribute("modelIdentifier", model.identifier), more);
}

std::string scalarVariable(const FmuVariable& v) {
    std::string text =
        "    <ScalarVariable" + attribute("name", v.name) + fmt::format(" valueReference=\"{}\"", v.valueReference);
    if (!v.description.empty()) text += attribute("description", v.description);
    switch (v.kind) {
        case Kind::Parameter:
            text += fmt::format(" causality=\"parameter\" variability=\"{}\"", v.isFixed ? "fixed" : "tunable");
            break;
        case Kind::Input:
            text += " causality=\"input\" variability=\"continuous\"";
            break;
        case Kind::Output:
            text += " causality=\"output\" variability=\"continuous\" initial=\"calculated\"";
            break;
        case Kind::State:
        case Kind::Derivative:
            text += " causality=\"local\" variability=\"continuous\" initial=\"calculated\"";
    }
    text += ">\n      <Real";
    if (!v.unit.empty()) text += attribute("unit", v.unit);
    if (v.min) text += fmt::format(" min=\"{}\"", *v.min);
    if (v.max) text += fmt::format(" max=\"{}\"", *v.max);
    if (v.nominal != 1) text += fmt::format(" nominal=\"{}\"", v.nominal);
    if (v.stateOf) text += fmt::format(" derivative=\"{}\"", *v.stateOf + 1);
    if (v.start) text += fmt::format(" start=\"{}\"", *v.start);
    return text + "/>\n    </ScalarVariable>\n";
}

/// An unknown with what it depends on.
std::string unknown(const FmuModel& model, std::size_t variable, const DependsOn& on) {
    std::vector<std::size_t> known;
    for (const int i : on.inputs) known.push_back(model.inputs[static_cast<std::size_t>(i)] + 1);
    for (const int i : on.states) known.push_back(model.states[static_cast<std::size_t>(i)] + 1);
    std::sort(known.begin(), known.end());
    return fmt::format("      <Unknown index=\"{}\" dependencies=\"{}\"/>\n", variable + 1, fmt::join(known, " "));
}

std::string modelStructure(const FmuModel& model) {
    std::string text = "  <ModelStructure>\n";
    const auto group = [&](const char* name, const std::string& content) {
        if (!content.empty()) text += fmt::format("    <{0}>\n{1}    </{0}>\n", name, content);
    };
    std::string outputs, derivatives, initial;
    for (std::size_t i = 0; i < model.outputs.size(); ++i)
        outputs += unknown(model, model.outputs[i], model.code.outputs[i]);
    for (std::size_t i = 0; i < model.derivatives.size(); ++i)
        derivatives += unknown(model, model.derivatives[i], model.code.derivatives[i]);
    std::set<std::size_t> unknowns(model.outputs.begin(), model.outputs.end());
    unknowns.insert(model.states.begin(), model.states.end());
    unknowns.insert(model.derivatives.begin(), model.derivatives.end());
    for (const std::size_t i : unknowns) initial += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
    group("Outputs", outputs);
    group("Derivatives", derivatives);
    group("InitialUnknowns", initial);
    return text + "  </ModelStructure>\n";
}

}  // namespace

std::string modelDescription(const FmuModel& model, const std::string& guid) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"2.0\"" +
                       attribute("modelName", model.name) + attribute("guid", guid) +
                       attribute("description", "The model of the study \"" + model.study + "\", as fitted") +
                       " generationTool=\"Analogon\" variableNamingConvention=\"structured\"" +
                       fmt::format(" numberOfEventIndicators=\"{}\">\n", model.system->rootCount());
    if (model.hasModelExchange)
        text += interfaceElement("ModelExchange", model, " completedIntegratorStepNotNeeded=\"true\"");
    text += interfaceElement("CoSimulation", model,
                             " canHandleVariableCommunicationStepSize=\"true\" canInterpolateInputs=\"true\"");
    text += unitDefinitions(model);
    text +=
        "  <LogCategories>\n    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>\n"
        "  </LogCategories>\n";
    if (model.experiment)
        text +=
            fmt::format("  <DefaultExperiment startTime=\"{}\" stopTime=\"{}\" tolerance=\"{}\" stepSize=\"{}\"/>\n",
                        model.experiment->start, model.experiment->stop, model.tolerance, model.experiment->step);
    text += "  <ModelVariables>\n";
    for (std::size_t i = 0; i < model.variables.size(); ++i)
        text += fmt::format("    <!-- {} -->\n", i + 1) + scalarVariable(model.variables[i]);
    return text + "  </ModelVariables>\n" + modelStructure(model) + "</fmiModelDescription>\n";
}

std::string modelDocumentation(const FmuModel& model) {
    const std::string name = escapeHtml(model.name);
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}</title></head>\n<body>\n"
        "<h1>{0}</h1>\n<p>The model of the study \"{1}\" with its fitted values, as an FMU 2.0 for {2}. It has {3} "
        "states and {4} event indicators.</p>\n",
        name, escapeHtml(model.study), model.hasModelExchange ? "Co-Simulation and Model Exchange" : "Co-Simulation",
        model.system->stateCount(), model.system->rootCount());
    const auto table = [&](const char* title, Kind kind, bool hasStart) {
        std::string rows;
        for (const FmuVariable& v : model.variables)
            if (v.kind == kind)
                rows += fmt::format("<tr><td>{}</td>{}<td>{}</td><td>{}</td></tr>\n", escapeHtml(v.name),
                                    hasStart ? fmt::format("<td>{}</td>", v.start.value_or(0)) : std::string(),
                                    escapeHtml(v.unit), escapeHtml(v.description));
        if (!rows.empty())
            text += fmt::format("<h2>{}</h2>\n<table>\n<tr><th>Name</th>{}<th>Unit</th><th></th></tr>\n{}</table>\n",
                                title, hasStart ? "<th>Value</th>" : "", rows);
    };
    table("Inputs", Kind::Input, true);
    table("Outputs", Kind::Output, false);
    table("Parameters", Kind::Parameter, true);
    text +=
        "<h2>Use</h2>\n<p>Between two communication points inputs are held, or run linearly where their first "
        "derivatives are given (fmi2SetRealInputDerivatives), as they do between the samples of a recording. The step "
        "is integrated with a step size control of its own (RODAS, L-stable, order 4) to the tolerance of the "
        "experiment; it stops where relations switch, and follows them where they hold the motion (dry friction at "
        "rest).</p>\n";
    if (!model.hasModelExchange)
        text +=
            "<p>The equations need the past of a signal or the rate of an input, which Model Exchange does not "
            "provide.</p>\n";
    text += fmt::format(
        "<p>For another platform compile sources/fmu.c to {0}: <code>cc -O2 -shared -fPIC "
        "-DFMI2_OVERRIDE_FUNCTION_PREFIX -o {0}.so fmu.c -lm</code>. Linked statically, functions begin with "
        "{0}_.</p>\n</body>\n</html>\n",
        model.identifier);
    return text;
}

}  // namespace analogon
