#pragma once

#include <cmath>
#include <limits>

#include "core/effect/catalogue/finding.hpp"

/// A made-up search on a heated sensor, with every part of a finding filled in.
namespace analogon::test {

inline OutputState sampleOutput(const std::vector<double>& time, double modelError, double noise, double gain = 1,
                                double rest = 0) {
    OutputState output;
    output.name = "i_mod";
    output.unit = "A";
    const auto count = static_cast<Eigen::Index>(time.size());
    output.measured.resize(count);
    output.simulated.resize(count);
    unsigned seed = 12345;
    for (Eigen::Index k = 0; k < count; ++k) {
        const double t = time[static_cast<std::size_t>(k)];
        const double truth = rest + gain * (0.6 + 2.4 * std::exp(-t / 12) + 0.2 * std::sin(t / 7));
        seed = seed * 1664525u + 1013904223u;
        output.measured[k] = truth + noise * (static_cast<double>(seed >> 8) / (1 << 24) - 0.5);
        output.simulated[k] = truth + modelError * (1 - std::exp(-t / 25));
    }
    Eigen::RowVectorXd y = output.simulated.transpose(), m = output.measured.transpose();
    const Eigen::RowVectorXd d = y - m;
    output.figures.rmse = std::sqrt(d.squaredNorm() / static_cast<double>(count));
    output.figures.errorPercent = 100 * output.figures.rmse / (m.maxCoeff() - m.minCoeff());
    output.figures.relativeRmsPercent = 100 * d.norm() / m.norm();
    output.figures.fitPercent = 100 * (1 - d.norm() / (m.array() - m.mean()).matrix().norm());
    output.figures.maxAbs = d.cwiseAbs().maxCoeff();
    return output;
}

inline ModelState sampleState(double modelError) {
    ModelState state;
    state.status = FitStatus::Converged;
    state.message = "the cost no longer falls";
    state.simulations = 84;
    state.seconds = 0.42;
    state.parameters = {{"heater.R", "Ohm", 3.0961, 0.0213, false, -1},
                        {"heater.alpha", "1/K", 0.00391, 0.00002, false, -1},
                        {"element.C", "J/K", 0.1, std::numeric_limits<double>::quiet_NaN(), true, -1}};
    for (const Role role : {Role::Fit, Role::Validate}) {
        ExperimentState experiment;
        experiment.name = role == Role::Fit ? "warm-up" : "drive cycle <2>";
        experiment.role = role;
        const int samples = role == Role::Fit ? 4000 : 900;
        for (int k = 0; k < samples; ++k) experiment.time.push_back(60.0 * k / samples);
        experiment.outputs.push_back(sampleOutput(experiment.time, modelError, 0.08));
        OutputState second = sampleOutput(experiment.time, -60 * modelError, 3, -180, 900);
        second.name = "T_element";
        second.unit = "K";
        experiment.outputs.push_back(second);
        double sum = 0;
        for (const OutputState& output : experiment.outputs) sum += std::pow(output.figures.errorPercent, 2);
        experiment.errorPercent = std::sqrt(sum / 2);
        state.experiments.push_back(std::move(experiment));
    }
    state.residual["i_mod"] = {0.0231, 0.0233, 1.1, true};
    state.residual["T_element"] = {0.86, modelError > 0.1 ? 8.7 : 0.88, modelError > 0.1 ? 310.0 : 1.3,
                                   modelError < 0.1};
    return state;
}

inline Finding sampleFinding() {
    Finding finding;
    finding.kind = FindingKind::Effect;
    finding.baseline = sampleState(0.4);
    finding.final = sampleState(0.004);
    finding.final.parameters.push_back({"radiation.k_r", "W/K4", 2.1034e-11, 3.1e-13, false, -1});
    finding.final.parameters.push_back({"element.T_start", "K", 291.4, 0.3, false, 0});
    AddedEffect effect;
    effect.kind = "thermal.radiation";
    effect.className = "Analogon.Effects.Thermal.Radiation";
    effect.at = "element.solid";
    effect.wired.instance = "radiation";
    effect.description = "Radiation to the surroundings";
    effect.parameters = {{"k_r", 2.1034e-11, 3.1e-13, "W/K4"}};
    effect.evidence = {812.3, 0, -1540.2, 0.97, 8.6, 1.1};
    effect.instead.effects = {{"thermal.loss", "element.solid", -610.4, false},
                              {"convection.exponent", "element", -1536.0, true}};
    finding.effects = {effect};
    finding.candidates = {
        {"thermal.radiation",
         "element.solid",
         "Analogon.Effects.Thermal.Radiation",
         {812.3, 2e-11, {}},
         -1540.2,
         Verdict::Chosen,
         1},
        {"thermal.loss",
         "element.solid",
         "Analogon.Effects.Thermal.Loss",
         {640.2, 0.0123, {}},
         -610.4,
         Verdict::Weaker,
         1},
        {"convection.exponent",
         "element",
         "Analogon.Effects.ThermalFluid.Exponent",
         {809.0, 0.4, {}},
         -1536.0,
         Verdict::Equivalent,
         1},
        {"resistance.series",
         "heater",
         "Analogon.Effects.ElectricThermal.SeriesResistance",
         {22.1, 0.31, {}},
         -14.0,
         Verdict::FailsHeldOut,
         1},
        {"sensor.lag", "output i_mod", "Analogon.Effects.Sensor.Lag", {3.2, 0.01, {}}, {}, Verdict::NotSignificant, 1},
        {"thermal.resistance",
         "heater.heatPort",
         "Analogon.Effects.Thermal.Resistance",
         {0.2, 0.4, {"element.C", "heater.R"}},
         {},
         Verdict::Absorbed,
         1},
        {"thermal.latent",
         "element.solid",
         "Analogon.Effects.Thermal.Latent",
         {5.5, -3, {}},
         {},
         Verdict::WrongSign,
         2}};
    finding.nextExperiment =
        "Hold u_heater at 5 V for 200 s with the engine off: radiation and natural convection then "
        "differ by 14 times the noise.";
    finding.warnings = {"train.csv:812: the recording pauses for 1.2 s before this row; its usual step is 0.05 s",
                        "R and alpha are <strongly> correlated (0.97)"};
    finding.end.seconds = 12.3;
    return finding;
}

}  // namespace analogon::test
