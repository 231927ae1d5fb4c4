#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/effect/judge/settled_flows.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::disturbance::mostDisturbances;

/// Whether the misfit of a model beside a disturbance has fallen enough for another step, or another round of them.
bool isFallen(double before, double now);

/// Whether what the error of a sensor leaves on the other outputs (mean square, in units of the noise) is more than may
/// be left beside it, of so much that is left in all: the disturbance is then none of that sensor.
bool isFeltElsewhere(double left, double all);

/// A flow that nobody measured and that no law governs (a draught, a load that varies) as part of a model's noise: a
/// Gaussian process of its own variance and correlation time at one node, or the slow error of one sensor. The residual
/// then has the covariance V = s^2 (I + q A C A'), A the responses to pieces of the flow and C their correlation;
/// beside flows at other places, which are settled, V = s^2 (B + q A C A').
class Disturbance {
public:
    /// The responses of a model at its parameters; of these places alone (empty: of all).
    Disturbance(const NullModel& model, const SimulationOptions& simulation, const Progress& progress,
                const std::set<std::string>& places = {});
    /// `pieces` of a flow over every recording: one column more for each in the responses.
    Disturbance(std::vector<ResidualChannel> channels, std::vector<FlowResponse> responses, int pieces);

    /// A place, a variance and a correlation time of the flow: a metric of what a model leaves.
    struct Metric {
        int source{-1};     // no flow
        double variance{};  // in units of the noise
        double misfit{};    // of what it was found for
    };
    /// -2 ln of the likelihood of these residuals, but for a constant, in independent samples: the least over all
    /// metrics, that one with it.
    Metric likeliest(const Eigen::VectorXd& residuals) const;
    /// The same where the parameters follow to first order (generalised least squares by their Jacobian).
    Metric likeliest(const Linearisation& model) const;
    /// Places where a flow explains at least this share of what it does at the likeliest one.
    std::set<std::string> likelyPlaces(const Linearisation& model, double share) const;
    /// The likeliest of all, and behind a flow those at other places that are as likely; no sensor while the other
    /// outputs are left unexplained, too. Empty: no disturbance is.
    std::vector<std::string> likeliestPlaces(const Linearisation& model) const;
    /// The flow at a place that is likeliest to have left this: its size and time constant by maximum likelihood, where
    /// the parameters follow to first order. Nothing: no flow is felt there.
    std::optional<UnmeasuredFlow> flowAt(const Linearisation& model, const std::string& place) const;

    /// How the parameters follow in a metric; the normal equations are damped by that part of their diagonal, `held`
    /// parameters stay.
    Eigen::VectorXd step(const Linearisation& model, const Metric& metric, double damping,
                         const std::vector<bool>& held = {}) const;
    /// Slope of the sum of squares in a metric along each parameter.
    Eigen::VectorXd gradient(const Linearisation& model, const Metric& metric) const;
    /// Settles flows at other places, beside which the likeliest of a further one is sought from then on: as many as
    /// these residuals clearly ask for, with the one that is sought no more than `most`.
    void settle(const Eigen::VectorXd& residuals, std::size_t most = mostDisturbances);
    /// Places of the settled flows.
    std::set<std::string> settledPlaces() const;

    /// Share of the samples that are independent, in what the flow does not explain.
    double independentShare(const Eigen::VectorXd& residuals, const Metric& metric) const;

private:
    using Flow = SettledFlows::Flow;
    using Source = SettledFlows::Source;
    /// The flows that are settled, and what a further one is sought among: at their responses' order, without those of
    /// the flows.
    struct Settled {
        SettledFlows flows;
        std::shared_ptr<const std::vector<Source>> sources{};
    };
    const Source& sourceOf(const Metric& metric) const {
        return (*settled_.sources)[static_cast<std::size_t>(metric.source)];
    }
    const std::vector<FlowResponse>& responses() const { return settled_.flows.responses(); }
    Flow flowOf(const Metric& metric) const;
    void seekSources();
    void add(const std::vector<Flow>& flows);
    /// Visits every metric: f(metric, products of the columns of `both` in it).
    template <class Visit>
    void visit(const Eigen::MatrixXd& both, const Visit& each) const;
    Eigen::MatrixXd products(const Eigen::MatrixXd& both, const Metric& metric) const;
    double misfit(const Eigen::MatrixXd& products, const Metric& metric, double rows) const;
    Metric leastMisfit(const Eigen::MatrixXd& both) const;
    /// Of each place, over its metrics; "": of none.
    std::map<std::string, double> leastMisfits(const Linearisation& model) const;

    std::vector<ResidualChannel> channels_;
    Settled settled_;
};

/// What is likeliest to have left a residual, where the parameters follow to first order.
struct LikelySource {
    /// Connectors, of those that are as likely the one where most parts meet first, or "output y" for an error of that
    /// sensor alone. Empty: none is.
    std::vector<std::string> places;
    std::optional<UnmeasuredFlow> flow;  // at the first of them, where it is a connector
};
LikelySource likeliestSource(const NullModel& model, const SimulationOptions& simulation, const Progress& progress);

/// A model beside the flow that is likeliest with it.
struct BesideDisturbance {
    double misfit{};                       // -2 ln of the likelihood, but for a constant, in independent samples
    double independent{};                  // share of the samples, in what neither model nor flow explains
    std::vector<ParameterValue> values{};  // of the parameters there
};

/// At the parameters that are likeliest with both, which plain least squares may miss by far: there they have given way
/// to the flow, and so have the responses. By Levenberg and Marquardt's method. Of as many flows as the residual asks
/// for, but no more than `most`: where noise is left, one is the memory that it may have.
BesideDisturbance besideDisturbance(const NullModel& model, const SimulationOptions& simulation,
                                    const Progress& progress, std::size_t most = mostDisturbances);

/// The same of a model with an effect, from where least squares came to. The flow may have led that astray: an effect
/// that is nothing is as likely as the model without it, so where a descent ends above that (`alone`), another begins
/// where that is likeliest; where the effect still gains nothing, one more at what is `offered` for its parameters.
BesideDisturbance besideDisturbanceAlso(const BesideDisturbance& alone, const NullModel& with,
                                        const SimulationOptions& simulation, const Progress& progress,
                                        std::size_t most = mostDisturbances,
                                        const std::vector<ParameterValue>& offered = {});

/// Decrease of BIC from one model to another that has `more` parameters, each beside its disturbance; of `rows`
/// samples.
double evidenceBeside(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int more);

}  // namespace analogon
