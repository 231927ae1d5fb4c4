#include "core/effect/block/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/unit.hpp"
#include "core/effect/block/recorded_lead.hpp"
#include "core/effect/model/shape_value.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {
namespace {

constexpr long evaluationsPerSample = 600;  // a candidate that needs more is no model of this recording
constexpr double quarterTurn = std::numbers::pi / 2;
constexpr double leastLead =
    0.02;  // [turns] of a wave, or of all that is passed, by which the recorded course is another
constexpr const char* recordedName = "recordedCourse";
constexpr double mostOfAWave = 1;     // [rad] that may pass in a step
constexpr int mostStepsOfAWave = 16;  // in a sample interval: what is faster averages out

/// Series of variables over the fitted experiments, simulated with the effect off.
class Observations {
public:
    void add(const std::string& variable, std::vector<std::vector<double>> series) {
        series_[variable] = std::move(series);
    }

    double statistic(const std::string& function, const std::string& variable) const {
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

    void setTimes(std::vector<std::vector<double>> times) { times_ = std::move(times); }

    /// By how much the variable was ahead of its simulation when it was recorded. What is asked of it is then told from
    /// the recording.
    void setLead(const std::string& variable, std::vector<Eigen::VectorXd> lead) {
        lead_ = std::move(lead);
        std::vector<std::vector<double>>& recorded = recorded_[variable] = series(variable);
        for (std::size_t e = 0; e < recorded.size(); ++e)
            for (std::size_t k = 0; k < recorded[e].size(); ++k)
                recorded[e][k] += lead_[e][static_cast<Eigen::Index>(k)];
    }
    /// Empty: nothing tells.
    const std::vector<Eigen::VectorXd>& lead() const { return lead_; }

    /// The samples of a variable in each fitted experiment; empty: it was not observed.
    const std::vector<std::vector<double>>& series(const std::string& variable) const {
        static const std::vector<std::vector<double>> none;
        const auto found = series_.find(variable);
        return found == series_.end() ? none : found->second;
    }

private:
    std::map<std::string, std::vector<std::vector<double>>> series_, recorded_;
    std::vector<std::vector<double>> times_;
    std::vector<Eigen::VectorXd> lead_;
};

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

Outcome<Observations> observe(const NullModel& null, const Variant& off, const SimulationOptions& simulation) {
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

/// All combinations of the shape values that go with a strength, which they may name.
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

Text reason(const Diagnostics& diagnostics) {
    return diagnostics.empty() ? phrase("unknown fault") : diagnostics.front().message;
}

/// The variant with the variable of its newest effect as it was recorded: a flow along that course is linear in its
/// strength, however strong.
Variant alongRecorded(Variant variant, const std::vector<std::vector<double>>& simulated,
                      const std::vector<Eigen::VectorXd>& lead) {
    const PlacedEffect& placed = variant.effects.back();
    variant.task.imposed = ImposedVariable{placed.instance + "." + placed.effect.along, recordedName};
    std::size_t next = 0;
    for (Recording& r : variant.task.recordings) {
        Eigen::VectorXd course = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(r.time.size()));
        if (r.role == Role::Fit) {
            course = Eigen::Map<const Eigen::VectorXd>(simulated[next].data(), lead[next].size()) + lead[next];
            ++next;
        }
        r.addInput(recordedName, course);
    }
    return variant;
}

/// Takes the traces of one wired candidate.
class Prober {
public:
    /// `course`: of the variable that a wave goes along, in each fitted experiment.
    Prober(const NullModel& null, const Variant& wired, const std::vector<std::vector<double>>& course,
           const SimulationOptions& simulation, const Progress& progress)
        : null_(null),
          course_(course),
          placed_(wired.effects.back()),
          wired_(wired),
          scores_(null.scores()),
          simulation_(simulation),
          progress_(progress) {}

    Outcome<Done> compile() {
        std::vector<FitParameter> free{named(placed_.effect.strength)};
        for (const std::string& l : placed_.effect.linear) free.push_back(named(l));
        std::vector<std::string> kept;
        for (const auto& [name, values] : placed_.effect.shape) kept.push_back(placed_.instance + "." + name);
        if (!placed_.effect.phase.empty()) kept.push_back(placed_.instance + "." + placed_.effect.phase);
        Outcome<PreparedTask> held = prepareHeld(wired_, free, null_.noise, kept);
        if (!held) return held.diagnostics();
        held_ = std::move(*held);
        // a linear model's recurrence does not serve what makes it another; slopes all go along the same course
        const StepsBeside& beside = null_.steps(simulation_, progress_);
        plans_ = null_.plansOf(*held_.system, simulation_, progress_);
        held_.problem.knownPlans = beside.glances;
        const bool takesSlopes = placed_.effect.secant.empty() || !placed_.effect.phase.empty();
        const bool hasOwnStates = addedStates() != 0;
        for (std::size_t e = 0; takesSlopes && hasOwnStates && e < plans_.size(); ++e)
            if (null_.fit.plans[e].method == GridMethod::Exact && plans_[e].method != GridMethod::Exact)
                plans_[e] = planFor(held_.problem, static_cast<int>(e), off(), simulation_, progress_, &plans_[e]);
        return Done{};
    }

    /// One trace; false when the simulation failed.
    bool take(const std::map<std::string, double>& shape, double secant, Probe& probe) {
        for (const auto& [name, value] : shape) set(placed_.instance + "." + name, value);
        probe.values = shape;
        probe.secant = secant;
        if (!placed_.effect.phase.empty()) return takeWave(shape, probe);
        const std::optional<Eigen::MatrixXd> columns = traces(secant);
        if (!columns) return false;
        probe.column = columns->col(0);
        probe.plain = plainScore(*columns);
        probe.whitened = whitenedScore(*columns);
        return true;
    }

    /// States beside those of the model.
    int addedStates() const {
        return held_.system->stateCount() - static_cast<int>(null_.steps(simulation_, progress_).states.size());
    }

    std::vector<std::string> imitators(const Eigen::VectorXd& column) const {
        const Eigen::VectorXd c = scores_.plain.coefficients(column);
        std::vector<std::pair<double, std::string>> parts;
        for (Eigen::Index j = 0; j < c.size(); ++j)
            parts.emplace_back(std::abs(c[j]) * null_.fit.optimum.jacobian.col(j).norm(),
                               null_.fit.estimates[static_cast<std::size_t>(j)].name);
        std::sort(parts.rbegin(), parts.rend());
        std::vector<std::string> names;
        for (const auto& [part, name] : parts)
            if (part > 0.1 * parts.front().first) names.push_back(name);
        return names;
    }

private:
    FitParameter named(const std::string& parameter) const {
        FitParameter p;
        p.name = placed_.instance + "." + parameter;
        return p;
    }

    void set(const std::string& parameter, double value) {
        const int index = held_.system->parameterIndex(parameter);
        if (index < 0) return;
        for (FitExperiment& e : held_.problem.experiments) e.parameters[static_cast<std::size_t>(index)] = value;
    }

    Eigen::VectorXd off() const {
        return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(held_.problem.parameters.size()));
    }

    ColumnScore plainScore(const Eigen::MatrixXd& columns) const {
        return scoreColumns(scores_.plain, null_.fit.optimum.residuals, columns, placed_.effect.oneSided);
    }
    ColumnScore whitenedScore(const Eigen::MatrixXd& columns) const {
        return scoreColumns(scores_.white, scores_.whiteResidual, null_.whitener(columns), placed_.effect.oneSided);
    }

    /// Traces of the strength and of the further linear parameters, in units of the noise.
    std::optional<Eigen::MatrixXd> traces(double secant) { return traces(secant, plans_); }

    std::optional<Eigen::MatrixXd> traces(double secant, const std::vector<GridPlan>& plans) {
        Eigen::VectorXd at = off();
        at[0] = secant;
        const bool isSlope = secant == 0;
        const bool needsTangents = isSlope || !placed_.effect.linear.empty();
        const SimulationOptions simulation = isSlope ? simulation_ : glance(simulation_);
        const Linearisation l = linearise(held_.problem, at, needsTangents, isSlope ? plans : std::vector<GridPlan>{},
                                          simulation, progress_);
        if (!l.ok || l.residuals.size() != null_.fit.optimum.residuals.size()) return std::nullopt;
        // what follows is judged with these steps: to choose them anew takes longer than to take them
        if (!isSlope) held_.problem.knownPlans = stepsOf(l);
        Eigen::MatrixXd columns = needsTangents ? l.jacobian : Eigen::MatrixXd(l.residuals.size(), 1);
        if (!isSlope) columns.col(0) = (l.residuals - null_.fit.optimum.residuals) / secant;
        return columns.allFinite() ? std::optional(std::move(columns)) : std::nullopt;
    }

    /// Steps short enough for a wave that the model itself, without the effect, need not follow.
    std::vector<GridPlan> plansFor(double waves) const {
        std::vector<GridPlan> plans = plans_;
        for (std::size_t e = 0; e < std::min(plans.size(), course_.size()); ++e) {
            const std::vector<double>& x = course_[e];
            std::vector<int> needed;
            for (std::size_t k = 0; k + 1 < x.size(); ++k) {
                const double steps = std::ceil(waves * std::abs(x[k + 1] - x[k]) / mostOfAWave);
                needed.push_back(static_cast<int>(std::clamp(steps, 1.0, 1.0 * mostStepsOfAWave)));
            }
            plans[e] = refined(plans[e], needed);
        }
        return plans;
    }

    /// A wave of any phase is the sum of two a quarter turn apart: strength and phase both come from them.
    bool takeWave(const std::map<std::string, double>& shape, Probe& probe) {
        const EffectClass& effect = placed_.effect;
        const auto waves = shape.find(effect.waves);
        const std::vector<GridPlan> plans = plansFor(waves == shape.end() ? 1 : waves->second);
        Eigen::MatrixXd both(null_.fit.optimum.residuals.size(), 2);
        for (const int quarter : {0, 1}) {
            set(placed_.instance + "." + effect.phase, quarter * quarterTurn);
            const std::optional<Eigen::MatrixXd> columns = traces(0, plans);
            if (!columns) return false;
            both.col(quarter) = columns->col(0);
        }
        probe.plain = plainScore(both);
        probe.whitened = whitenedScore(both);
        const Eigen::Vector2d parts = probe.plain.strengths;
        const double strength = parts.norm();
        probe.column = strength > 0 ? Eigen::VectorXd(both * parts / strength) : Eigen::VectorXd(both.col(0));
        probe.plain.visible = plainScore(probe.column).visible;
        probe.whitened.visible = whitenedScore(probe.column).visible;
        probe.plain.strengths = Eigen::VectorXd::Constant(1, strength);
        probe.values[effect.phase] = std::atan2(parts[1], parts[0]);
        probe.isAlongRecorded = wired_.task.imposed.has_value();
        return true;
    }

    const NullModel& null_;
    const std::vector<std::vector<double>>& course_;
    const PlacedEffect& placed_;
    const Variant& wired_;
    const ScoresBeside& scores_;
    std::vector<GridPlan> plans_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    PreparedTask held_;
};

/// Whether the recorded course of an effect's variable is another than the simulated one: to the shortest of its waves,
/// or, where it has none, to all that it passes.
bool isAhead(const Observations& observations, const Screened& screened) {
    const std::vector<Eigen::VectorXd>& lead = observations.lead();
    const EffectClass& effect = screened.candidate.effect;
    double most = 1, largest = 0;
    for (const Probe& p : screened.probes)
        if (const auto waves = p.values.find(effect.waves); waves != p.values.end())
            most = std::max(most, waves->second);
    for (const Eigen::VectorXd& each : lead) largest = std::max(largest, each.cwiseAbs().maxCoeff());
    const double turn = effect.phase.empty() ? observations.statistic("range", effect.along) : 4 * quarterTurn;
    return largest > 0 && most * largest > leastLead * turn;
}

/// The effect with the units of its parameters that depend on the signal it is at.
EffectClass inUnitsOf(const std::string& signal, EffectClass effect) {
    if (signal.empty()) return effect;
    for (const std::string& name : effect.inSignalUnit) effect.units[name] = signal;
    const std::string rate = signal.find('/') == std::string::npos ? signal + "/s" : "(" + signal + ")/s";
    for (const std::string& name : effect.inSignalRate) effect.units[name] = rate;
    return effect;
}

double scoreOf(const ColumnScore& s) { return s.wrongSign || s.visible < leastVisible ? 0 : s.explained; }

}  // namespace

double Probe::strength() const { return plain.wrongSign || plain.strengths.size() == 0 ? 0 : plain.strengths[0]; }

std::vector<double> Probe::linear() const {
    return {plain.strengths.data() + std::min<Eigen::Index>(1, plain.strengths.size()),
            plain.strengths.data() + plain.strengths.size()};
}

double Screened::score() const { return probes.empty() ? 0 : scoreOf(probes.front().plain); }

double Screened::whitenedScore() const {
    double best = 0;
    for (const Probe& p : probes) best = std::max(best, scoreOf(p.whitened));
    return best;
}

bool Screened::isAbsorbed() const {
    return !probes.empty() &&
           std::all_of(probes.begin(), probes.end(), [](const Probe& p) { return p.plain.visible < leastVisible; });
}

bool Screened::isWrongSign() const {
    return !probes.empty() &&
           std::all_of(probes.begin(), probes.end(), [](const Probe& p) { return p.plain.wrongSign; });
}

Outcome<ModelNodes> nodesOf(const Variant& variant, Diagram& diagram) {
    Outcome<FlatModel> flat = flatten(variant.task.library, variant.task.className);
    if (!flat) return flat.diagnostics();
    StructureOptions options;
    for (const ParameterValue& v : variant.values)
        if (!isClock(v.name)) options.keep.push_back(v.name);
    flat = withStarts(std::move(*flat), options.keep);
    if (!flat) return flat.diagnostics();
    Outcome<Structure> structure = analyse(std::make_shared<FlatModel>(std::move(*flat)), options);
    if (!structure) return structure.diagnostics();
    Outcome<Diagram> read = readDiagram(variant.task.library, variant.task.className);
    if (!read) return read.diagnostics();
    diagram = std::move(*read);
    return ModelNodes(variant.task.library, diagram, *structure);
}

Outcome<std::vector<Candidate>> candidatesFor(const Variant& variant, const std::vector<EffectClass>& catalogue) {
    Diagram diagram;
    Outcome<ModelNodes> nodes = nodesOf(variant, diagram);
    if (!nodes) return nodes.diagnostics();

    const auto first = std::find_if(variant.task.recordings.begin(), variant.task.recordings.end(),
                                    [](const Recording& r) { return r.role == Role::Fit && !r.spares.empty(); });
    const auto sparesFor = [&](const EffectClass& effect) {
        std::vector<std::string> names;
        if (effect.channel.empty()) return names;
        if (first != variant.task.recordings.end())
            for (const SpareChannel& s : first->spares)
                if (effect.quantity.empty() || areConvertible(s.unit, effect.quantity)) names.push_back(s.name);
        if (effect.orInput)
            for (std::string& input : nodes->inputsIn(effect.quantity)) names.push_back(std::move(input));
        return names;
    };
    std::vector<Candidate> candidates;
    for (const EffectClass& e : catalogue)
        for (const EffectPlace& p : nodes->placesFor(e, sparesFor(e))) {
            const bool isThere =
                std::any_of(variant.effects.begin(), variant.effects.end(), [&](const PlacedEffect& x) {
                    // one kind has several classes where something of it may be known or not
                    const bool isSame =
                        x.effect.className == e.className || (x.effect.kind == e.kind && e.proposal.empty());
                    return isSame && (x.place == p || std::find(x.twins.begin(), x.twins.end(), p) != x.twins.end());
                });
            // an input that an effect brought in is a recorded channel, no actuator
            const bool isOfEffect =
                std::any_of(variant.effects.begin(), variant.effects.end(),
                            [&](const PlacedEffect& x) { return !x.newInput.empty() && p.connector == x.newInput; });
            // a proposal is taken out again at the end: nothing may hang on its connectors
            const bool isAtProposal =
                std::any_of(variant.effects.begin(), variant.effects.end(), [&](const PlacedEffect& x) {
                    return !x.effect.proposal.empty() && p.connector.starts_with(x.instance + ".");
                });
            if (!isThere && !isOfEffect && !isAtProposal) candidates.push_back({inUnitsOf(nodes->unitAt(p), e), p});
        }
    return candidates;
}

SimulationOptions limited(const NullModel& null, SimulationOptions simulation) {
    long longest = 0;
    for (const Recording& r : null.variant.task.recordings)
        if (r.role == Role::Fit) longest = std::max(longest, static_cast<long>(r.time.size()));
    simulation.evaluationLimit = longest * evaluationsPerSample;
    return simulation;
}

namespace {

/// Whether a place is the end of an elastic component that has no inertia there: another spring in series with it moves
/// by itself, though but one state more comes of it.
bool endsInASpring(const Variant& variant, const EffectPlace& place) {
    const Outcome<FlatModel> flat = flatten(variant.task.library, variant.task.className);
    if (!flat) return false;
    const std::string component = place.connector.substr(0, place.connector.rfind('.') + 1);
    bool isElastic = false, lacksInertia = false;
    for (const FlatVariable& v : flat->variables) {
        if (!v.name.starts_with(component)) continue;
        const std::optional<double> value = flat->parameterValue(flat->find(v.name));
        isElastic = isElastic || (v.unit == "N.m/rad" && value > 0.0);
        lacksInertia = lacksInertia || (v.unit == "kg.m2" && value == 0.0);
    }
    return isElastic && lacksInertia;
}

}  // namespace

Screened screen(const NullModel& null, const Candidate& candidate, const SimulationOptions& options,
                const Progress& progress) {
    const SimulationOptions simulation = limited(null, options);
    Screened result;
    result.candidate = candidate;
    const EffectClass& effect = candidate.effect;
    const auto fail = [&](const Diagnostics& faults) {
        result.failure = reason(faults);
        return result;
    };
    Outcome<Variant> off = withEffect(null.variant, effect, candidate.place, {});
    if (!off) return fail(off.diagnostics());
    Outcome<Observations> observations = observe(null, *off, simulation);
    if (!observations) return fail(observations.diagnostics());
    const ShapeContext context = contextOf(null, *observations);
    for (const auto& [name, text] : effect.fixed) {
        Outcome<double> value = shapeValue(text, context);
        if (!value) return fail(value.diagnostics());
        result.fixed[name] = *value;
    }
    Outcome<Variant> wired =
        result.fixed.empty() ? std::move(off) : withEffect(null.variant, effect, candidate.place, result.fixed);
    if (!wired) return fail(wired.diagnostics());
    result.wired = std::move(*wired);
    std::vector<double> secants;
    for (const std::string& text : effect.secant) {
        Outcome<double> value = shapeValue(text, context);
        if (!value) return fail(value.diagnostics());
        if (*value != 0) secants.push_back(*value);
    }
    if (secants.empty()) secants.push_back(0);

    Prober prober(null, result.wired, observations->series(effect.along), simulation, progress);
    if (Outcome<Done> compiled = prober.compile(); !compiled) return fail(compiled.diagnostics());
    if (effect.states > 0) {
        const int added = prober.addedStates();
        if (added < effect.states && !(added > 0 && endsInASpring(null.variant, candidate.place)))
            return fail({error(phrase("nothing there has a motion of its own"))});
    }
    const auto probeAll = [&](Prober& with) -> Outcome<Done> {
        for (const double secant : secants) {
            Outcome<std::vector<std::map<std::string, double>>> shapes = shapesOf(effect, context, secant);
            if (!shapes) return shapes.diagnostics();
            for (const std::map<std::string, double>& shape : *shapes) {
                if (progress.stopRequested()) return error(phrase("cancelled"));
                Probe probe;
                if (with.take(shape, secant, probe)) result.probes.push_back(std::move(probe));
            }
        }
        return Done{};
    };
    if (Outcome<Done> probed = probeAll(prober); !probed) return fail(probed.diagnostics());
    if (isAhead(*observations, result)) {
        auto recorded = std::make_shared<const Variant>(
            alongRecorded(result.wired, observations->series(effect.along), observations->lead()));
        Prober along(null, *recorded, observations->series(effect.along), simulation, progress);
        result.recorded = std::move(recorded);
        if (along.compile())
            if (Outcome<Done> probed = probeAll(along); !probed) return fail(probed.diagnostics());
    }
    if (result.probes.empty()) return fail({error(phrase("no simulation with this effect succeeded"))});
    std::stable_sort(result.probes.begin(), result.probes.end(),
                     [](const Probe& a, const Probe& b) { return scoreOf(a.plain) > scoreOf(b.plain); });
    // a round keeps the probes of all candidates: what nobody asks for again takes more room than all else
    for (std::size_t i = 0; i < result.probes.size(); ++i) {
        result.probes[i].whitened.directions.resize(0, 0);
        if (i > 0) result.probes[i].column.resize(0);
    }
    if (result.isAbsorbed()) result.absorbedBy = prober.imitators(result.probes.front().column);
    return result;
}

}  // namespace analogon
