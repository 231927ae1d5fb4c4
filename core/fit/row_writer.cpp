#include "core/fit/row_writer.hpp"

#include <algorithm>
#include <limits>

#include "core/base/memory.hpp"
#include "core/fit/clock.hpp"

namespace analogon {

RowWriter::RowWriter(const FitExperiment& experiment, const std::vector<Eigen::Index>& columns, Eigen::Index firstRow,
                     bool withJacobian, const std::vector<ClockAt>& clocks, Linearisation& result)
    : experiment_(experiment),
      columns_(columns),
      withJacobian_(withJacobian),
      clocks_(clocks),
      result_(result),
      slopes_(experiment.measured.rows()) {
    for (const ClockAt& clock : clocks_)
        slopes_[static_cast<std::size_t>(clock.output)].resize(withJacobian ? columns.size() : 0,
                                                               experiment.measured.cols());
    resizeLarge(outputs, experiment.measured.rows(), experiment.measured.cols());
    outputs.setConstant(std::numeric_limits<double>::quiet_NaN());
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o) {
        if (!experiment.isFitted(o)) continue;
        Output output;
        output.index = o;
        output.firstRow = firstRow;
        output.isComplete = !experiment.hasGaps(o);
        output.hasClock = std::any_of(clocks.begin(), clocks.end(), [&](const ClockAt& c) { return c.output == o; });
        for (Eigen::Index k = 0; k < experiment.measured.cols() && !output.isComplete; ++k)
            output.rows.push_back(std::isnan(experiment.measured(o, k)) ? -1 : firstRow++);
        if (output.isComplete) firstRow += experiment.measured.cols();
        fitted_.push_back(std::move(output));
    }
}

void RowWriter::take(int sample, const double* y, const double* dy) {
    outputs.col(sample) = Eigen::Map<const Eigen::VectorXd>(y, outputs.rows());
    for (const Output& output : fitted_)
        pass(output, sample, 1, y + output.index,
             dy ? dy + output.index * static_cast<Eigen::Index>(columns_.size()) : nullptr, 0);
}

void RowWriter::takeRows(int first, int count, const double* rows, const RowLayout& layout, int /*directions*/) {
    for (int j = 0; j < count; ++j)
        outputs.col(first + j) =
            Eigen::Map<const Eigen::VectorXd>(rows + j * layout.resultSize() + layout.value(0), outputs.rows());
    for (const Output& output : fitted_) {
        const int o = static_cast<int>(output.index);
        pass(output, first, count, rows + layout.value(o), rows + layout.tangent(o), layout.resultSize());
    }
}

void RowWriter::applyClocks() {
    const std::vector<double>& time = experiment_.inputs.time;
    for (const ClockAt& clock : clocks_) {
        const Eigen::MatrixXd& slopes = slopes_[static_cast<std::size_t>(clock.output)];
        Eigen::RowVectorXd shifted(outputs.cols()), rates(outputs.cols());
        Eigen::MatrixXd shiftedSlopes = Eigen::MatrixXd::Zero(slopes.rows(), slopes.cols());
        for (Eigen::Index k = 0; k < outputs.cols(); ++k) {
            const TimeStencil stencil = stencilAt(time, time[static_cast<std::size_t>(k)] - clock.offset);
            const auto value = [&](int sample) { return outputs(clock.output, sample); };
            shifted[k] = stencil.value(value);
            rates[k] = stencil.slope(value);
            for (int j = 0; j < stencil.count && slopes.cols() > 0; ++j)
                shiftedSlopes.col(k) += stencil.weights[static_cast<std::size_t>(j)] * slopes.col(stencil.first + j);
        }
        outputs.row(clock.output) = shifted;
        for (const Output& output : fitted_) {
            if (output.index != clock.output) continue;
            write(output, 0, static_cast<int>(shifted.size()), shifted.data(), 1, shiftedSlopes.data(),
                  shiftedSlopes.rows());
            if (withJacobian_ && clock.parameter >= 0) writeClock(output, rates, clock.parameter);
        }
    }
}

Eigen::Index RowWriter::rowOf(const Output& output, Eigen::Index sample) {
    return output.isComplete ? output.firstRow + sample : output.rows[static_cast<std::size_t>(sample)];
}

/// Written at once, or kept until the clock can be applied.
void RowWriter::pass(const Output& output, int first, int count, const double* y, const double* dy,
                     Eigen::Index stride) {
    if (!output.hasClock) return write(output, first, count, y, stride, dy, stride);
    Eigen::MatrixXd& kept = slopes_[static_cast<std::size_t>(output.index)];
    for (int j = 0; j < count && kept.rows() > 0; ++j)
        kept.col(first + j) = Eigen::Map<const Eigen::VectorXd>(dy + j * stride, kept.rows());
}

void RowWriter::write(const Output& output, int first, int count, const double* y, Eigen::Index yStride,
                      const double* dy, Eigen::Index stride) {
    const double weight = experiment_.weights[output.index];
    for (int j = 0; j < count; ++j) {
        const Eigen::Index row = rowOf(output, first + j);
        if (row >= 0)
            result_.residuals[row] = weight * (y[j * yStride] - experiment_.measured(output.index, first + j));
    }
    for (std::size_t k = 0; withJacobian_ && k < columns_.size(); ++k) {
        double* const column = result_.jacobian.data() + columns_[k] * result_.jacobian.rows();
        const double* slope = dy + k;
        for (int j = 0; j < count; ++j, slope += stride) {
            const Eigen::Index row = rowOf(output, first + j);
            if (row >= 0) column[row] = weight * *slope;
        }
    }
}

void RowWriter::writeClock(const Output& output, const Eigen::RowVectorXd& rates, int parameter) {
    for (Eigen::Index k = 0; k < rates.size(); ++k) {
        const Eigen::Index row = rowOf(output, k);
        if (row >= 0) result_.jacobian(row, parameter) = -experiment_.weights[output.index] * rates[k];
    }
}

}  // namespace analogon
