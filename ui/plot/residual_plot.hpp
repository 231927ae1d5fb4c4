#pragma once

#include <QString>
#include <QWidget>
#include <cmath>
#include <functional>
#include <vector>

#include "core/study/study.hpp"
#include "ui/job/job.hpp"
#include "ui/plot/decimate.hpp"

class QComboBox;
class QLabel;

namespace analogon::ui {

struct NamedSeries {
    QString name;
    std::vector<double> values;
};

/// "i_mod [A]", as the heading of a column says it.
QString withUnit(const QString& name, const QString& unit);

/// The recorded columns of an experiment at these times (linear between samples), for "residual against".
std::vector<NamedSeries> variablesOf(const Study& study, const std::string& experiment,
                                     const std::vector<double>& time);

/// What is drawn of a residual, however long the recording is.
struct ResidualFacts {
    struct Variable {
        QString name;
        ValueRange range;
        std::vector<double> sampled;  // where the residual was sampled
    };
    int count{};  // finite samples
    ValueRange range;
    double mean{}, deviation{};
    std::vector<double> histogram;    // counts in equal bins from -reach() to reach()
    std::vector<double> correlation;  // from lag 0
    std::vector<double> sampled;      // every so many-th, for the scatter
    std::vector<Variable> against;

    /// Of white noise, 95 % of the correlations lie within.
    double correlationBound() const { return count > 0 ? 1.96 / std::sqrt(static_cast<double>(count)) : 1; }
    /// How far the axis of the correlations goes: the bound is seen on it, whatever lag 0 is (which always is 1).
    double correlationReach() const;
    double reach() const { return range.isEmpty() ? 1 : std::max({std::abs(range.low), std::abs(range.high), 1e-300}); }
};
ResidualFacts residualFacts(const std::vector<double>& residual, const std::vector<NamedSeries>& against);

/// What is left of one output: how it is distributed, how long it remembers itself, what it moves with. Worked out in
/// the background, and only when it is looked at.
class ResidualPlot : public QWidget {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget* parent = nullptr);

    void show(const QString& output, const QString& unit, std::function<ResidualFacts()> facts);
    /// What stands at the axes of the three pictures, x and y; empty: a count or a pure number.
    struct AxisLabels {
        QString distribution, correlation, againstX, againstY;
    };
    AxisLabels axisLabels() const;
    QComboBox* variableBox() const { return variable_; }
    const ResidualFacts& facts() const { return facts_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void workOut();
    void take(ResidualFacts facts);

    class Canvas;
    QString unit_;
    QLabel* name_;
    QComboBox* variable_;
    Canvas* canvas_;
    std::function<ResidualFacts()> wanted_;  // null: what is shown is up to date
    ResidualFacts facts_;
    JobRunner worker_;
};

}  // namespace analogon::ui
