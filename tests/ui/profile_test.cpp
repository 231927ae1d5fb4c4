#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "tests/ui/panels_fixture.hpp"
#include "ui/sensitivity/profile_dialog.hpp"
#include "ui/signals/figure_chart.hpp"

namespace analogon::ui {
namespace {

class Profiles : public Panels {
protected:
    ProfileDialog* openDialog() {
        QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
        auto* dialog = window.findChild<ProfileDialog*>();
        EXPECT_TRUE(dialog && QTest::qWaitForWindowExposed(dialog));
        return dialog;
    }
};

TEST_F(Profiles, WaitForAFit) {
    openLambda();
    ProfileDialog* dialog = openDialog();
    EXPECT_FALSE(dialog->runButton()->isEnabled());
    EXPECT_EQ(dialog->outcome()->text(), "Fit the parameters first (F5).");
}

TEST_F(Profiles, ShowHowFarAParameterMayBeFromItsEstimate) {
    openLambda();
    run(RunKind::Fit);
    const std::string before = studyJson(document().study());
    ProfileDialog* dialog = openDialog();
    ASSERT_TRUE(dialog->runButton()->isEnabled());
    dialog->parameterBox()->setCurrentText("heater.R");
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->interval().has_value(); }, 120000))
        << dialog->outcome()->text().toStdString();
    const auto& all = document().result()->finding.final.parameters;
    const auto of = std::find_if(all.begin(), all.end(), [](const FitEstimate& e) { return e.name == "heater.R"; });
    ASSERT_NE(of, all.end());
    EXPECT_LT(dialog->interval()->lower, of->value);
    EXPECT_GT(dialog->interval()->upper, of->value);
    EXPECT_TRUE(dialog->outcome()->text().startsWith("95 % interval of heater.R: from "))
        << dialog->outcome()->text().toStdString();
    const Figure& figure = dialog->chart()->figure();
    ASSERT_EQ(figure.curves.size(), 3u) << "profile, threshold, estimate";
    EXPECT_GE(figure.curves[0].points.size(), 3);
    EXPECT_TRUE(figure.xLabel.startsWith("heater.R"));
    EXPECT_EQ(studyJson(document().study()), before);
    QTest::qWait(100);
    dialog->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/profile.png");
}

TEST_F(Profiles, AreStopped) {
    openLambda();
    run(RunKind::Fit);
    ProfileDialog* dialog = openDialog();
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    EXPECT_EQ(dialog->runButton()->text(), "Stop");
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->runButton()->text() == "Work it out"; }, 60000));
    EXPECT_TRUE(dialog->outcome()->text() == "Stopped." || dialog->interval())
        << dialog->outcome()->text().toStdString();
}

}  // namespace
}  // namespace analogon::ui
