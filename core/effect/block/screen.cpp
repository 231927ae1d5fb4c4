#include "core/effect/block/screen.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/block/observation.hpp"
#include "core/effect/block/probe_score.hpp"
#include "core/effect/block/prober.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::screen;

namespace {

constexpr const char* recordedName = "recordedCourse";

Text reason(const Diagnostics& diagnostics) {
    return diagnostics.empty() ? phrase("unknown fault") : diagnostics.front().message;
}

/// The variant with the variable of its newest effect as it was recorded: a flow along that course is linear in its
/// strength, however strong.
Variant alongRecorded(Variant variant, const std::vector<std::vector<double>>& simulated,
                      const std::vector<Eigen::VectorXd>& lead) {
    const PlacedEffect& placed = variant.effects.back();
    variant.task.imposed = ImposedVariable{placed.instance + "." + placed.effect.wave.along, recordedName};
    std::size_t next = 0;
    for (Recording& r : variant.task.recordings.edit()) {
        Eigen::VectorXd course = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(r.time.size()));
        if (r.role == Role::Fit) {
            course = Eigen::Map<const Eigen::VectorXd>(simulated[next].data(), lead[next].size()) + lead[next];
            ++next;
        }
        r.addInput(recordedName, course);
    }
    return variant;
}

/// Whether the recorded course of an effect's variable is another than the simulated one: to the shortest of its waves,
/// or, where it has none, to all that it passes.
bool isAhead(const Observations& observations, const Screened& screened) {
    const std::vector<Eigen::VectorXd>& lead = observations.lead();
    const EffectClass& effect = screened.candidate.effect;
    double most = 1, largest = 0;
    for (const Probe& p : screened.probes)
        if (const auto waves = p.values.find(effect.wave.waves); waves != p.values.end())
            most = std::max(most, waves->second);
    for (const Eigen::VectorXd& each : lead) largest = std::max(largest, each.cwiseAbs().maxCoeff());
    const double turn =
        effect.wave.phase.empty() ? observations.statistic("range", effect.wave.along) : 4 * quarterTurn;
    return isAnotherCourse(largest, most, turn);
}

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

bool isAnotherCourse(double lead, double waves, double turn) { return lead > 0 && waves * lead > leastLead * turn; }

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

double LeastPromise::of(const Screened& screened) const {
    return std::max(share * screened.score(), screened.whitenedScore());
}

bool Screened::isAbsorbed() const {
    return !probes.empty() &&
           std::all_of(probes.begin(), probes.end(), [](const Probe& p) { return p.plain.visible < leastVisible; });
}

bool Screened::isWrongSign() const {
    return !probes.empty() &&
           std::all_of(probes.begin(), probes.end(), [](const Probe& p) { return p.plain.wrongSign; });
}

SimulationOptions limited(const NullModel& null, SimulationOptions simulation) {
    long longest = 0;
    for (const Recording& r : null.variant.task.recordings)
        if (r.role == Role::Fit) longest = std::max(longest, static_cast<long>(r.time.size()));
    simulation.evaluationLimit = longest * evaluationsPerSample;
    return simulation;
}

Outcome<Variant> wiredIn(const NullModel& null, const Screened& screened) {
    Outcome<Variant> wired =
        withEffect(null.variant, screened.candidate.effect, screened.candidate.place, screened.fixed);
    if (wired && screened.begin) wired->values = *screened.begin;
    return wired;
}

namespace {

/// One candidate on the way through its traces.
class Screening {
public:
    Screening(const NullModel& null, const Candidate& candidate, const SimulationOptions& simulation,
              const Progress& progress)
        : null_(null), effect_(candidate.effect), simulation_(simulation), progress_(progress) {
        result_.candidate = candidate;
    }

    Outcome<Done> run() {
        if (const Outcome<Done> done = wire(); !done) return done.diagnostics();
        Prober prober(null_, wired_, observations_.series(effect_.wave.along), simulation_, progress_);
        if (const Outcome<Done> compiled = prober.compile(); !compiled) return compiled.diagnostics();
        if (lacksMotion(prober)) return error(phrase("nothing there has a motion of its own"));
        if (const Outcome<Done> probed = probeAll(prober); !probed) return probed.diagnostics();
        if (isAhead(observations_, result_))
            if (const Outcome<Done> probed = probeAlongRecorded(); !probed) return probed.diagnostics();
        if (result_.probes.empty()) return error(phrase("no simulation with this effect succeeded"));
        keepBest(null_, result_);
        return Done{};
    }
    /// As far as it came.
    Screened result() && { return std::move(result_); }

private:
    /// The effect in the model, with the values that the recording gives it.
    Outcome<Done> wire() {
        Outcome<Variant> off = withEffect(null_.variant, effect_, result_.candidate.place, {});
        if (!off) return off.diagnostics();
        Outcome<Observations> observed = observeFor(null_, *off, simulation_);
        if (!observed) return observed.diagnostics();
        observations_ = std::move(*observed);
        context_ = contextOf(null_, observations_);
        Outcome<std::map<std::string, double>> fixed = fixedOf(effect_, context_);
        if (!fixed) return fixed.diagnostics();
        result_.fixed = std::move(*fixed);
        Outcome<Variant> wired = result_.fixed.empty() ? std::move(off) : wiredIn(null_, result_);
        if (!wired) return wired.diagnostics();
        wired_ = std::move(*wired);
        Outcome<std::vector<double>> strengths = strengthsOf(effect_, context_);
        if (!strengths) return strengths.diagnostics();
        secants_ = std::move(*strengths);
        return Done{};
    }

    bool lacksMotion(const Prober& prober) const {
        if (effect_.trial.states <= 0) return false;
        const int added = prober.addedStates();
        return added < effect_.trial.states && !(added > 0 && endsInASpring(null_.variant, result_.candidate.place));
    }

    Outcome<Done> probeAll(Prober& prober) {
        for (const double secant : secants_) {
            const Outcome<std::vector<std::map<std::string, double>>> shapes = shapesOf(effect_, context_, secant);
            if (!shapes) return shapes.diagnostics();
            for (const std::map<std::string, double>& shape : *shapes) {
                if (progress_.stopRequested()) return error(phrase("cancelled"));
                Probe probe;
                if (prober.take(shape, secant, probe)) result_.probes.push_back(std::move(probe));
            }
        }
        return Done{};
    }

    Outcome<Done> probeAlongRecorded() {
        const std::vector<std::vector<double>>& course = observations_.series(effect_.wave.along);
        auto recorded = std::make_shared<const Variant>(alongRecorded(wired_, course, observations_.lead()));
        Prober along(null_, *recorded, course, simulation_, progress_);
        result_.recorded = std::move(recorded);
        return along.compile() ? probeAll(along) : Outcome<Done>(Done{});
    }

    const NullModel& null_;
    const EffectClass& effect_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    Variant wired_;  // the effect in the model, fixed values set, parameters not yet freed
    Observations observations_;
    ShapeContext context_;
    std::vector<double> secants_;
    Screened result_;
};

}  // namespace

Screened screen(const NullModel& null, const Candidate& candidate, const SimulationOptions& options,
                const Progress& progress) {
    const SimulationOptions simulation = limited(null, options);
    Screening screening(null, candidate, simulation, progress);
    const Outcome<Done> done = screening.run();
    Screened result = std::move(screening).result();
    if (!done) result.failure = reason(done.diagnostics());
    return result;
}

}  // namespace analogon
