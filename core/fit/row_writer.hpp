#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/fit/problem.hpp"
#include "core/simulate/simulate.hpp"

namespace analogon {

/// What the clock of an output is ahead by at these values, and which fit parameter it is (-1: none).
struct ClockAt {
    int output{};
    double offset{};
    int parameter{-1};
};

/// Writes the rows of one experiment while its samples pass by, and keeps the outputs.
class RowWriter final : public SampleSink {
public:
    /// `columns`: column of the Jacobian of each direction; `result`: with room for all rows, those of this experiment
    /// from `firstRow` on.
    RowWriter(const FitExperiment& experiment, const std::vector<Eigen::Index>& columns, Eigen::Index firstRow,
              bool withJacobian, const std::vector<ClockAt>& clocks, Linearisation& result);

    void take(int sample, const double* y, const double* dy) override;
    void takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions) override;
    void restart() override {}

    /// When all samples are there: what has a clock of its own is taken where that clock stamps it.
    void applyClocks();

    Eigen::MatrixXd outputs;  // rows: outputs, columns: samples; NaN where it did not get to

private:
    struct Output {
        Eigen::Index index{}, firstRow{};
        bool isComplete{}, hasClock{};
        std::vector<Eigen::Index> rows;  // of each sample, unless complete; -1: not measured
    };

    static Eigen::Index rowOf(const Output& output, Eigen::Index sample);
    void pass(const Output& output, int first, int count, const double* y, const double* dy, Eigen::Index stride);
    void write(const Output& output, int first, int count, const double* y, Eigen::Index yStride, const double* dy,
               Eigen::Index stride);
    void writeClock(const Output& output, const Eigen::RowVectorXd& rates, int parameter);

    const FitExperiment& experiment_;
    const std::vector<Eigen::Index>& columns_;
    bool withJacobian_{};
    const std::vector<ClockAt>& clocks_;
    Linearisation& result_;
    std::vector<Eigen::MatrixXd> slopes_;  // of outputs with a clock: rows: directions, columns: samples
    std::vector<Output> fitted_;
};

/// Shows the samples to two.
class BothSinks final : public SampleSink {
public:
    BothSinks(SampleSink& first, SampleSink& second) : sinks_{&first, &second} {}
    void take(int sample, const double* y, const double* dy) override {
        for (SampleSink* sink : sinks_) sink->take(sample, y, dy);
    }
    void takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions) override {
        for (SampleSink* sink : sinks_) sink->takeRows(first, count, rows, layout, directions);
    }
    void restart() override {
        for (SampleSink* sink : sinks_) sink->restart();
    }

private:
    std::array<SampleSink*, 2> sinks_;
};

}  // namespace analogon
