#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "core/study/study.hpp"

class QComboBox;
class QLabel;

namespace analogon::ui {

struct NamedSeries {
    QString name;
    std::vector<double> values;
};

/// The recorded columns of an experiment at these times (linear between samples), for "residual against".
std::vector<NamedSeries> variablesOf(const Study& study, const std::string& experiment,
                                     const std::vector<double>& time);

/// What is left of one output: how it is distributed, how long it remembers itself, what it moves with.
class ResidualPlot : public QWidget {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget* parent = nullptr);

    void show(const QString& output, std::vector<double> residual, std::vector<NamedSeries> against);
    QComboBox* variableBox() const { return variable_; }
    const std::vector<double>& autocorrelation() const { return correlation_; }

private:
    class Canvas;
    QLabel* name_;
    QComboBox* variable_;
    Canvas* canvas_;
    std::vector<double> residual_, correlation_;  // correlation from lag 0
    std::vector<NamedSeries> against_;
};

}  // namespace analogon::ui
