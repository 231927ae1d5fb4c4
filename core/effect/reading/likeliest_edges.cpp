#include "core/effect/reading/likeliest_edges.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/effect/model/score.hpp"

namespace analogon {

namespace {

constexpr double evenPrecision = 12;  // of a number that lies anywhere between 0 and 1: its variance is 1/12

constexpr double firstParts[] = {0.001, 0.01, 0.03, 0.06, 0.12, 0.25, 0.5, 0.75, 0.88, 0.94, 0.97, 0.99, 0.999};
constexpr int bitsOfAPart = 8;

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

/// Least squares of the parts of their intervals at which edges are, beside the parameters along their tangents.
class EdgeFit {
public:
    EdgeFit(const EdgeModel& model, const NullModel& null, const std::vector<InputEdge>& edges, bool areAlike,
            int threads, const Progress& progress)
        : model_(model),
          complement_(null.fit.optimum.jacobian),
          variance_(null.sumOfSquares() / static_cast<double>(null.fit.optimum.residuals.size())),
          edges_(edges),
          areAlike_(areAlike),
          threads_(threads),
          progress_(progress),
          parts_(areAlike ? 1 : edges.size(), 0.5) {}

    /// False: it could not be simulated, or was stopped.
    bool run() {
        // all alike first: where a model is much faster than the sampling, no slope at the middle tells of the ends
        seekAlike();
        residuals_ = model_.residuals(edgesAt(parts_));
        if (residuals_.size() == 0) return false;
        for (const double width : {0.02, 0.005}) {
            const std::optional<Eigen::MatrixXd> traces = tracesWithin(width);
            if (!traces) return false;
            follow(stepAlong(*traces));
        }
        return true;
    }

    std::vector<InputEdge> edges() const { return edgesAt(parts_); }
    /// How many of the parts the data tell.
    int told() const { return told_; }

private:
    std::vector<InputEdge> edgesAt(const std::vector<double>& parts) const {
        std::vector<InputEdge> moved = edges_;
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i].part = std::clamp(parts[areAlike_ ? 0 : i], 0.0, 1.0);
        return moved;
    }
    double misfit(const Eigen::VectorXd& residuals) const {
        return residuals.size() == 0 ? std::numeric_limits<double>::infinity() : complement_(residuals).squaredNorm();
    }
    std::vector<double> alike(double part) const {
        std::vector<double> tried(parts_.size(), part);
        for (std::size_t i = 0; i < tried.size(); ++i)
            if (edges_[i].bend != 0) tried[i] = 0.5;
        return tried;
    }

    void seekAlike() {
        const auto misfitAlike = [&](double part) { return misfit(model_.residuals(edgesAt(alike(part)))); };
        std::vector<double> misfits(std::size(firstParts));
        parallelFor(static_cast<int>(misfits.size()), threads_,
                    [&](int i) { misfits[static_cast<std::size_t>(i)] = misfitAlike(firstParts[i]); });
        const auto best = static_cast<std::size_t>(std::min_element(misfits.begin(), misfits.end()) - misfits.begin());
        const double low = firstParts[best == 0 ? 0 : best - 1],
                     high = firstParts[std::min(best + 1, std::size(firstParts) - 1)];
        parts_ = alike(boost::math::tools::brent_find_minima(misfitAlike, low, high, bitsOfAPart).first);
    }

    /// Slopes of the residual along each part, by differences of that width.
    std::optional<Eigen::MatrixXd> tracesWithin(double width) const {
        Eigen::MatrixXd traces(residuals_.size(), static_cast<Eigen::Index>(parts_.size()));
        std::atomic<bool> isWhole{true};
        parallelFor(static_cast<int>(parts_.size()), threads_, [&](int j) {
            if (!isWhole || progress_.stopRequested()) return;
            std::vector<double> tried = parts_;
            double& part = tried[static_cast<std::size_t>(j)];
            const double by = part > 0.5 ? -width : width;
            part += by;
            const Eigen::VectorXd there = model_.residuals(edgesAt(tried));
            if (there.size() == 0)
                isWhole = false;
            else
                traces.col(j) = (there - residuals_) / by;
        });
        if (!isWhole || progress_.stopRequested()) return std::nullopt;
        return traces;
    }

    /// Gauss-Newton, each part equally likely beforehand between 0 and 1.
    Eigen::VectorXd stepAlong(const Eigen::MatrixXd& traces) {
        const auto unknowns = static_cast<Eigen::Index>(parts_.size());
        const Eigen::MatrixXd own = complement_(traces);
        Eigen::MatrixXd information = own.transpose() * own / variance_;
        told_ = static_cast<int>((information.diagonal().array() > evenPrecision).count());
        information.diagonal().array() += evenPrecision;
        const Eigen::Map<const Eigen::VectorXd> now(parts_.data(), unknowns);
        return -information.ldlt().solve(own.transpose() * complement_(residuals_) / variance_ +
                                         evenPrecision * (now - Eigen::VectorXd::Constant(unknowns, 0.5)));
    }

    /// As much of a step as leaves less.
    void follow(const Eigen::VectorXd& step) {
        for (const double share : {1.0, 0.3, 0.1}) {
            std::vector<double> tried = parts_;
            for (std::size_t i = 0; i < tried.size(); ++i)
                tried[i] = std::clamp(tried[i] + share * step[static_cast<Eigen::Index>(i)], nearestToSample,
                                      1 - nearestToSample);
            const Eigen::VectorXd there = model_.residuals(edgesAt(tried));
            if (!(misfit(there) < misfit(residuals_))) continue;
            parts_ = std::move(tried);
            residuals_ = there;
            return;
        }
    }

    const EdgeModel& model_;
    const OrthogonalProjector complement_;
    const double variance_;
    const std::vector<InputEdge>& edges_;
    const bool areAlike_;
    const int threads_;
    const Progress& progress_;
    std::vector<double> parts_;
    Eigen::VectorXd residuals_;
    int told_{};
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
    EdgeFit fit(model, null, edges, areAlike, threads, progress);
    const bool isFitted = fit.run();
    told = fit.told();
    return isFitted ? fit.edges() : std::vector<InputEdge>();
}

}  // namespace analogon
