#include <QTreeWidget>

#include "panels_fixture.hpp"
#include "ui/measurement/measurement_panel.hpp"

namespace analogon::ui {
namespace {

class LeftOut : public Panels {
protected:
    /// Another recording of the study's own file, of which one output is taken from a column that is not there.
    void addFaulty() {
        StudySettings settings = document().settings();
        StudyExperiment faulty = settings.experiments.front();
        faulty.name = "faulty";
        faulty.role = Role::Validate;
        for (auto& [output, mapping] : faulty.outputs) mapping.column = "nowhere";
        settings.experiments.push_back(faulty);
        document().applySettings(settings, "add");
    }
    QTreeWidgetItem* row(const QString& name) {
        const auto found = panel<MeasurementPanel>()->tree()->findItems(name, Qt::MatchExactly);
        return found.isEmpty() ? nullptr : found.front();
    }
    bool isMarked(const QString& name) { return row(name) && row(name)->toolTip(0).contains("nowhere"); }
};

TEST_F(LeftOut, ARecordingWithAFaultIsMarkedAndTheOthersAreFitted) {
    openLambda();
    const std::size_t sound = document().study().experiments.size();
    addFaulty();
    ASSERT_TRUE(QTest::qWaitFor([&] { return isMarked("faulty") && document().before(); }, 20000));
    EXPECT_EQ(document().before()->experiments.size(), sound);
    EXPECT_FALSE(isMarked(QString::fromStdString(document().study().experiments.front().name)));
    QTest::keyClick(&window, Qt::Key_F5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().result() != nullptr; }, 120000));
    EXPECT_EQ(document().after()->experiments.size(), sound);
    EXPECT_EQ(document().result()->completed.experiments.size(), sound + 1);
    EXPECT_TRUE(isMarked("faulty"));
    for (const Message& message : document().messages()) EXPECT_NE(message.diagnostic.severity, Severity::Error);
    window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/left-out.png");
}

TEST_F(LeftOut, TheMarkAndTheMessageGoWithTheirCause) {
    openLambda();
    addFaulty();
    ASSERT_TRUE(QTest::qWaitFor([&] { return isMarked("faulty"); }, 20000));
    EXPECT_FALSE(document().messages().empty());
    StudySettings settings = document().settings();
    settings.experiments.back().outputs = settings.experiments.front().outputs;
    document().applySettings(settings, "mend");
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            return row("faulty") && !isMarked("faulty") && document().before() &&
                   document().before()->experiments.size() == settings.experiments.size();
        },
        20000));
    for (const Message& message : document().messages())
        EXPECT_FALSE(QString::fromStdString(format(message.diagnostic)).contains("nowhere"));
}

}  // namespace
}  // namespace analogon::ui
