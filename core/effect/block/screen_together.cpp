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

bool isSlopeAtNodes(const Candidate& candidate) {
    const EffectClass& effect = candidate.effect;
    const bool isJoined = effect.way == Way::Attach || effect.way == Way::Bridge;
    const bool isDriven = !candidate.place.spare.empty() && !candidate.place.spare.starts_with(inputPrefix);
    return isJoined && !isDriven && effect.signalSide.empty() && effect.secant.empty() && effect.along.empty() &&
           effect.phase.empty() && effect.states <= 0;
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
        for (const Member& m : members_) most = std::max(most, m.shapes.size());
        for (std::size_t k = 0; k < most; ++k)
            if (progress_.stopRequested() || !take(k)) return false;
        for (Member& m : members_) {
            if (!m.screened.failure.empty()) continue;
            if (m.screened.probes.empty()) return false;
            keepBest(null_, m.screened);
        }
        return true;
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
        std::vector<std::map<std::string, double>> shapes;

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
            for (const auto& [name, value] : m.effect().fixed) parameters.kept.push_back(m.instance + "." + name);
        }
        Outcome<PreparedTask> held = prepareHeld(off_, parameters.free, null_.noise, parameters.kept);
        if (!held) return false;
        held_ = std::move(*held);
        plans_ = null_.plansOf(*held_.system, simulation_, progress_);
        return held_.system->stateCount() == static_cast<int>(null_.steps(simulation_, progress_).states.size());
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
        for (const auto& [name, value] : member.screened.fixed)
            setParameter(held_.problem, member.instance + "." + name, value);
        Outcome<std::vector<std::map<std::string, double>>> shapes = shapesOf(member.effect(), context, 0);
        if (!shapes) return shapes.diagnostics();
        member.shapes = std::move(*shapes);
        return Done{};
    }

    /// The traces of the k-th shape of each.
    bool take(std::size_t k) {
        for (const Member& m : members_)
            if (k < m.shapes.size())
                for (const auto& [name, value] : m.shapes[k])
                    setParameter(held_.problem, m.instance + "." + name, value);
        const Eigen::VectorXd off = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(held_.problem.parameters.size()));
        const Linearisation l = linearise(held_.problem, off, true, plans_, simulation_, progress_);
        if (!l.ok || l.residuals.size() != null_.fit.optimum.residuals.size()) return false;
        for (Member& m : members_) {
            if (k >= m.shapes.size()) continue;
            const auto count = static_cast<Eigen::Index>(1 + m.effect().linear.size());
            const Eigen::MatrixXd columns = l.jacobian.middleCols(m.column, count);
            if (!columns.allFinite()) continue;
            Probe probe;
            probe.values = m.shapes[k];
            probe.column = Eigen::MatrixXd(columns.col(0));
            scoreProbe(null_, m.effect().oneSided, columns, probe);
            m.screened.probes.push_back(std::move(probe));
        }
        return true;
    }

    const NullModel& null_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    std::vector<Member> members_;
    Variant off_;  // all of them in the model
    PreparedTask held_;
    std::vector<GridPlan> plans_;
};

}  // namespace

std::vector<std::vector<std::size_t>> screenedTogether(const std::vector<Candidate>& candidates) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool isLikeLast = !groups.empty() && groups.back().size() < mostTogether &&
                                isSlopeAtNodes(candidates[i]) && isSlopeAtNodes(candidates[groups.back().back()]) &&
                                candidates[i].effect.className == candidates[groups.back().back()].effect.className;
        if (isLikeLast)
            groups.back().push_back(i);
        else
            groups.push_back({i});
    }
    return groups;
}

std::vector<Screened> screenTogether(const NullModel& null, const std::vector<Candidate>& candidates,
                                     const SimulationOptions& options, const Progress& progress) {
    if (candidates.size() > 1) {
        const SimulationOptions simulation = limited(null, options);
        JointScreening joint(null, candidates, simulation, progress);
        if (joint.run()) return std::move(joint).result();
    }
    std::vector<Screened> all;
    for (const Candidate& c : candidates) all.push_back(screen(null, c, options, progress));
    return all;
}

}  // namespace analogon
