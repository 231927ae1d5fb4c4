#include "core/effect/block/prober.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/block/probe_score.hpp"
#include "core/fit/held_value.hpp"

namespace analogon {
namespace {

constexpr double mostOfAWave = 1;     // [rad] that may pass in a step
constexpr int mostStepsOfAWave = 16;  // in a sample interval: what is faster averages out

}  // namespace

void TracedParameters::add(const PlacedEffect& placed) {
    const EffectClass& effect = placed.effect;
    const auto own = [&](const std::string& name) { return placed.instance + "." + name; };
    free.emplace_back().name = own(effect.parameters.strength);
    for (const std::string& name : effect.parameters.linear) free.emplace_back().name = own(name);
    for (const auto& [name, values] : effect.parameters.shape) kept.push_back(own(name));
    if (!effect.wave.phase.empty()) kept.push_back(own(effect.wave.phase));
}

Outcome<Done> Prober::compile() {
    TracedParameters parameters;
    parameters.add(placed_);
    Outcome<PreparedTask> held = prepareHeld(wired_, parameters.free, null_.noise, parameters.kept);
    if (!held) return held.diagnostics();
    held_ = std::move(*held);
    // a linear model's recurrence does not serve what makes it another; slopes all go along the same course
    const StepsBeside& beside = null_.steps(simulation_, progress_);
    plans_ = null_.plansOf(*held_.system, simulation_, progress_);
    held_.problem.knownPlans = beside.coarse;
    const bool takesSlopes = placed_.effect.trial.secant.empty() || !placed_.effect.wave.phase.empty();
    const bool hasOwnStates = addedStates() != 0;
    for (std::size_t e = 0; takesSlopes && hasOwnStates && e < plans_.size(); ++e)
        if (null_.fit.plans[e].method == GridMethod::Exact && plans_[e].method != GridMethod::Exact)
            plans_[e] = planFor(held_.problem, static_cast<int>(e), off(), simulation_, progress_, &plans_[e]);
    return Done{};
}

bool Prober::take(const std::map<std::string, double>& shape, double secant, Probe& probe) {
    for (const auto& [name, value] : shape) setParameter(held_.problem, placed_.instance + "." + name, value);
    probe.values = shape;
    probe.secant = secant;
    if (!placed_.effect.wave.phase.empty()) return takeWave(shape, probe);
    const std::optional<Eigen::MatrixXd> columns = traces(secant);
    if (!columns) return false;
    probe.column = columns->col(0);
    scoreProbe(null_, placed_.effect.parameters.oneSided, *columns, probe);
    return true;
}

int Prober::addedStates() const {
    return held_.system->stateCount() - static_cast<int>(null_.steps(simulation_, progress_).states.size());
}

Eigen::VectorXd Prober::off() const {
    return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(held_.problem.parameters.size()));
}

std::optional<Eigen::MatrixXd> Prober::traces(double secant, const std::vector<GridPlan>& plans) {
    Eigen::VectorXd at = off();
    at[0] = secant;
    const bool isSlope = secant == 0;
    const bool needsTangents = isSlope || !placed_.effect.parameters.linear.empty();
    const SimulationOptions simulation = isSlope ? simulation_ : coarse(simulation_);
    const Linearisation l =
        linearise(held_.problem, at, needsTangents, isSlope ? plans : std::vector<GridPlan>{}, simulation, progress_);
    if (!l.ok || l.residuals.size() != null_.fit.optimum.residuals.size()) return std::nullopt;
    // what follows is judged with these steps: to choose them anew takes longer than to take them
    if (!isSlope) held_.problem.knownPlans = stepsOf(l);
    Eigen::MatrixXd columns = needsTangents ? l.jacobian : Eigen::MatrixXd(l.residuals.size(), 1);
    if (!isSlope) columns.col(0) = secantTrace(null_, l.residuals, secant);
    return columns.allFinite() ? std::optional(std::move(columns)) : std::nullopt;
}

std::vector<GridPlan> Prober::plansFor(double waves) const {
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

bool Prober::takeWave(const std::map<std::string, double>& shape, Probe& probe) {
    const EffectClass& effect = placed_.effect;
    const auto waves = shape.find(effect.wave.waves);
    const std::vector<GridPlan> plans = plansFor(waves == shape.end() ? 1 : waves->second);
    Eigen::MatrixXd both(null_.fit.optimum.residuals.size(), 2);
    for (const int quarter : {0, 1}) {
        setParameter(held_.problem, placed_.instance + "." + effect.wave.phase, quarter * quarterTurn);
        const std::optional<Eigen::MatrixXd> columns = traces(0, plans);
        if (!columns) return false;
        both.col(quarter) = columns->col(0);
    }
    scoreProbe(null_, effect.parameters.oneSided, both, probe);
    const Eigen::Vector2d parts = probe.plain.strengths;
    const double strength = parts.norm();
    probe.column = strength > 0 ? Eigen::VectorXd(both * parts / strength) : Eigen::VectorXd(both.col(0));
    Probe along;
    scoreProbe(null_, effect.parameters.oneSided, probe.column, along);
    probe.plain.visible = along.plain.visible;
    probe.whitened.visible = along.whitened.visible;
    probe.plain.strengths = Eigen::VectorXd::Constant(1, strength);
    probe.values[effect.wave.phase] = std::atan2(parts[1], parts[0]);
    probe.isAlongRecorded = wired_.task.imposed.has_value();
    return true;
}

}  // namespace analogon
