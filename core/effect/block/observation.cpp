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

/// What the texts of an effect name of its own instance.
struct Wanted {
    std::set<std::string> variables;
    bool through{};  // what flows through the nodes of its ports

    bool isEmpty() const { return variables.empty(); }
};

Wanted wantedBy(const EffectClass& effect) {
    std::vector<std::string> texts = effect.trial.secant;
    for (const auto& [name, text] : effect.parameters.fixed) texts.push_back(text);
    for (const auto& [name, list] : effect.parameters.shape) texts.insert(texts.end(), list.begin(), list.end());
    if (!effect.trial.valid.empty()) texts.push_back(effect.trial.valid);
    Wanted wanted;
    for (const std::string& t : texts) {
        for (const std::string& v : shapeVariables(t)) wanted.variables.insert(v);
        wanted.through = wanted.through || t.find("through(") != std::string::npos;
    }
    if (!effect.wave.along.empty()) wanted.variables.insert(effect.wave.along);
    return wanted;
}

/// Flow variables at the other connectors of the node an effect sits on.
std::vector<std::string> flowsBeside(const PlacedEffect& placed, const FlatModel& model) {
    if (placed.effect.placement.ports.empty()) return {};
    std::vector<std::string> flows;
    for (const std::string& port : placed.effect.placement.ports) {
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

/// The variables of one effect, which lie in the rows `first` and after of what was observed, its flows behind them.
Observations observationsOf(const NullModel& null, const PreparedTask& held, const PlacedEffect& placed,
                            const Wanted& wanted, const std::vector<Trajectory>& traces, Eigen::Index first,
                            std::size_t flows) {
    Observations observations;
    std::vector<std::vector<double>> times;
    std::map<std::string, std::vector<std::vector<double>>> series;
    for (std::size_t e = 0; e < traces.size(); ++e) {
        const Eigen::MatrixXd& observed = traces[e].observed;
        times.push_back(held.problem.experiments[e].inputs.time);
        const bool isSeen = observed.cols() > 0;  // else its simulation failed
        Eigen::Index row = first;
        for (const std::string& v : wanted.variables) {
            const Eigen::VectorXd x = isSeen ? Eigen::VectorXd(observed.row(row)) : Eigen::VectorXd();
            series[v].emplace_back(x.begin(), x.end());
            ++row;
        }
        if (!wanted.through) continue;
        // what flows through the node: half the sum of all flows into its members
        Eigen::VectorXd through = Eigen::VectorXd::Zero(observed.cols());
        for (std::size_t i = 0; isSeen && i < flows; ++i)
            through += 0.5 * observed.row(row + static_cast<Eigen::Index>(i)).cwiseAbs().transpose();
        for (const std::string& port : placed.effect.placement.ports)
            series["through " + port].emplace_back(through.begin(), through.end());
    }
    observations.setTimes(std::move(times));
    for (auto& [name, x] : series) observations.add(name, std::move(x));
    if (!series.contains(placed.effect.wave.along)) return observations;
    std::vector<Eigen::VectorXd> simulated;
    for (const std::vector<double>& x : observations.series(placed.effect.wave.along))
        simulated.emplace_back(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
    if (std::optional<std::vector<Eigen::VectorXd>> lead = recordedLead(null, held.problem, simulated))
        observations.setLead(placed.effect.wave.along, std::move(*lead));
    return observations;
}

}  // namespace

Outcome<std::vector<Observations>> observeNewest(const NullModel& null, const Variant& off, std::size_t count,
                                                 const PreparedTask& held, const SimulationOptions& simulation) {
    const std::size_t begin = off.effects.size() - count;
    std::optional<FlatModel> flat;
    std::vector<Wanted> wanted;
    std::vector<std::size_t> flows;
    std::vector<std::string> names;
    for (std::size_t i = begin; i < off.effects.size(); ++i) {
        const PlacedEffect& placed = off.effects[i];
        wanted.push_back(wantedBy(placed.effect));
        for (const std::string& v : wanted.back().variables) names.push_back(placed.instance + "." + v);
        flows.push_back(0);
        if (!wanted.back().through) continue;
        if (!flat) {
            Outcome<FlatModel> whole = flatten(off.task.library, off.task.className);
            if (!whole) return whole.diagnostics();
            flat = std::move(*whole);
        }
        const std::vector<std::string> beside = flowsBeside(placed, *flat);
        flows.back() = beside.size();
        names.insert(names.end(), beside.begin(), beside.end());
    }
    std::vector<Observations> all(count);
    if (names.empty()) return all;
    const std::vector<Trajectory> traces = observe(null, held, names, simulation);
    Eigen::Index first = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!wanted[i].isEmpty())
            all[i] = observationsOf(null, held, off.effects[begin + i], wanted[i], traces, first, flows[i]);
        first += static_cast<Eigen::Index>(wanted[i].variables.size() + flows[i]);
    }
    return all;
}

Outcome<Observations> observeFor(const NullModel& null, const Variant& off, const SimulationOptions& simulation) {
    if (wantedBy(off.effects.back().effect).isEmpty()) return Observations();
    Outcome<PreparedTask> held = prepareHeld(off, {}, null.noise);
    if (!held) return held.diagnostics();
    Outcome<std::vector<Observations>> newest = observeNewest(null, off, 1, *held, simulation);
    if (!newest) return newest.diagnostics();
    return std::move(newest->front());
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

Outcome<std::map<std::string, double>> fixedOf(const EffectClass& effect, const ShapeContext& context) {
    std::map<std::string, double> fixed;
    for (const auto& [name, text] : effect.parameters.fixed) {
        const Outcome<double> value = shapeValue(text, context);
        if (!value) return value.diagnostics();
        fixed[name] = *value;
    }
    return fixed;
}

Outcome<std::vector<double>> strengthsOf(const EffectClass& effect, const ShapeContext& context) {
    std::vector<double> strengths;
    for (const std::string& text : effect.trial.secant) {
        const Outcome<double> strength = shapeValue(text, context);
        if (!strength) return strength.diagnostics();
        if (*strength != 0) strengths.push_back(*strength);
    }
    if (strengths.empty()) strengths.push_back(0);
    return strengths;
}

Outcome<std::vector<std::map<std::string, double>>> shapesOf(const EffectClass& effect, const ShapeContext& anyStrength,
                                                             double strength) {
    ShapeContext context = anyStrength;
    context.quantity = [&](const std::string& name) {
        return name == effect.parameters.strength ? strength : anyStrength.quantity(name);
    };
    std::vector<std::map<std::string, double>> shapes{{}};
    for (const auto& [name, list] : effect.parameters.shape) {
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
    if (effect.trial.valid.empty()) return shapes;
    std::vector<std::map<std::string, double>> valid;
    for (std::map<std::string, double>& s : shapes) {
        ShapeContext with = context;
        with.quantity = [&](const std::string& name) {
            const auto own = s.find(name);
            return own == s.end() ? context.quantity(name) : own->second;
        };
        Outcome<double> value = shapeValue(effect.trial.valid, with);
        if (!value) return value.diagnostics();
        if (*value > 0) valid.push_back(std::move(s));
    }
    if (valid.empty())
        return error(phrase("the recording does not show what tells this effect apart: {} > 0", effect.trial.valid));
    return valid;
}

}  // namespace analogon
