#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QLineSeries>
#include <QPushButton>
#include <QSpinBox>
#include <QUndoStack>
#include <cmath>
#include <ctime>

#include "tests/ui/panels_fixture.hpp"
#include "ui/sensitivity/sweep_chart.hpp"
#include "ui/sensitivity/sweep_dialog.hpp"
#include "ui/signals/log_axis.hpp"

namespace analogon::ui {
namespace {

class Sweeps : public Panels {
protected:
    SweepDialog* dialog() const { return window.findChild<SweepDialog*>(); }
    void openDialog() {
        openLambda();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().parameters.empty(); }, 20000));
        QTest::keyClick(&window, Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(dialog());
        ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog()));
    }
    void set(int axis, const char* parameter, const char* from, const char* to, int count) const {
        const SweepDialog::Axis& own = dialog()->axis(axis);
        own.parameter->setCurrentText(parameter);
        for (auto [field, typed] : {std::pair{own.from, from}, {own.to, to}}) {
            field->selectAll();
            QTest::keyClicks(field, typed);
        }
        own.count->setValue(count);
        own.byFactors->setChecked(false);
    }
    bool run() const {
        QTest::mouseClick(dialog()->runButton(), Qt::LeftButton);
        return QTest::qWaitFor([&] { return dialog()->runButton()->text() == "Simulate"; }, 30000);
    }
    /// But for rounding.
    static bool isAlike(const QColor& a, const QColor& b) {
        return std::abs(a.red() - b.red()) < 3 && std::abs(a.green() - b.green()) < 3 &&
               std::abs(a.blue() - b.blue()) < 3;
    }
    static void picture(QWidget* of, const char* name) {
        QTest::qWait(100);
        if (const QString to = qEnvironmentVariable("ANALOGON_SWEEP_PICTURES"); !to.isEmpty())
            of->grab().save(to + "/" + name + ".png");
    }
};

TEST_F(Sweeps, ShowTheErrorOverOneParameterAsACurveWithItsLeast) {
    openDialog();
    EXPECT_EQ(dialog()->axis(0).parameter->currentText(), "heater.R") << "what is fitted comes first";
    EXPECT_FALSE(dialog()->axis(1).from->isEnabled()) << "no second one yet";
    const std::string before = studyJson(document().study());
    set(0, "heater.R", "2", "4", 5);
    ASSERT_TRUE(run());
    ASSERT_TRUE(dialog()->sweep());
    EXPECT_EQ(dialog()->sweep()->axes[0].values, (std::vector<double>{2, 2.5, 3, 3.5, 4}));
    const auto series = dialog()->chart()->chart()->series();
    ASSERT_EQ(series.size(), 2) << "curve and mark";
    auto* curve = qobject_cast<QLineSeries*>(series[0]);
    ASSERT_TRUE(curve);
    ASSERT_EQ(curve->count(), 5);
    EXPECT_EQ(curve->at(3).y(), dialog()->sweep()->errorPercent(0, 3));
    EXPECT_TRUE(dialog()->outcome()->text().startsWith("Least error ")) << qPrintable(dialog()->outcome()->text());
    EXPECT_TRUE(dialog()->outcome()->text().contains("heater.R = "));
    EXPECT_EQ(studyJson(document().study()), before);
    picture(dialog(), "curve");
}

TEST_F(Sweeps, ShowTheErrorOverTwoParametersAsAMap) {
    openDialog();
    set(0, "heater.R", "2", "4", 7);
    set(1, "heater.alpha", "0.001", "0.005", 5);
    ASSERT_TRUE(run());
    ASSERT_TRUE(dialog()->sweep());
    const ParameterSweep& swept = *dialog()->sweep();
    ASSERT_EQ(swept.errorPercent.rows(), 5);
    ASSERT_EQ(swept.errorPercent.cols(), 7);
    QTest::qWait(100);
    const QImage seen = dialog()->chart()->grab().toImage();
    Eigen::Index row{}, column{};
    swept.errorPercent.maxCoeff(&row, &column);
    const auto colourAt = [&](Eigen::Index r, Eigen::Index c) {
        return seen.pixelColor(dialog()->chart()->placeOf(r, c));
    };
    EXPECT_TRUE(isAlike(colourAt(row, column), dialog()->chart()->colourOf(swept.errorPercent(row, column))));
    const auto [least, at] = swept.least();
    EXPECT_TRUE(isAlike(colourAt(least, at), dialog()->chart()->colourOf(swept.errorPercent(least, at))));
    EXPECT_FALSE(isAlike(colourAt(least, at), colourAt(row, column)));
    EXPECT_GT(dialog()->chart()->placeOf(0, 0).y(), dialog()->chart()->placeOf(4, 0).y()) << "upwards";
    picture(dialog(), "map");
    EXPECT_TRUE(dialog()->outcome()->text().contains("the smaller the error."));
    set(1, "heater.R", "2", "4", 5);
    EXPECT_FALSE(dialog()->runButton()->isEnabled()) << "the same twice";
}

TEST_F(Sweeps, SetTheParametersByAClickOnTheMapAsOneStep) {
    openDialog();
    set(0, "heater.R", "2", "4", 7);
    set(1, "heater.alpha", "0.001", "0.005", 5);
    ASSERT_TRUE(run());
    SweepChart* chart = dialog()->chart();
    const QString text = document().modelText();
    const auto value = [&](const char* name) { return document().parameterValue(name).value_or(0); };
    const double before = value("heater.R");
    const int steps = document().undoStack().index();
    QTest::mouseClick(chart->viewport(), Qt::LeftButton, {}, chart->placeOf(3, 5));
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(value("heater.R") - (2 + 5 / 3.0)) < 1e-9; }, 10000));
    EXPECT_NEAR(value("heater.alpha"), 0.004, 1e-12);
    EXPECT_TRUE(dialog()->outcome()->text().startsWith("Set: heater.R = 3.667"))
        << qPrintable(dialog()->outcome()->text());
    ASSERT_TRUE(dialog()->sweep()) << "the map stays";
    picture(dialog(), "map-set");
    QTest::keyClick(dialog(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().undoStack().index(), steps);
    EXPECT_EQ(document().modelText(), text);
    ASSERT_TRUE(QTest::qWaitFor([&] { return value("heater.R") == before; }, 10000));
}

TEST_F(Sweeps, SetTheParameterByAClickOnTheCurveOrByTheKeys) {
    openDialog();
    set(0, "heater.R", "2", "4", 5);
    ASSERT_TRUE(run());
    SweepChart* chart = dialog()->chart();
    const auto isSet = [&](double wanted) {
        return QTest::qWaitFor(
            [&] { return std::abs(document().parameterValue("heater.R").value_or(0) - wanted) < 1e-9; }, 10000);
    };
    QTest::mouseClick(chart->viewport(), Qt::LeftButton, {}, chart->placeOf(0, 1) + QPoint(3, 20));
    EXPECT_TRUE(isSet(2.5)) << "the nearest value";
    picture(dialog(), "curve-set");
    chart->setFocus();
    const int steps = document().undoStack().index();
    QTest::keyClick(chart, Qt::Key_Right);
    QTest::keyClick(chart, Qt::Key_Right);
    EXPECT_EQ(document().undoStack().index(), steps) << "nothing is set on the way";
    EXPECT_TRUE(dialog()->outcome()->text().startsWith("heater.R = 3.5")) << qPrintable(dialog()->outcome()->text());
    QTest::keyClick(chart, Qt::Key_Return);
    EXPECT_TRUE(isSet(3.5));
    EXPECT_EQ(document().undoStack().index(), steps + 1);
}

TEST(SweepMap, OfManyCellsIsDrawnAtOnceWithRoundValuesInsideADecade) {
    constexpr int size = 200;
    ParameterSweep swept{{{"k", sweepValues(0.3, 3, size, true)}, {"R", sweepValues(0.02, 40, size, true)}},
                         {"N.m/A", "Ohm"},
                         Eigen::MatrixXd::Random(size, size).array() + 2,
                         size * size};
    SweepChart chart;
    chart.resize(520, 420);
    chart.setSweep(std::move(swept));
    static_cast<QWidget&>(chart).show();
    QTest::qWait(50);
    const std::clock_t begin = std::clock();
    const QImage seen = chart.grab().toImage();
    EXPECT_LT(1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 400)
        << "[ms] cells are many, and each asks for its colour";
    seen.save(QStringLiteral(ANALOGON_PICTURES) + "/sweep-map.png");
    const auto axes = chart.chart()->axes();
    for (QAbstractAxis* axis : axes) {
        auto* log = qobject_cast<LogAxis*>(axis);
        ASSERT_TRUE(log);
        EXPECT_GE(log->categoriesLabels().size(), 3);
    }
    EXPECT_EQ(qobject_cast<LogAxis*>(axes[0])->categoriesLabels().front(), "0.3");
}

TEST_F(Sweeps, AreStoppedAndShowWhatTheyHave) {
    openDialog();
    set(0, "heater.R", "2", "4", 200);
    set(1, "heater.alpha", "0.001", "0.005", 200);
    QTest::mouseClick(dialog()->runButton(), Qt::LeftButton);
    EXPECT_EQ(dialog()->runButton()->text(), "Stop");
    QTest::qWait(300);
    ASSERT_EQ(dialog()->runButton()->text(), "Stop") << "40 000 simulations take longer";
    ASSERT_TRUE(run());
    ASSERT_TRUE(dialog()->sweep());
    EXPECT_GT(dialog()->sweep()->done, 0);
    EXPECT_LT(dialog()->sweep()->done, 40000);
    EXPECT_TRUE(dialog()->outcome()->text().startsWith("Stopped after ")) << qPrintable(dialog()->outcome()->text());
}

TEST_F(Sweeps, WaitForNumbers) {
    openDialog();
    for (const auto& [from, to] : {std::pair{"", "4"}, {"2", "x"}, {"3", "3"}}) {
        dialog()->axis(0).from->setText(from);
        dialog()->axis(0).to->setText(to);
        EXPECT_FALSE(dialog()->runButton()->isEnabled()) << from << " to " << to;
    }
    dialog()->axis(0).to->setText("5");
    EXPECT_TRUE(dialog()->runButton()->isEnabled());
}

}  // namespace
}  // namespace analogon::ui
