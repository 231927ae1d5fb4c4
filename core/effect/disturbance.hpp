#pragma once

#include "core/effect/missing_flow.hpp"

namespace analogon {

/// A flow that nobody measured and that no law governs (a draught, a load that varies) as part of a model's noise: a
/// Gaussian process of its own variance and correlation time at one node, or the slow error of one sensor. The residual
/// then has the covariance V = s^2 (I + q A C A'), A the responses to pieces of the flow and C their correlation.
class Disturbance {
public:
    /// The responses of a model; they serve for every model near it.
    Disturbance(const NullModel& null, const SimulationOptions& simulation, const Progress& progress);
    /// `pieces` of a flow over every recording: one column more for each in the responses.
    Disturbance(std::vector<ResidualChannel> channels, const std::vector<FlowResponse>& responses, int pieces);

    /// -2 ln of the likelihood of what a model leaves, but for a constant, in independent samples: the least over the
    /// place, the variance and the correlation time of the flow. The parameters follow to first order (generalised
    /// least squares by their Jacobian).
    struct Estimate {
        double misfit{};
        double independent{};  // share of the samples, in what neither model nor flow explains
    };
    Estimate estimate(const Linearisation& model) const;

    /// Fall in BIC from one model to another that has `more` parameters, each beside the flow that is likeliest with
    /// it.
    double evidence(const Linearisation& without, const Linearisation& with, int more) const;

private:
    struct Source {
        Eigen::MatrixXd columns;  // A times the root of C, turned so that its columns are orthogonal
        Eigen::VectorXd squares;  // their squared lengths
    };
    std::vector<ResidualChannel> channels_;
    std::vector<Source> sources_;
};

}  // namespace analogon
