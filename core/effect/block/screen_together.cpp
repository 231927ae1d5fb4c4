#include "core/effect/block/screen_together.hpp"

#include <algorithm>

#include "core/effect/block/observation.hpp"
#include "core/effect/block/probe_score.hpp"
#include "core/effect/block/prober.hpp"
#include "core/fit/held_value.hpp"

namespace analogon {
namespace {

/// More in one model leave less for other threads, and gain little.
constexpr std::size_t mostTogether = 32;

/// What is inserted into neighbouring connections has to be solved for at once. So few, from all over the model, hardly
/// meet.
constexpr std::size_t mostInsertedTogether = 8;

/// Fewer are not worth a model of their own where one of them is in the way of the others.
constexpr std::size_t fewestTogether = 3;

/// Whether a candidate stands in a component or at its connectors, switched off by its strength alone.
bool isOfTheModel(const Candidate& candidate) {
    const EffectClass& effect = candidate.effect;
    const bool isDriven = !candidate.place.spare.empty() && !candidate.place.spare.starts_with(inputPrefix);
    const bool isAlone =
        effect.placement.way == Way::Specialise && !(candidate.place.node.empty() && candidate.place.spare.empty());
    return !isDriven && !isAlone && effect.placement.signalSide.empty() && effect.wave.along.empty() &&
           effect.wave.phase.empty() && effect.trial.states <= 0 &&
           (effect.trial.secant.empty() || effect.parameters.linear.empty());
}

/// Candidates of one class on the way through their traces, in one model.
class JointScreening {
public:
    JointScreening(const NullModel& null, const std::vector<Candidate>& candidates, const SimulationOptions& simulation,
                   const Progress& progress)
        : null_(null), simulation_(simulation), progress_(progress), members_(candidates.size()) {
        for (std::size_t i = 0; i < candidates.size(); ++i) members_[i].screened.candidate = candidates[i];
    }

    /// False: this model does not serve.
    bool run() {
        if (!prepare() || !observe()) return false;
        std::size_t most = 0;
        for (const Member& m : members_) most = std::max(most, m.slopes.size());
        for (std::size_t k = 0; k < most; ++k)
            if (progress_.stopRequested() || !takeSlopes(k)) return false;
        for (Member& m : members_) {
            if (progress_.stopRequested()) return false;
            if (!m.secants.empty()) takeSecants(m);
            if (!m.screened.failure.empty()) continue;
            if (m.screened.probes.empty()) return false;
            keepBest(null_, m.screened);
        }
        return true;
    }

    /// Where it does not: the members of models that may, by their indices. None: all by themselves.
    std::vector<std::vector<std::size_t>> parts() const {
        std::vector<std::vector<std::size_t>> parts;
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < members_.size(); ++i)
            if (members_[i].hasOwnStates)
                parts.push_back({i});
            else
                others.push_back(i);
        if (!parts.empty()) {
            if (!others.empty()) parts.push_back(std::move(others));
        } else if (hasOtherStates_ && others.size() > fewestTogether) {
            // a connection that an effect opens gives a state to what was joined by it
            const auto half = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
            parts = {{others.begin(), half}, {half, others.end()}};
        }
        return parts;
    }

    std::vector<Screened> result() && {
        std::vector<Screened> all;
        for (Member& m : members_) all.push_back(std::move(m.screened));
        return all;
    }

private:
    struct Member {
        Screened screened;
        std::string instance;
        Eigen::Index column{};  // of its strength among the parameters; those that are linear beside it follow
        std::vector<std::map<std::string, double>> slopes;  // shapes to be tried at strength 0
        struct Secant {
            double strength{};
            std::map<std::string, double> shape;
        };
        std::vector<Secant> secants;  // in place of slopes
        bool hasOwnStates{};

        const EffectClass& effect() const { return screened.candidate.effect; }
    };

    bool prepare() {
        std::vector<EffectClass> effects;
        std::vector<EffectPlace> places;
        for (const Member& m : members_) {
            effects.push_back(m.effect());
            places.push_back(m.screened.candidate.place);
        }
        Outcome<Variant> off = withEffectsBeside(null_.variant, effects, places);
        if (!off) return false;
        off_ = std::move(*off);
        TracedParameters parameters;
        for (std::size_t i = 0; i < members_.size(); ++i) {
            const PlacedEffect& placed = off_.effects[off_.effects.size() - members_.size() + i];
            Member& m = members_[i];
            m.instance = placed.instance;
            m.column = static_cast<Eigen::Index>(parameters.free.size());
            parameters.add(placed);
            for (const auto& [name, value] : m.effect().parameters.fixed)
                parameters.kept.push_back(m.instance + "." + name);
        }
        Outcome<PreparedTask> held = prepareHeld(off_, parameters.free, null_.noise, parameters.kept);
        if (!held) return false;
        held_ = std::move(*held);
        plans_ = null_.plansOf(*held_.system, simulation_, progress_);
        held_.problem.knownPlans = null_.steps(simulation_, progress_).coarse;
        return hasStatesOfTheModel();
    }

    bool hasStatesOfTheModel() {
        const std::size_t count = null_.steps(simulation_, progress_).states.size();
        const std::vector<SignalInfo>& states = held_.system->states();
        hasOtherStates_ = states.size() != count;
        if (!hasOtherStates_) return true;
        for (Member& m : members_)
            m.hasOwnStates = std::any_of(states.begin(), states.end(),
                                         [&](const SignalInfo& s) { return s.name.starts_with(m.instance + "."); });
        return false;
    }

    /// What the recording tells of each: the values that are kept, and the shapes to be tried.
    bool observe() {
        const Outcome<std::vector<Observations>> seen = observeNewest(null_, off_, members_.size(), held_, simulation_);
        if (!seen) return false;
        for (std::size_t i = 0; i < members_.size(); ++i)
            if (const Outcome<Done> shaped = shape(members_[i], contextOf(null_, (*seen)[i])); !shaped)
                members_[i].screened.failure = shaped.diagnostics().front().message;
        return true;
    }

    Outcome<Done> shape(Member& member, const ShapeContext& context) {
        Outcome<std::map<std::string, double>> fixed = fixedOf(member.effect(), context);
        if (!fixed) return fixed.diagnostics();
        member.screened.fixed = std::move(*fixed);
        setValues(member, member.screened.fixed);
        const Outcome<std::vector<double>> strengths = strengthsOf(member.effect(), context);
        if (!strengths) return strengths.diagnostics();
        for (const double strength : *strengths) {
            Outcome<std::vector<std::map<std::string, double>>> shapes = shapesOf(member.effect(), context, strength);
            if (!shapes) return shapes.diagnostics();
            for (std::map<std::string, double>& each : *shapes)
                if (strength == 0)
                    member.slopes.push_back(std::move(each));
                else
                    member.secants.push_back({strength, std::move(each)});
        }
        return Done{};
    }

    void setValues(const Member& member, const std::map<std::string, double>& values) {
        for (const auto& [name, value] : values) setParameter(held_.problem, member.instance + "." + name, value);
    }

    /// All strengths, and what is linear beside them, at zero.
    Eigen::VectorXd off() const {
        return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(held_.problem.parameters.size()));
    }

    bool isWhole(const Linearisation& l) const {
        return l.ok && l.residuals.size() == null_.fit.optimum.residuals.size();
    }

    void keep(Member& member, Probe probe, const Eigen::MatrixXd& columns) const {
        if (!columns.allFinite()) return;
        probe.column = columns.col(0);
        scoreProbe(null_, member.effect().parameters.oneSided, columns, probe);
        member.screened.probes.push_back(std::move(probe));
    }

    /// The traces of the k-th shape of each.
    bool takeSlopes(std::size_t k) {
        for (const Member& m : members_)
            if (k < m.slopes.size()) setValues(m, m.slopes[k]);
        const Linearisation l = linearise(held_.problem, off(), true, plans_, simulation_, progress_);
        if (!isWhole(l)) return false;
        for (Member& m : members_) {
            if (k >= m.slopes.size()) continue;
            Probe probe;
            probe.values = m.slopes[k];
            keep(m, std::move(probe),
                 l.jacobian.middleCols(m.column, static_cast<Eigen::Index>(1 + m.effect().parameters.linear.size())));
        }
        return true;
    }

    /// Its traces at strengths other than 0, the others off.
    void takeSecants(Member& member) {
        held_.problem.knownPlans = null_.steps(simulation_, progress_).coarse;
        for (const auto& [strength, shape] : member.secants) {
            if (progress_.stopRequested()) return;
            setValues(member, shape);
            Eigen::VectorXd at = off();
            at[member.column] = strength;
            const Linearisation l = linearise(held_.problem, at, false, {}, coarse(simulation_), progress_);
            if (!isWhole(l)) continue;
            held_.problem.knownPlans = stepsOf(l);  // as by itself (Prober): the next is judged with these steps
            Probe probe;
            probe.values = shape;
            probe.secant = strength;
            keep(member, std::move(probe), secantTrace(null_, l.residuals, strength));
        }
    }

    const NullModel& null_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    std::vector<Member> members_;
    Variant off_;  // all of them in the model
    PreparedTask held_;
    std::vector<GridPlan> plans_;
    bool hasOtherStates_{};  // than the model without them
};

}  // namespace

std::vector<std::vector<std::size_t>> screenedTogether(const std::vector<Candidate>& candidates) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t begin = 0, end = 0; begin < candidates.size(); begin = end) {
        end = begin + 1;
        const auto isLikeFirst = [&](const Candidate& c) {
            return isOfTheModel(c) && c.effect.className == candidates[begin].effect.className;
        };
        while (isOfTheModel(candidates[begin]) && end < candidates.size() && isLikeFirst(candidates[end])) ++end;
        const std::size_t most =
            candidates[begin].effect.placement.way == Way::Insert ? mostInsertedTogether : mostTogether;
        const std::size_t count = (end - begin + most - 1) / most, first = groups.size();
        groups.resize(first + count);
        for (std::size_t i = begin; i < end; ++i) groups[first + (i - begin) % count].push_back(i);
    }
    return groups;
}

std::vector<Screened> screenTogether(const NullModel& null, const std::vector<Candidate>& candidates,
                                     const SimulationOptions& options, const Progress& progress) {
    std::vector<Screened> all(candidates.size());
    std::vector<std::vector<std::size_t>> parts;
    if (candidates.size() > 1 && !progress.stopRequested()) {
        const SimulationOptions simulation = limited(null, options);
        JointScreening joint(null, candidates, simulation, progress);
        if (joint.run()) return std::move(joint).result();
        parts = joint.parts();
    }
    if (parts.empty())
        for (std::size_t i = 0; i < candidates.size(); ++i) parts.push_back({i});
    for (const std::vector<std::size_t>& part : parts) {
        std::vector<Candidate> some;
        for (const std::size_t i : part) some.push_back(candidates[i]);
        std::vector<Screened> own = some.size() > 1 ? screenTogether(null, some, options, progress)
                                                    : std::vector{screen(null, some.front(), options, progress)};
        for (std::size_t i = 0; i < part.size(); ++i) all[part[i]] = std::move(own[i]);
    }
    return all;
}

}  // namespace analogon
