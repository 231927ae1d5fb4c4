#include "core/effect/reading/likeliest_edges.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"
#include "core/effect/model/score.hpp"

namespace analogon {
namespace {

constexpr double firstParts[] = {0.001, 0.01, 0.03, 0.06, 0.12, 0.25, 0.5, 0.75, 0.88, 0.94, 0.97, 0.99, 0.999};
constexpr int bitsOfAPart = 8;
constexpr double evenPrecision = 12;  // of a number that lies anywhere between 0 and 1

/// The residual of a model as its inputs jump at these moments, its parameters held.
class EdgeModel {
public:
    EdgeModel(const NullModel& null, const SimulationOptions& simulation, const Progress& progress)
        : null_(null),
          simulation_(simulation),
          progress_(progress),
          prepared_(prepareHeld(null.variant, {}, null.noise)) {}

    bool isReady() const { return prepared_.hasValue(); }

    /// Steps that do wherever in their intervals the inputs change: half an interval may become a whole one.
    void plan(std::vector<InputEdge> edges) {
        for (InputEdge& e : edges) e.part = 0.5;
        const FitProblem problem = with(edges);
        for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
            GridPlan plan = planFor(problem, static_cast<int>(e), {}, simulation_, progress_);
            plan.terms.reset();
            std::vector<int> needed;
            const std::size_t samples = problem.experiments[e].inputs.time.size();
            for (std::size_t k = 0; k + 1 < samples; ++k) needed.push_back(2 * plan.substepsIn(static_cast<int>(k)));
            plans_.push_back(plan.method == GridMethod::Exact ? plan : refined(plan, needed));
        }
    }

    /// Empty where it cannot be simulated. By any thread.
    Eigen::VectorXd residuals(const std::vector<InputEdge>& edges) const {
        const FitProblem problem = with(edges);
        Linearisation l = linearise(problem, {}, false, plans_, simulation_, progress_);
        if (!l.ok || l.residuals.size() != null_.fit.optimum.residuals.size() || !l.residuals.allFinite()) return {};
        return std::move(l.residuals);
    }

private:
    FitProblem with(const std::vector<InputEdge>& edges) const {
        FitProblem problem = prepared_->problem;
        for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
            const int index = prepared_->fitRecordings[e];
            Recording recording = null_.variant.task.recordings[static_cast<std::size_t>(index)];
            place(recording, index, edges);
            setSignals(problem.experiments[e], recording);
        }
        return problem;
    }

    const NullModel& null_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    Outcome<PreparedTask> prepared_;
    std::vector<GridPlan> plans_;
};

}  // namespace

std::vector<InputEdge> likeliestEdges(const NullModel& null, std::vector<InputEdge> edges, bool areAlike,
                                      const SimulationOptions& simulation, int threads, const Progress& progress,
                                      int& told) {
    told = 0;
    if (areAlike) std::erase_if(edges, [](const InputEdge& e) { return e.bend != 0; });
    if (edges.empty()) return {};
    EdgeModel model(null, simulation, progress);
    if (!model.isReady()) return {};
    model.plan(edges);
    const Complement complement(null.fit.optimum.jacobian);
    const double variance = null.sumOfSquares() / static_cast<double>(null.fit.optimum.residuals.size());
    const auto at = [&](const std::vector<double>& parts) {
        std::vector<InputEdge> moved = edges;
        for (std::size_t i = 0; i < edges.size(); ++i) moved[i].part = std::clamp(parts[areAlike ? 0 : i], 0.0, 1.0);
        return moved;
    };
    const auto misfit = [&](const Eigen::VectorXd& residuals) {
        return residuals.size() == 0 ? std::numeric_limits<double>::infinity() : complement(residuals).squaredNorm();
    };

    // all alike first: where a model is much faster than the sampling, no slope at the middle tells of the ends
    std::vector<double> parts(areAlike ? 1 : edges.size(), 0.5);
    const auto alike = [&](double part) {
        std::vector<double> tried(parts.size(), part);
        for (std::size_t i = 0; i < tried.size(); ++i)
            if (edges[i].bend != 0) tried[i] = 0.5;
        return tried;
    };
    const auto misfitAlike = [&](double part) { return misfit(model.residuals(at(alike(part)))); };
    std::vector<double> misfits(std::size(firstParts));
    parallelFor(static_cast<int>(misfits.size()), threads,
                [&](int i) { misfits[static_cast<std::size_t>(i)] = misfitAlike(firstParts[i]); });
    const auto best = static_cast<std::size_t>(std::min_element(misfits.begin(), misfits.end()) - misfits.begin());
    const double low = firstParts[best == 0 ? 0 : best - 1],
                 high = firstParts[std::min(best + 1, std::size(firstParts) - 1)];
    parts = alike(boost::math::tools::brent_find_minima(misfitAlike, low, high, bitsOfAPart).first);
    Eigen::VectorXd here = model.residuals(at(parts));
    if (here.size() == 0) return {};
    const auto unknowns = static_cast<Eigen::Index>(parts.size());
    for (const double width : {0.02, 0.005}) {
        Eigen::MatrixXd traces(here.size(), unknowns);
        std::atomic<bool> isWhole{true};
        parallelFor(static_cast<int>(unknowns), threads, [&](int j) {
            if (!isWhole || progress.stopRequested()) return;
            std::vector<double> tried = parts;
            double& part = tried[static_cast<std::size_t>(j)];
            const double by = part > 0.5 ? -width : width;
            part += by;
            const Eigen::VectorXd there = model.residuals(at(tried));
            if (there.size() == 0)
                isWhole = false;
            else
                traces.col(j) = (there - here) / by;
        });
        if (!isWhole || progress.stopRequested()) return {};
        const Eigen::MatrixXd own = complement(traces);
        Eigen::MatrixXd information = own.transpose() * own / variance;
        told = static_cast<int>((information.diagonal().array() > evenPrecision).count());
        information.diagonal().array() += evenPrecision;
        const Eigen::Map<const Eigen::VectorXd> now(parts.data(), unknowns);
        const Eigen::VectorXd step =
            -information.ldlt().solve(own.transpose() * complement(here) / variance +
                                      evenPrecision * (now - Eigen::VectorXd::Constant(unknowns, 0.5)));
        for (const double share : {1.0, 0.3, 0.1}) {
            std::vector<double> tried = parts;
            for (std::size_t i = 0; i < tried.size(); ++i)
                tried[i] = std::clamp(tried[i] + share * step[static_cast<Eigen::Index>(i)], nearestToSample,
                                      1 - nearestToSample);
            const Eigen::VectorXd there = model.residuals(at(tried));
            if (!(misfit(there) < misfit(here))) continue;
            parts = std::move(tried);
            here = there;
            break;
        }
    }
    return at(parts);
}

}  // namespace analogon
