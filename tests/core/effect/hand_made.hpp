#pragma once

#include <random>

#include "core/effect/model/null_model.hpp"

/// Models made by hand: a fit that ended with these residuals, without a model text and a simulation.
namespace analogon {

/// White noise of deviation 1.
inline Eigen::VectorXd whiteNoise(Eigen::Index samples, unsigned seed = 5) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::NullaryExpr(samples, [&] { return normal(random); });
}

/// So many whole waves over the samples.
inline Eigen::VectorXd sineWave(Eigen::Index samples, double waves) {
    return Eigen::VectorXd::NullaryExpr(samples, [&](Eigen::Index k) {
        return std::sin(2 * M_PI * waves * static_cast<double>(k) / static_cast<double>(samples));
    });
}

/// The residuals of one output in one recording that was measured without a gap.
inline ResidualChannel wholeChannel(int samples) {
    ResidualChannel channel;
    channel.end = samples;
    for (int k = 0; k < samples; ++k) channel.samples.push_back(k);
    channel.measured = Eigen::VectorXd::Zero(samples);
    return channel;
}

/// A fitted model of one output in one recording, sampled every second, of noise 1: what it leaves, and the columns of
/// its parameters p1, p2 … (value 1).
inline NullModel modelThatLeaves(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& columns) {
    NullModel null;
    const auto samples = static_cast<int>(residuals.size());
    Recording r;
    r.name = "run";
    r.outputNames = {"y"};
    r.inputs.resize(0, samples);
    r.outputs = Eigen::MatrixXd::Zero(1, samples);
    for (int k = 0; k < samples; ++k) r.time.push_back(k);
    null.variant.task.recordings = {r};
    null.noise = {Eigen::VectorXd::Ones(1)};
    null.channels = {wholeChannel(samples)};
    null.fit.optimum.ok = true;
    null.fit.optimum.residuals = residuals;
    null.fit.optimum.jacobian = columns;
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
        FitEstimate p;
        p.name = "p" + std::to_string(j + 1);
        p.value = 1;
        null.fit.estimates.push_back(p);
    }
    return null;
}

}  // namespace analogon
