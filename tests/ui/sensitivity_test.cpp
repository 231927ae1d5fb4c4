#include <QAction>
#include <QComboBox>
#include <QGraphicsItem>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

#include "tests/ui/panels_fixture.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/sensitivity/sensitivity_page.hpp"
#include "ui/signals/signal_chart.hpp"

namespace analogon::ui {
namespace {

class SensitivityPages : public Panels {
protected:
    SensitivityPage* page() const { return window.findChild<SensitivityPage*>(); }
    void openPage() {
        openLambda();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().parameters.empty(); }, 20000));
        QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(page());
        ASSERT_TRUE(QTest::qWaitFor([&] { return page()->shown() != nullptr; }, 20000));
    }
    static double largest(const ChartLine& line) {
        double most = 0;
        for (std::size_t i = 0; i < line.data->values.size(); ++i)
            most = std::max(most, std::abs(line.data->values[i]));
        return most;
    }
};

TEST_F(SensitivityPages, ShowTheMatrixAndOneCurveAParameterAndFollowTheStudy) {
    openPage();
    const auto count = static_cast<int>(page()->shown()->parameters.size());
    ASSERT_EQ(page()->matrix()->rowCount(), count);
    ASSERT_EQ(page()->matrix()->columnCount(), count + 1);
    EXPECT_EQ(page()->matrix()->item(0, 1)->text(), "1.00");
    EXPECT_EQ(page()->matrix()->item(0, 2)->text(), page()->matrix()->item(1, 1)->text());
    EXPECT_TRUE(page()->matrix()->item(0, 0)->text().endsWith("%"));
    EXPECT_TRUE(page()->caption()->text().startsWith("At the present values."));
    ASSERT_EQ(page()->chart()->lines().size(), static_cast<std::size_t>(count));
    EXPECT_EQ(page()->traceBox()->currentText(), "warm-up · i_mod");
    const ChartLine first = page()->chart()->lines()[0];
    EXPECT_EQ(first.data->unit, "A");
    const double relative = largest(first);
    EXPECT_GT(relative, 0);
    page()->measureBox()->setFocus();
    QTest::keyClick(page()->measureBox(), Qt::Key_Down);
    EXPECT_NEAR(largest(page()->chart()->lines()[0]) / relative,
                page()->shown()->standardErrors[0] / std::abs(page()->shown()->values[0]), 1e-6);
    StudyParameter setting = document().study().parameters.at("heater.alpha");
    setting.fit = false;
    document().setStudyParameter("heater.alpha", setting, "hold");
    EXPECT_TRUE(QTest::qWaitFor([&] { return page()->matrix()->rowCount() == count - 1; }, 20000));
    run(RunKind::Fit);
    EXPECT_TRUE(QTest::qWaitFor([&] { return page()->caption()->text().startsWith("At the fitted values."); }, 20000));
}

/// A legend that takes more rows leaves less height: the axes follow, and their figures stay in sight.
TEST_F(SensitivityPages, KeepTheFiguresOfTheAxesInSightUnderALongLegend) {
    openPage();
    window.resize(1024, 700);
    QTest::qWait(100);
    auto* legend = page()->legend();
    const QString text = legend->text();
    const int before = page()->chart()->height();
    for (int times = 2; times < 5; ++times) {
        legend->setText(QStringList(times, text).join(" &nbsp; "));
        QTest::qWait(100);
        const SignalChart& chart = *page()->chart();
        for (const QGraphicsItem* item : chart.scene()->items())
            EXPECT_TRUE(!item->isVisible() || item->sceneBoundingRect().bottom() <= chart.height()) << item->type();
    }
    EXPECT_LT(page()->chart()->height(), before);
}

TEST_F(SensitivityPages, LeadToAParameterByEnterAndCloseByAButton) {
    openPage();
    page()->matrix()->setCurrentCell(1, 2);
    page()->matrix()->setFocus();
    QTest::keyClick(page()->matrix(), Qt::Key_Return);
    auto* parameters = window.findChild<ParameterPanel*>();
    EXPECT_EQ(parameters->table()->currentIndex().siblingAtColumn(0).data().toString().toStdString(),
              page()->shown()->parameters[1]);
    QTest::mouseClick(page()->closeButton(), Qt::LeftButton);
    EXPECT_LT(window.findChild<QTabWidget*>("centre")->indexOf(page()), 0);
}

TEST_F(SensitivityPages, SayWhatIsInTheWay) {
    openPage();
    StudySettings settings = document().settings();
    for (auto& [name, parameter] : settings.parameters) parameter.fit = false;
    document().applySettings(std::move(settings), "hold all");
    EXPECT_TRUE(QTest::qWaitFor([&] { return page()->caption()->text() == "no parameter is fitted"; }, 20000))
        << page()->caption()->text().toStdString();
    EXPECT_EQ(page()->matrix()->rowCount(), 0);
    EXPECT_TRUE(page()->chart()->lines().empty());
}

/// For those who look after the layout.
TEST_F(SensitivityPages, FitIntoTheRoomOfASmallWindow) {
    openPage();
    window.resize(1024, 700);
    QTest::qWait(300);
    EXPECT_GT(page()->chart()->height(), 60);
    EXPECT_GT(page()->matrix()->height(), 60);
}

}  // namespace
}  // namespace analogon::ui
