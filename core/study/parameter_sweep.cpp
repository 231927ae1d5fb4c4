#include "core/study/parameter_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/study/fit_traces.hpp"

namespace analogon {

namespace {

Diagnostics faultsOf(const std::vector<SweepAxis>& axes) {
    if (axes.empty() || axes.size() > 2)
        return {error(phrase("a sweep leads one or two parameters through values, not {}", axes.size()))};
    Diagnostics faults;
    for (const SweepAxis& axis : axes)
        if (axis.values.empty()) faults.push_back(error(phrase("the sweep has no values for {}", axis.parameter)));
    if (axes.size() == 2 && axes[0].parameter == axes[1].parameter)
        faults.push_back(error(phrase("both axes of the sweep are {}", axes[0].parameter)));
    return faults;
}

double errorAt(const FitProblem& problem, const Eigen::VectorXd& point, const Progress& progress) {
    const Linearisation line = linearise(problem, point, false, {}, {}, progress);
    return line.ok ? tracesOf(problem, line.trajectories).errorPercent : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<double> sweepValues(double from, double to, int count, bool isLogarithmic) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        values.push_back(isLogarithmic ? from * std::pow(to / from, share) : from + share * (to - from));
    }
    if (count > 1) values.back() = to;  // without rounding
    return values;
}

std::pair<Eigen::Index, Eigen::Index> ParameterSweep::least() const {
    std::pair<Eigen::Index, Eigen::Index> best{-1, -1};
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index row = 0; row < errorPercent.rows(); ++row)
        for (Eigen::Index column = 0; column < errorPercent.cols(); ++column) {
            if (!(errorPercent(row, column) < lowest)) continue;
            lowest = errorPercent(row, column);
            best = {row, column};
        }
    return best;
}

Outcome<ParameterSweep> sweep(const Study& study, const std::vector<SweepAxis>& axes, const Progress& progress) {
    if (Diagnostics faults = faultsOf(axes); !faults.empty()) return faults;
    Study turned = study;
    for (const SweepAxis& axis : axes) turned.parameters[axis.parameter].fit = true;
    const Outcome<EstimationTask> task = estimationTask(turned, UnusedColumns::Leave);
    if (!task) return task.diagnostics();
    const Outcome<PreparedTask> prepared = prepare(*task);
    if (!prepared) return prepared.diagnostics();
    const FitProblem& problem = prepared->problem;
    ParameterSweep result{axes, {}, {}, 0};
    std::vector<Eigen::Index> places;
    for (const SweepAxis& axis : axes) {
        const auto found =
            std::find_if(problem.parameters.begin(), problem.parameters.end(),
                         [&](const FitParameter& p) { return p.name == axis.parameter && p.experiment < 0; });
        if (found == problem.parameters.end())
            return error(phrase("the model has no parameter {} that may change", axis.parameter));
        places.push_back(found - problem.parameters.begin());
        result.units.push_back(found->unit);
    }
    const std::size_t columns = axes[0].values.size(), rows = axes.size() > 1 ? axes[1].values.size() : 1;
    result.errorPercent = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns),
                                                    std::numeric_limits<double>::quiet_NaN());
    Eigen::VectorXd point = problem.startValues();
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            if (progress.stopRequested()) return result;
            point[places[0]] = axes[0].values[column];
            if (axes.size() > 1) point[places[1]] = axes[1].values[row];
            const double found = errorAt(problem, point, progress);
            if (progress.stopRequested()) return result;  // in mid simulation: that is no fault of the point
            result.errorPercent(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = found;
            ++result.done;
            progress.report(
                {"sweep", {}, static_cast<double>(result.done) / static_cast<double>(rows * columns), -1, {}});
        }
    return result;
}

}  // namespace analogon
