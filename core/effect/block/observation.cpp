#include "core/effect/block/observation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "core/effect/block/recorded_lead.hpp"

namespace analogon {

double Observations::statistic(const std::string& function, const std::string& variable) const {
    const std::string name = function == "through" ? "through " + variable : variable;
    const auto& series = recorded_.contains(name) ? recorded_ : series_;
    const auto found = series.find(name);
    if (found == series.end()) return std::nan("");
    double low = 1e300, high = -1e300, sum = 0, squares = 0, largestRate = 0, count = 0;
    for (std::size_t e = 0; e < found->second.size(); ++e) {
        const std::vector<double>& x = found->second[e];
        for (std::size_t k = 0; k < x.size(); ++k) {
            if (!std::isfinite(x[k])) continue;
            low = std::min(low, x[k]);
            high = std::max(high, x[k]);
            sum += x[k];
            squares += x[k] * x[k];
            count += 1;
            if (k > 0)
                largestRate = std::max(largestRate, std::abs(x[k] - x[k - 1]) / (times_[e][k] - times_[e][k - 1]));
        }
    }
    if (count == 0) return std::nan("");
    if (function == "range") return high - low;
    if (function == "maxabs") return std::max(std::abs(low), std::abs(high));
    if (function == "rms" || function == "through") return std::sqrt(squares / count);
    if (function == "mean") return sum / count;
    if (function == "minimum") return low;
    if (function == "maximum") return high;
    if (function == "rate") return largestRate;
    if (function == "start") return found->second.front().front();
    return std::nan("");
}

namespace {

std::vector<std::string> texts(const EffectClass& effect) {
    std::vector<std::string> all = effect.secant;
    for (const auto& [name, text] : effect.fixed) all.push_back(text);
    for (const auto& [name, list] : effect.shape) all.insert(all.end(), list.begin(), list.end());
    if (!effect.valid.empty()) all.push_back(effect.valid);
    return all;
}

/// Flow variables at the other connectors of the node an effect sits on.
std::vector<std::string> flowsBeside(const PlacedEffect& placed, const FlatModel& model) {
    if (placed.effect.ports.empty()) return {};
    std::vector<std::string> flows;
    for (const std::string& port : placed.effect.ports) {
        const ConnectionSet* set = model.connectionOf(placed.instance + "." + port);
        if (set == nullptr) continue;
        for (const std::string& connector : set->connectors) {
            if (connector.rfind(placed.instance + ".", 0) == 0) continue;
            for (const FlatVariable& v : model.variables)
                if (v.isFlow && v.name.rfind(connector + ".", 0) == 0) flows.push_back(v.name);
        }
    }
    return flows;
}

}  // namespace

Outcome<Observations> observeFor(const NullModel& null, const Variant& off, const SimulationOptions& simulation) {
    const PlacedEffect& placed = off.effects.back();
    std::set<std::string> variables;
    bool wantsFlow = false;
    for (const std::string& t : texts(placed.effect)) {
        for (const std::string& v : shapeVariables(t)) variables.insert(v);
        wantsFlow = wantsFlow || t.find("through(") != std::string::npos;
    }
    if (!placed.effect.along.empty()) variables.insert(placed.effect.along);
    Observations observations;
    if (variables.empty()) return observations;
    Outcome<PreparedTask> held = prepareHeld(off, {}, null.noise);
    if (!held) return held.diagnostics();
    std::vector<std::string> flows;
    if (wantsFlow) {
        Outcome<FlatModel> flat = flatten(off.task.library, off.task.className);
        if (!flat) return flat.diagnostics();
        flows = flowsBeside(placed, *flat);
    }

    std::vector<std::string> names;
    for (const std::string& v : variables) names.push_back(placed.instance + "." + v);
    names.insert(names.end(), flows.begin(), flows.end());
    std::vector<std::vector<double>> times;
    std::map<std::string, std::vector<std::vector<double>>> series;
    const std::vector<Trajectory> traces = observe(null, *held, names, simulation);
    for (std::size_t e = 0; e < traces.size(); ++e) {
        const Trajectory& t = traces[e];
        times.push_back(held->problem.experiments[e].inputs.time);
        std::size_t row = 0;
        for (const std::string& v : variables) {
            std::vector<double> x(static_cast<std::size_t>(t.observed.cols()));
            for (std::size_t k = 0; k < x.size(); ++k)
                x[k] = t.observed(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
            series[v].push_back(std::move(x));
            ++row;
        }
        // what flows through the node: half the sum of all flows into its members
        std::vector<double> through(static_cast<std::size_t>(t.observed.cols()), 0);
        for (; row < names.size(); ++row)
            for (std::size_t k = 0; k < through.size(); ++k)
                through[k] += 0.5 * std::abs(t.observed(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)));
        if (wantsFlow)
            for (const std::string& port : placed.effect.ports) series["through " + port].push_back(through);
    }
    observations.setTimes(std::move(times));
    for (auto& [name, x] : series) observations.add(name, std::move(x));
    if (series.contains(placed.effect.along)) {
        std::vector<Eigen::VectorXd> simulated;
        for (const std::vector<double>& x : observations.series(placed.effect.along))
            simulated.emplace_back(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
        if (std::optional<std::vector<Eigen::VectorXd>> lead = recordedLead(null, held->problem, simulated))
            observations.setLead(placed.effect.along, std::move(*lead));
    }
    return observations;
}

ShapeContext contextOf(const NullModel& null, const Observations& observations) {
    ShapeContext context;
    context.quantity = [&null](const std::string& name) {
        const std::vector<double>* time = nullptr;
        for (const Recording& r : null.variant.task.recordings)
            if (r.role == Role::Fit && time == nullptr) time = &r.time;
        if (time == nullptr || time->size() < 2) return std::nan("");
        const double duration = time->back() - time->front();
        if (name == "duration") return duration;
        if (name == "sample") return duration / static_cast<double>(time->size() - 1);
        if (name == "period") return null.period > 0 ? null.period : std::nan("");
        if (name == "pi") return std::numbers::pi;
        return std::nan("");
    };
    context.statistic = [&observations](const std::string& function, const std::string& variable) {
        return observations.statistic(function, variable);
    };
    return context;
}

Outcome<std::vector<std::map<std::string, double>>> shapesOf(const EffectClass& effect, const ShapeContext& anyStrength,
                                                             double strength) {
    ShapeContext context = anyStrength;
    context.quantity = [&](const std::string& name) {
        return name == effect.strength ? strength : anyStrength.quantity(name);
    };
    std::vector<std::map<std::string, double>> shapes{{}};
    for (const auto& [name, list] : effect.shape) {
        std::vector<std::map<std::string, double>> wider;
        for (const std::string& text : list) {
            Outcome<double> value = shapeValue(text, context);
            if (!value) return value.diagnostics();
            for (std::map<std::string, double> s : shapes) {
                s[name] = *value;
                wider.push_back(std::move(s));
            }
        }
        shapes = std::move(wider);
    }
    if (effect.valid.empty()) return shapes;
    std::vector<std::map<std::string, double>> valid;
    for (std::map<std::string, double>& s : shapes) {
        ShapeContext with = context;
        with.quantity = [&](const std::string& name) {
            const auto own = s.find(name);
            return own == s.end() ? context.quantity(name) : own->second;
        };
        Outcome<double> value = shapeValue(effect.valid, with);
        if (!value) return value.diagnostics();
        if (*value > 0) valid.push_back(std::move(s));
    }
    if (valid.empty())
        return error(phrase("the recording does not show what tells this effect apart: {} > 0", effect.valid));
    return valid;
}

}  // namespace analogon
