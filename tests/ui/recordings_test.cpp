#include <QFile>
#include <QFileDialog>
#include <QStyleOptionViewItem>
#include <QTreeWidget>
#include <algorithm>

#include "tests/ui/panels_fixture.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {
namespace {

class RecordingsInTheWindow : public Panels {
protected:
    QString studyPlace() { return directory.filePath("study"); }
    QString inStudy(const QString& file) { return studyPlace() + "/" + file; }
    /// A copy of an example in a directory.
    void copyExample() {
        QDir().mkpath(studyPlace());
        for (const QString& file : QDir(example("")).entryList(QDir::Files))
            ASSERT_TRUE(QFile::copy(example(file), inStudy(file)));
    }
    void openStudyPlace() {
        window.open(inStudy("study.json"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && tree()->topLevelItemCount() == 2; }, 30000));
    }
    QTreeWidget* tree() const { return panel<MeasurementPanel>()->tree(); }
    QTreeWidgetItem* row(int recording, const QString& beginning) const {
        QTreeWidgetItem* top = tree()->topLevelItem(recording);
        for (int i = 0; i < top->childCount(); ++i)
            if (top->child(i)->text(0).startsWith(beginning)) return top->child(i);
        return nullptr;
    }
    /// A click on the mark in front of a recording.
    void clickMark(int recording) {
        const QRect row = tree()->visualItemRect(tree()->topLevelItem(recording));
        QStyleOptionViewItem option;
        option.initFrom(tree());
        option.rect = row;
        option.features = QStyleOptionViewItem::HasCheckIndicator;
        const QRect mark = tree()->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, tree());
        QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, mark.center());
    }
    bool tells(const QString& part) {
        return std::any_of(document().messages().begin(), document().messages().end(),
                           [&](const Message& m) { return inWords(m.diagnostic.message).contains(part); });
    }
};

}  // namespace

TEST_F(RecordingsInTheWindow, AreLeftOutAndTakenInByTheirMark) {
    openLambda();
    ASSERT_EQ(tree()->topLevelItemCount(), 2);
    clickMark(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().study().experiments[1].isUsed; }, 5000));
    EXPECT_EQ(tree()->topLevelItem(1)->checkState(0), Qt::Unchecked);
    const auto isSimulated = [&](std::size_t recordings) {
        return QTest::qWaitFor(
            [&] { return document().before() && document().before()->experiments.size() == recordings; }, 20000);
    };
    ASSERT_TRUE(isSimulated(1));
    run(RunKind::Fit);
    ASSERT_TRUE(document().result());
    EXPECT_EQ(document().result()->finding.final.experiments.size(), 1u);
    document().undoStack().undo();
    EXPECT_EQ(tree()->topLevelItem(1)->checkState(0), Qt::Checked);
    ASSERT_TRUE(isSimulated(2));
    tree()->setFocus();
    tree()->setCurrentItem(tree()->topLevelItem(0));
    QTest::keyClick(tree(), Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !document().study().experiments[0].isUsed; }, 5000)) << "by keys";
}

TEST_F(RecordingsInTheWindow, KeepTheirRowsWhereAnotherIsEdited) {
    openLambda();
    StudySettings settings = document().settings();
    for (const char* name : {"cold", "hot"}) {
        settings.experiments.push_back(settings.experiments.front());
        settings.experiments.back().name = name;
        settings.experiments.back().range = {{0.0, 2.0}};
    }
    document().applySettings(settings, "copy");
    ASSERT_EQ(tree()->topLevelItemCount(), 4);
    const auto extent = [&](int recording) { return tree()->topLevelItem(recording)->child(0)->text(0); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return extent(3).endsWith("2 s"); }, 5000)) << extent(3).toStdString();
    const std::vector<QTreeWidgetItem*> rows{tree()->topLevelItem(0), tree()->topLevelItem(1), tree()->topLevelItem(3)};
    const std::string output = settings.experiments[2].outputs.begin()->first;
    tree()->setCurrentItem(row(2, QString::fromStdString(output)));

    settings.experiments[2].outputs.begin()->second.weight = 2;
    settings.experiments[2].range = {{0.0, 1.0}};
    document().applySettings(settings, "edit");
    ASSERT_TRUE(QTest::qWaitFor([&] { return extent(2).endsWith("1 s"); }, 5000)) << extent(2).toStdString();
    EXPECT_EQ(rows, (std::vector<QTreeWidgetItem*>{tree()->topLevelItem(0), tree()->topLevelItem(1),
                                                   tree()->topLevelItem(3)}));
    EXPECT_EQ(extent(3).count("samples"), 1) << extent(3).toStdString();
    EXPECT_TRUE(tree()->topLevelItem(2)->isExpanded());
    EXPECT_EQ(tree()->currentItem(), row(2, QString::fromStdString(output))) << "where one was";

    tree()->topLevelItem(2)->setExpanded(false);
    settings.experiments[2].range = {{0.0, 1.5}};
    document().applySettings(settings, "edit");
    ASSERT_TRUE(QTest::qWaitFor([&] { return extent(2).endsWith("1.5 s"); }, 5000)) << extent(2).toStdString();
    EXPECT_FALSE(tree()->topLevelItem(2)->isExpanded());

    settings.experiments.erase(settings.experiments.begin() + 1);
    document().applySettings(settings, "remove");
    ASSERT_EQ(tree()->topLevelItemCount(), 3);
    EXPECT_EQ(tree()->topLevelItem(0), rows[0]);
    EXPECT_EQ(tree()->topLevelItem(2), rows[2]);
    document().undoStack().undo();
    ASSERT_EQ(tree()->topLevelItemCount(), 4);
    EXPECT_EQ(tree()->topLevelItem(1)->text(0), "drive cycle");
}

TEST_F(RecordingsInTheWindow, OneThatIsMissingIsLocated) {
    copyExample();
    ASSERT_TRUE(QFile::rename(inStudy("validation.csv"), directory.filePath("elsewhere.csv")));
    openStudyPlace();
    ASSERT_TRUE(isUnread(document(), "drive cycle"));
    QTreeWidgetItem* const fault = row(1, inWords(document().study().unread.begin()->second.front().message));
    ASSERT_TRUE(fault);
    tree()->scrollToItem(fault);
    const QPoint at = tree()->visualItemRect(fault).center();
    QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(tree()->viewport(), Qt::LeftButton, {}, at);
    auto* dialog = panel<QFileDialog>("locate-dialog");
    ASSERT_TRUE(dialog);
    Q_EMIT dialog->fileSelected(directory.filePath("elsewhere.csv"));
    dialog->close();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document().before() && document().before()->experiments.size() == 2; }, 20000));
    EXPECT_FALSE(isUnread(document(), "drive cycle"));
    EXPECT_FALSE(tells("there is no file"));
    document().undoStack().undo();
    EXPECT_TRUE(isUnread(document(), "drive cycle")) << "as one step";
}

TEST_F(RecordingsInTheWindow, OneThatIsMissingIsLeftOutAndTheOtherWorkedWith) {
    copyExample();
    ASSERT_TRUE(QFile::remove(inStudy("validation.csv")));
    openStudyPlace();
    ASSERT_TRUE(QTest::qWaitFor([&] { return tells("there is no file"); }, 20000));
    clickMark(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().study().experiments[1].isUsed; }, 2000));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document().before() && document().before()->experiments.size() == 1; }, 20000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !tells("there is no file"); }, 20000));
    run(RunKind::Fit);
    ASSERT_TRUE(document().result());
    EXPECT_FALSE(document().result()->completed.experiments[1].isUsed) << "the study keeps the choice";
}

TEST_F(RecordingsInTheWindow, AreSavedAndReopenedWithoutTheMissingOne) {
    copyExample();
    ASSERT_TRUE(QFile::remove(inStudy("validation.csv")));
    openStudyPlace();
    const QString file = directory.filePath("kept.analogon");
    document().save(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isSaving(); }, 20000));
    ASSERT_TRUE(QFile::exists(file)) << format(document().messages().front().diagnostic);
    const Outcome<OpenedStudy> kept = openStudy(file.toStdString(), UnreadMeasurement::Kept);
    ASSERT_TRUE(kept) << format(kept.diagnostics());
    EXPECT_EQ(kept->study.experiments.size(), 2u);
    EXPECT_FALSE(openStudy(file.toStdString())) << "a command does not work with a study that lacks a recording";
}

TEST_F(RecordingsInTheWindow, AMessageOfAFailedRunGoesWhenItsCauseIsGone) {
    openLambda();
    StudySettings changed = document().settings();
    for (StudyExperiment& e : changed.experiments) e.inputs.begin()->second.column = "nothing_of_this_name";
    document().applySettings(changed, "Spoil");
    run(RunKind::Fit);
    ASSERT_TRUE(tells("nothing_of_this_name"));
    document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !tells("nothing_of_this_name"); }, 20000));
}

}  // namespace analogon::ui
