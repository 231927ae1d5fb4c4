#include "core/effect/block/law_probe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>

#include "core/effect/block/flow_domain.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostAtOnce = 16;  // terms: each is evaluated with the slopes of all

/// As the blocks of the library look that have an equation and no name.
constexpr const char* icon = R"(  annotation (Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
    Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}));
)";

std::string coefficient(std::size_t i) { return "a" + std::to_string(i + 1); }

/// The name of a foreign quantity as it comes into the class.
std::string inputOf(const LawQuantity& q) { return q.origin != 0 ? q.name + "_in" : q.name; }

}  // namespace

LawSite siteOf(const ModelNodes::FlowNode& node) {
    LawSite site;
    site.place = node.place;
    const FlowDomain domain = flowDomain(node.flow);
    site.baseName = domain.lawName;
    site.declaration = fmt::format("{} port annotation (Placement(transformation(extent={{{{-110,-10}},{{-90,10}}}})))",
                                   node.connectorClass);
    site.sum = fmt::format("port.{} =", node.flow);
    site.shown = fmt::format("{}.{} =", node.place.connector, node.flow);
    site.unit = UnitFactors::of(std::string(domain.flowUnit));
    site.ports = {"port"};
    return site;
}

std::string trueReading(const std::string& output) { return output + "_true"; }

LawSite siteOf(const std::string& output, const std::string& unit) {
    LawSite site;
    site.place = {std::string(outputPrefix) + output, output, {}};
    site.baseName = "MissingReading";
    site.declaration = "extends Analogon.Interfaces.PartialSignal";
    site.sum = "y = u +";
    site.shown = fmt::format("{} = {} +", output, trueReading(output));
    site.unit = UnitFactors::of(unit);
    site.way = Way::Insert;
    site.ports = {"u", "y"};
    site.signalSide = "output";
    return site;
}

const LawQuantity& LawProbe::addOwn(LawQuantity quantity, std::string expression) {
    return own_.emplace_back(std::move(quantity), std::move(expression)).quantity;
}

const LawQuantity& LawProbe::addForeign(LawQuantity quantity) { return foreign_.emplace_back(std::move(quantity)); }

std::optional<Eigen::MatrixXd> LawProbe::traces(const SimulationOptions& simulation, const Progress& progress) const {
    if (terms_.empty()) return std::nullopt;
    Eigen::MatrixXd columns(null_->fit.optimum.residuals.size(), static_cast<Eigen::Index>(terms_.size()));
    for (std::size_t begin = 0; begin < terms_.size(); begin += mostAtOnce) {
        std::vector<std::size_t> some(std::min(mostAtOnce, terms_.size() - begin));
        std::iota(some.begin(), some.end(), begin);
        const std::optional<Eigen::MatrixXd> part = tracesOf(some, simulation, progress);
        if (!part) return std::nullopt;
        columns.middleCols(static_cast<Eigen::Index>(begin), part->cols()) = *part;
    }
    return columns;
}

/// The columns of these terms.
std::optional<Eigen::MatrixXd> LawProbe::tracesOf(const std::vector<std::size_t>& some,
                                                  const SimulationOptions& simulation, const Progress& progress) const {
    const std::string name = className(0);
    const std::string text = classText(name, some);
    Outcome<Library> library = null_->variant.task.library.withSource(std::make_shared<Source>(name + ".mo", text));
    if (!library) return std::nullopt;
    Variant variant = null_->variant;
    variant.task.library = std::move(*library);
    Outcome<Variant> wired = withEffect(variant, effect(name, some), site_.place, {});
    if (!wired) return std::nullopt;
    std::vector<FitParameter> free;
    for (std::size_t i = 0; i < some.size(); ++i) {
        FitParameter p;
        p.name = wired->effects.back().instance + "." + coefficient(i);
        free.push_back(std::move(p));
    }
    Outcome<PreparedTask> held = prepareHeld(*wired, free, null_->noise);
    if (!held) return std::nullopt;
    const Eigen::VectorXd off = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(free.size()));
    const std::vector<GridPlan> plans = null_->plansOf(*held->system, simulation, progress);
    Linearisation l = linearise(held->problem, off, true, plans, simulation, progress);
    if (l.residuals.size() != null_->fit.optimum.residuals.size()) return std::nullopt;
    return std::move(l.jacobian);
}

Law LawProbe::law(const std::vector<std::size_t>& chosen, int number) const {
    const std::string name = className(number);
    return {{effect(name, chosen), site_.place}, classText(name, chosen)};
}

std::string LawProbe::className(int number) const {
    std::string name = site_.baseName + std::to_string(number);
    while (null_->variant.task.library.find(name) != nullptr) name += "_";
    return name;
}

/// Of a term's coefficient; empty: not known.
std::string LawProbe::unitOf(const Term& term) const {
    if (!site_.unit || !term.unit) return {};
    return site_.unit->times(*term.unit, -1).text();
}

bool LawProbe::uses(const std::vector<std::size_t>& chosen, const std::string& name) const {
    return std::any_of(chosen.begin(), chosen.end(), [&](std::size_t i) {
        const std::string& text = terms_[i].text;
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
            const auto isPart = [&](std::size_t k) {
                return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '_');
            };
            if ((at == 0 || !isPart(at - 1)) && !isPart(at + name.size())) return true;
        }
        return false;
    });
}

EffectClass LawProbe::effect(const std::string& name, const std::vector<std::size_t>& chosen) const {
    EffectClass e;
    e.className = name;
    e.description = "Law found in what a model leaves";
    e.kind = "proposal.law";
    e.placement.way = site_.way;
    e.placement.ports = site_.ports;
    e.placement.signalSide = site_.signalSide;
    e.parameters.strength = coefficient(0);
    std::vector<std::string> sum;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (i > 0) e.parameters.linear.push_back(coefficient(i));
        e.parameters.units[coefficient(i)] = unitOf(terms_[chosen[i]]);
        sum.push_back(coefficient(i) + "*" + terms_[chosen[i]].shown);
    }
    e.proposal = fmt::format("{} {}", site_.shown, fmt::join(sum, " + "));
    for (const LawQuantity& q : foreign_)
        if (uses(chosen, q.name)) e.bound[inputOf(q)] = q.variable;
    return e;
}

std::string LawProbe::classText(const std::string& name, const std::vector<std::size_t>& chosen) const {
    std::string text = fmt::format("model {} \"Law found in what a model leaves\"\n  {};\n", name, site_.declaration);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::string unit = unitOf(terms_[chosen[i]]);
        text += fmt::format("  parameter Real {}{} = 0;\n", coefficient(i),
                            unit.empty() || unit == "1" ? "" : fmt::format("(unit=\"{}\")", unit));
    }
    std::vector<std::string> equations;
    const auto define = [&](const LawQuantity& q, const std::string& value) {
        text += fmt::format("  Real {};\n", q.name);
        equations.push_back(q.origin == 0
                                ? fmt::format("{} = {}", q.name, value)
                                : fmt::format("{} = {} - ({})", q.name, value, syntax::printNumber(q.origin)));
    };
    for (const LawQuantity& q : foreign_)
        if (uses(chosen, q.name)) text += fmt::format("  input Real {} \"{}\";\n", inputOf(q), q.variable);
    for (const Own& own : own_)
        if (uses(chosen, own.quantity.name)) define(own.quantity, own.expression);
    for (const LawQuantity& q : foreign_)
        if (q.origin != 0 && uses(chosen, q.name)) define(q, inputOf(q));
    text += "equation\n";
    for (const std::string& e : equations) text += "  " + e + ";\n";
    std::vector<std::string> sum;
    for (std::size_t i = 0; i < chosen.size(); ++i) sum.push_back(coefficient(i) + "*" + terms_[chosen[i]].text);
    text += fmt::format("  {} {};\n{}end {};\n", site_.sum, fmt::join(sum, " + "), icon, name);
    return text;
}

}  // namespace analogon
