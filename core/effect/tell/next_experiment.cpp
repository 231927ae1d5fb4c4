#include "core/effect/tell/next_experiment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/range.hpp"
#include "core/base/unit.hpp"

namespace analogon {
namespace {

constexpr int mostSamples = 2000;

/// Values of an input that a shape runs between, with their unit.
struct Ends {
    Text low, high, middle;
};

/// A shape between 0 and 1 over a time between 0 and 1; the words name its ends.
struct Shape {
    std::function<Text(const Ends&)> words;
    std::function<double(double)> at;
};

const std::vector<Shape>& shapes() {
    static const auto triangle = [](double s) { return s < 0.5 ? 2 * s : 2 - 2 * s; };
    static const std::vector<Shape> all{
        {[](const Ends& ends) {
             return phrase("a step from {} to {} and, after half the time, back", ends.low, ends.high);
         },
         [](double s) { return s > 0.1 && s < 0.6 ? 1.0 : 0.0; }},
        {[](const Ends& ends) { return phrase("a slow ramp from {} to {} and back", ends.low, ends.high); }, triangle},
        {[](const Ends& ends) {
             return phrase("stairs from {} to {} and back in eight steps each way", ends.low, ends.high);
         },
         [](double s) { return std::min(1.0, std::floor(triangle(s) * 8.999) / 8); }},
        {[](const Ends& ends) { return phrase("small steps of a tenth about {}", ends.middle); },
         [](double s) { return 0.5 + 0.05 * (std::fmod(8 * s, 1.0) < 0.5 ? 1.0 : -1.0); }},
        {[](const Ends& ends) {
             return phrase("a fast change between {} and {}, some forty times", ends.low, ends.high);
         },
         [](double s) { return std::fmod(40 * s, 1.0) < 0.5 ? 1.0 : 0.0; }},
        {[](const Ends& ends) {
             return phrase("a sine sweep between {} and {}, from one to sixty periods a recording", ends.low,
                           ends.high);
         },
         [](double s) {
             const double growth = std::log(60.0);
             return 0.5 + 0.5 * std::sin(2 * std::numbers::pi * (std::exp(growth * s) - 1) / growth);
         }},
        {[](const Ends& ends) { return phrase("{} held from the start", ends.high); }, [](double) { return 1.0; }},
    };
    return all;
}

/// What an input did in the fitted recordings.
struct InputRange : Range {
    double mean{};
    bool moves() const { return width() > 1e-6 * std::max(std::abs(low), std::abs(high)); }
};

std::vector<InputRange> inputRanges(const EstimationTask& task, const Recording& first) {
    std::vector<InputRange> ranges;
    for (const std::string& name : first.inputNames) {
        InputRange range;
        double sum = 0;
        long count = 0;
        for (const Recording& r : task.recordings) {
            const auto at = std::find(r.inputNames.begin(), r.inputNames.end(), name);
            if (r.role != Role::Fit || at == r.inputNames.end()) continue;
            for (const double u : r.inputs.row(at - r.inputNames.begin())) {
                range.take(u);
                sum += u;
                ++count;
            }
        }
        range.mean = count > 0 ? sum / static_cast<double>(count) : 0;
        ranges.push_back(range);
    }
    return ranges;
}

/// A model on one programme: its fitted values, start values as in the first recording.
Outcome<PreparedTask> onProgramme(const Variant& model, const Recording& programme, const Eigen::VectorXd& noise) {
    Variant variant = model;
    variant.task.recordings = {programme};
    std::erase_if(variant.values, [](const ParameterValue& v) { return v.experiment > 0; });
    return prepareAt(variant, {noise});
}

/// Gives an input of a model on a programme other values.
void play(PreparedTask& prepared, const std::string& input, const Eigen::RowVectorXd& values) {
    prepared.problem.experiments.front().inputs.values.row(prepared.system->inputIndex(input)) = values;
}

/// Least of |r + J d|^2 + |J_0 d|^2 over changes d of the rival's parameters: r and J on the programme, J_0 on the
/// recordings at which the rival stands at its optimum.
double leastMisfit(const Linearisation& onNew, const FitProblem& problem, const FitResult& atHand) {
    const Eigen::Index count = atHand.optimum.jacobian.cols();
    Eigen::MatrixXd normal = atHand.optimum.jacobian.transpose() * atHand.optimum.jacobian;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(onNew.jacobian.rows(), count);
    for (Eigen::Index k = 0; k < onNew.jacobian.cols(); ++k) {
        const FitParameter& p = problem.parameters[static_cast<std::size_t>(k)];
        for (Eigen::Index j = 0; j < count && j < static_cast<Eigen::Index>(atHand.estimates.size()); ++j) {
            const FitEstimate& e = atHand.estimates[static_cast<std::size_t>(j)];
            if (e.name == p.name && e.experiment == p.experiment) jacobian.col(j) = onNew.jacobian.col(k);
        }
    }
    normal += jacobian.transpose() * jacobian;
    // parameters differ by many powers of ten
    const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd gradient = scale.asDiagonal() * (jacobian.transpose() * onNew.residuals);
    const Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> factors(scaled + 1e-12 * Eigen::MatrixXd::Identity(count, count));
    return std::max(0.0, onNew.residuals.squaredNorm() - gradient.dot(factors.solve(gradient)));
}

Text inWords(const Shape& shape, const InputRange& range, const std::string& unit) {
    const auto value = [&](double u) { return phrase("{:.3g}{}", u, behindNumber(unit)); };
    return shape.words({value(range.low), value(range.high), value(0.5 * (range.low + range.high))});
}

}  // namespace

std::optional<ProposedExperiment> nextExperiment(const NullModel& chosen, const Trial& rival,
                                                 const SimulationOptions& simulation, const Progress& progress) {
    const std::vector<int> fitted = recordingsOf(chosen.variant.task, Role::Fit);
    if (fitted.empty() || rival.fit.optimum.jacobian.size() == 0) return std::nullopt;
    const auto index = static_cast<std::size_t>(fitted.front());
    const Recording& first = chosen.variant.task.recordings[index];
    const Eigen::VectorXd& noise = chosen.noise[index];
    const std::vector<InputRange> ranges = inputRanges(chosen.variant.task, first);

    Recording programme = first;
    const auto samples = static_cast<Eigen::Index>(std::min<std::size_t>(first.time.size(), mostSamples));
    const double begin = first.time.front(), span = first.time.back() - begin;
    const double perSample = static_cast<double>(first.time.size()) / static_cast<double>(samples);
    programme.time.resize(static_cast<std::size_t>(samples));
    for (Eigen::Index k = 0; k < samples; ++k)
        programme.time[static_cast<std::size_t>(k)] = begin + span * static_cast<double>(k) / (samples - 1.0);
    for (SpareChannel& s : programme.spares)
        s.values.assign(programme.time.size(), s.values.empty() ? 0.0 : s.values.front());

    programme.inputs.resize(static_cast<Eigen::Index>(ranges.size()), samples);
    for (std::size_t j = 0; j < ranges.size(); ++j)
        programme.inputs.row(static_cast<Eigen::Index>(j)).setConstant(ranges[j].mean);
    programme.clocks.clear();
    programme.outputs = Eigen::MatrixXd::Zero(first.outputs.rows(), samples);
    Outcome<PreparedTask> truth = onProgramme(chosen.variant, programme, noise);
    Outcome<PreparedTask> other = onProgramme(rival.variant, programme, noise);
    if (!truth || !other) return std::nullopt;

    std::optional<ProposedExperiment> best;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (!ranges[i].moves()) continue;
        for (const Shape& shape : shapes()) {
            if (progress.stopRequested()) return best;
            Eigen::RowVectorXd values(samples);
            for (Eigen::Index k = 0; k < samples; ++k)
                values[k] = ranges[i].low + ranges[i].width() * shape.at(static_cast<double>(k) / (samples - 1));
            play(*truth, first.inputNames[i], values);
            play(*other, first.inputNames[i], values);
            const Linearisation seen =
                linearise(truth->problem, truth->problem.startValues(), false, {}, simulation, progress);
            if (!seen.ok) continue;
            // both systems have the outputs of the model in its order
            other->problem.experiments.front().measured = seen.trajectories.front().outputs;
            const Linearisation misfit =
                linearise(other->problem, other->problem.startValues(), true, {}, simulation, progress);
            if (!misfit.ok) continue;
            const double separation = std::sqrt(perSample * leastMisfit(misfit, other->problem, rival.fit));
            if (best && separation <= best->separation) continue;
            const SignalInfo& input =
                truth->system->inputs()[static_cast<std::size_t>(truth->system->inputIndex(first.inputNames[i]))];
            best = ProposedExperiment{
                phrase("input {} as {}, over {:.3g} s", input.name, inWords(shape, ranges[i], input.unit), span),
                separation};
        }
        const Eigen::RowVectorXd atRest = Eigen::RowVectorXd::Constant(samples, ranges[i].mean);
        play(*truth, first.inputNames[i], atRest);
        play(*other, first.inputNames[i], atRest);
    }
    return best;
}

}  // namespace analogon
