#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/recordings_model.hpp"
#include "ui/measurement/recordings_page.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {
namespace {

class RecordingsTable : public Panels {
protected:
    void openTable() {
        openLambda();
        QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(page()->isVisible());
        ASSERT_TRUE(QTest::qWaitFor([&] { return view()->hasFocus(); }, 5000));
    }
    RecordingsPage* page() const { return panel<RecordingsPage>(); }
    QTableView* view() const { return page()->view(); }
    QModelIndex cell(int row, int column) const { return view()->model()->index(row, column); }
    QString text(int row, int column) const { return cell(row, column).data().toString(); }
    int rowOf(const QString& name) const {
        for (int row = 0; row < view()->model()->rowCount(); ++row)
            if (text(row, RecordingsModel::Name) == name) return row;
        return -1;
    }
    QPoint at(const QModelIndex& index) const { return view()->visualRect(index).center(); }
    const StudyExperiment& recording(const QString& name) {
        const std::vector<StudyExperiment>& all = document().study().experiments;
        return *std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.name == name.toStdString(); });
    }
    int firstError() const { return RecordingsModel::FirstError; }
    int samples() const { return page()->model()->samplesColumn(); }
    int duration() const { return page()->model()->durationColumn(); }
    int fault() const { return page()->model()->faultColumn(); }
    /// Copies of the first recording, as one step.
    void addCopies(int count, const std::function<void(StudyExperiment&, int)>& edit) {
        StudySettings settings = document().settings();
        for (int i = 0; i < count; ++i) {
            settings.experiments.push_back(settings.experiments.front());
            settings.experiments.back().name = "copy " + std::to_string(i);
            edit(settings.experiments.back(), i);
        }
        document().applySettings(std::move(settings), "copy");
    }
};

TEST_F(RecordingsTable, IsFilteredByTheKeyOfFinding) {
    openTable();
    addCopies(12, [](StudyExperiment&, int) {});
    const int all = view()->model()->rowCount();
    ASSERT_GE(all, 13);
    QTest::keyClick(view(), Qt::Key_F, Qt::ControlModifier);
    ASSERT_TRUE(page()->filterField()->hasFocus());
    QTest::keyClicks(page()->filterField(), "COPY 1");
    EXPECT_EQ(view()->model()->rowCount(), 3) << "1, 10 and 11";
    EXPECT_GE(rowOf("copy 11"), 0);
    for (const std::string& name : page()->marked()) EXPECT_TRUE(name.starts_with("copy 1")) << name;
    page()->filterField()->clear();
    EXPECT_EQ(view()->model()->rowCount(), all);
}

TEST_F(RecordingsTable, SaysOfEachWhatItIsAndWhatTheRunLeaves) {
    openTable();
    ASSERT_EQ(view()->model()->rowCount(), 2);
    EXPECT_EQ(text(0, RecordingsModel::File), "train.csv");
    EXPECT_EQ(text(0, RecordingsModel::Role), "fit");
    EXPECT_EQ(text(1, RecordingsModel::Role), "validate");
    EXPECT_EQ(text(0, RecordingsModel::Weight), "1");
    EXPECT_FALSE(text(0, samples()).isEmpty());
    EXPECT_TRUE(text(0, duration()).endsWith(" s"));
    EXPECT_TRUE(text(0, firstError()).endsWith('%')) << text(0, firstError()).toStdString();
    EXPECT_FALSE(text(0, firstError()).contains("→"));
    run(RunKind::Fit);
    EXPECT_TRUE(text(0, firstError()).contains("→")) << "before and after the fit";
    EXPECT_TRUE(text(1, firstError()).contains("→"));
    window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/recordings-table.png");
}

TEST_F(RecordingsTable, OpensFromThePanelAndIsClosed) {
    openLambda();
    for (auto* button : panel<MeasurementPanel>()->findChildren<QToolButton*>())
        if (button->text() == "Table") QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(page()->isVisible());
    QTest::mouseClick(page()->closeButton(), Qt::LeftButton);
    EXPECT_FALSE(page()->isVisible());
}

TEST_F(RecordingsTable, HiddenDoesNothingAndShownAgainSaysWhatHasChangedOnce) {
    openTable();
    QTest::mouseClick(page()->closeButton(), Qt::LeftButton);
    ASSERT_FALSE(page()->isVisible());
    RecordingsModel* const model = page()->model();
    QSignalSpy resets(model, &QAbstractItemModel::modelReset), changes(model, &QAbstractItemModel::dataChanged);
    addCopies(3, [](StudyExperiment& copy, int i) { copy.range = std::pair(0.0, 1.0 + i); });  // to be measured
    run(RunKind::Simulate);
    QTest::qWait(200);
    EXPECT_TRUE(resets.isEmpty());
    EXPECT_TRUE(changes.isEmpty());
    EXPECT_EQ(model->rowCount(), 2);

    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(page()->isVisible());
    EXPECT_EQ(resets.size(), 1);
    EXPECT_EQ(model->rowCount(), 5);
    EXPECT_TRUE(QTest::qWaitFor([&] { return text(4, duration()) == "3 s"; }, 5000))
        << text(4, duration()).toStdString();
    QTest::qWait(50);
    const auto changed = changes.size();
    QTest::mouseClick(page()->closeButton(), Qt::LeftButton);
    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(page()->isVisible());
    QTest::qWait(100);
    EXPECT_EQ(changes.size(), changed) << "nothing has changed since";
    EXPECT_EQ(resets.size(), 1);
}

TEST_F(RecordingsTable, ThePanelOfMeasurementsMeasuresWhenItIsSeen) {
    openLambda();
    auto* const measurements = panel<MeasurementPanel>();
    const auto extent = [&] { return measurements->tree()->topLevelItem(0)->child(0)->text(0); };
    measurements->hide();
    StudySettings settings = document().settings();
    settings.experiments[0].range = std::pair(0.0, 3.0);
    document().applySettings(std::move(settings), "range");
    QTest::qWait(300);
    EXPECT_FALSE(extent().contains("samples")) << extent().toStdString();
    measurements->show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return extent().endsWith("3 s"); }, 5000)) << extent().toStdString();
}

TEST_F(RecordingsTable, RoleIsChosenInItsCellAndUndoneInOneStep) {
    openTable();
    QTest::mouseDClick(view()->viewport(), Qt::LeftButton, {}, at(cell(1, RecordingsModel::Role)));
    auto* box = view()->viewport()->findChild<QComboBox*>();
    if (!box) {  // the first click makes the cell the current one
        QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, at(cell(1, RecordingsModel::Role)));
        QTest::mouseDClick(view()->viewport(), Qt::LeftButton, {}, at(cell(1, RecordingsModel::Role)));
        box = view()->viewport()->findChild<QComboBox*>();
    }
    ASSERT_TRUE(box);
    const int steps = document().undoStack().count();
    QTest::keyClick(box, Qt::Key_Up);
    QTest::keyClick(box, Qt::Key_Return);
    ASSERT_EQ(text(1, RecordingsModel::Role), "fit");
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    document().undoStack().undo();
    EXPECT_EQ(text(1, RecordingsModel::Role), "validate");
}

TEST_F(RecordingsTable, WeightIsTypedInItsCellAndCountsInTheFit) {
    openTable();
    view()->setCurrentIndex(cell(0, RecordingsModel::Weight));
    QTest::keyClick(view(), Qt::Key_Return);
    auto* field = view()->viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    QTest::keyClicks(field, "2,5");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return text(0, RecordingsModel::Weight) == "2.5"; }, 2000));
    const QString name = text(0, RecordingsModel::Name);
    for (const auto& [output, mapping] : recording(name).outputs) EXPECT_EQ(mapping.weight, 2.5);
    for (const char* wrong : {"-1", "1e9", "much"}) {
        EXPECT_FALSE(RecordingsModel::readWeight(wrong)) << wrong;
        EXPECT_FALSE(view()->model()->setData(cell(0, RecordingsModel::Weight), wrong, Qt::EditRole));
    }
    EXPECT_EQ(text(0, RecordingsModel::Weight), "2.5");
    document().undoStack().undo();
    EXPECT_EQ(text(0, RecordingsModel::Weight), "1");
}

TEST_F(RecordingsTable, SpaceTakesTheMarkedRowsOutAndInAsOneStep) {
    openTable();
    QTest::keyClick(view(), Qt::Key_A, Qt::ControlModifier);
    const int steps = document().undoStack().count();
    QTest::keyClick(view(), Qt::Key_Space);
    EXPECT_FALSE(document().study().experiments[0].isUsed);
    EXPECT_FALSE(document().study().experiments[1].isUsed);
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    EXPECT_EQ(page()->marked().size(), 2u) << "what is marked stays";
    EXPECT_FALSE(page()->fitButton()->isEnabled());
    QTest::keyClick(view(), Qt::Key_Space);
    EXPECT_TRUE(document().study().experiments[0].isUsed);
    EXPECT_TRUE(page()->fitButton()->isEnabled());
}

TEST_F(RecordingsTable, AFitOfTheMarkedLooksAtThemAloneAndLeavesTheStudy) {
    openTable();
    addCopies(1, [](StudyExperiment&, int) {});
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document().before() && document().before()->experiments.size() == 3; }, 20000));
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, {}, at(cell(rowOf("copy 0"), RecordingsModel::File)));
    ASSERT_EQ(page()->marked(), (std::set<std::string>{"copy 0"}));
    ASSERT_TRUE(page()->fitButton()->text().contains("(1)"));
    QTest::mouseClick(page()->fitButton(), Qt::LeftButton);
    EXPECT_FALSE(page()->fitButton()->isEnabled()) << "while it runs";
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
    ASSERT_TRUE(document().result());
    ASSERT_EQ(document().after()->experiments.size(), 1u);
    EXPECT_EQ(document().after()->experiments.front().name, "copy 0");
    EXPECT_FALSE(document().isResultStale());
    for (const StudyExperiment& e : document().study().experiments) EXPECT_TRUE(e.isUsed) << e.name;
    for (const StudyExperiment& e : document().result()->completed.experiments) EXPECT_TRUE(e.isUsed) << e.name;
    EXPECT_TRUE(text(rowOf("copy 0"), firstError()).contains("→"));
    EXPECT_FALSE(text(rowOf("drive cycle"), firstError()).contains("→"));
    EXPECT_TRUE(std::any_of(document().messages().begin(), document().messages().end(), [](const Message& m) {
        return m.diagnostic.message.english().find("only 1 of 3 recordings were looked at: copy 0") == 0;
    }));
}

TEST_F(RecordingsTable, ASearchInTheMarkedIsStartedByKeys) {
    openTable();
    QTest::keyClick(view(), Qt::Key_Tab);
    QWidget* const first = QApplication::focusWidget();
    ASSERT_EQ(first, page()->fitButton());
    QTest::keyClick(first, Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget(), page()->searchButton());
    QTest::keyClick(page()->searchButton(), Qt::Key_Space);
    ASSERT_TRUE(window.controller().isRunning());
    window.controller().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
}

TEST_F(RecordingsTable, AFaultIsSaidWithItsReason) {
    openTable();
    addCopies(1, [](StudyExperiment& copy, int) {
        for (auto& [output, mapping] : copy.outputs) mapping.column = "nowhere";
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return text(rowOf("copy 0"), fault()).contains("nowhere"); }, 20000));
    EXPECT_TRUE(text(0, fault()).isEmpty());
}

TEST_F(RecordingsTable, HoldsTwoHundredRecordingsWithoutAPauseAndSortsThem) {
    openTable();
    addCopies(200, [](StudyExperiment& copy, int i) {
        copy.role = Role::Validate;
        for (auto& [output, mapping] : copy.outputs) mapping.weight = 1 + (i * 37 % 200);
        copy.range = {{0.0, 1.0 + (i % 20) * 0.1}};
    });
    ASSERT_EQ(view()->model()->rowCount(), 202);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !text(100, duration()).isEmpty(); }, 20000));
    const auto sortBy = [&](int column) {
        const int x = view()->horizontalHeader()->sectionViewportPosition(column) + 20;
        QTest::mouseClick(view()->horizontalHeader()->viewport(), Qt::LeftButton, {}, {x, 8});
        view()->viewport()->repaint();
    };
    double sorted = 1e300;
    for (int i = 0; i < 3; ++i) {
        sortBy(RecordingsModel::Role);
        sorted = std::min(sorted, test::leastMilliseconds(1, [&] { sortBy(RecordingsModel::Weight); }));
    }
    for (int row = 1; row < 202; ++row)
        ASSERT_LE(text(row - 1, RecordingsModel::Weight).toDouble(), text(row, RecordingsModel::Weight).toDouble());
    view()->setCurrentIndex(cell(150, RecordingsModel::Weight));
    const double edited = test::leastMilliseconds(5, [&] {  // out, in, …, out
        QTest::keyClick(view(), Qt::Key_Space);
        window.repaint();
    });
    std::printf("sorted in %.1f ms, edited in %.1f ms\n", sorted, edited);
#ifdef __SANITIZE_ADDRESS__
    constexpr double most = 500;
#else
    constexpr double most = 50;
#endif
    EXPECT_LT(sorted, most);
    EXPECT_LT(edited, most);
    EXPECT_EQ(std::count_if(document().study().experiments.begin(), document().study().experiments.end(),
                            [](const StudyExperiment& e) { return !e.isUsed; }),
              1);
}

/// A small screen, both languages, light and dark, with a recording that is left out, one with a fault and one gone.
TEST(RecordingsTablePictures, HaveRoomForEveryWord) {
    const QTemporaryDir copy;
    const QDir example(QStringLiteral(ANALOGON_ROOT "/examples/lambda-sensor-heating"));
    for (const QString& file : example.entryList(QDir::Files)) QFile::copy(example.filePath(file), copy.filePath(file));
    ASSERT_TRUE(QFile::remove(copy.filePath("validation.csv")));
    for (const char* language : {"en", "de"})
        for (const bool isDark : {false, true}) {
            Translator translator;
            if (translator.loadLanguage(language)) QCoreApplication::installTranslator(&translator);
            style::apply(*qApp, isDark ? style::Theme::Dark : style::Theme::Light);
            {
                MainWindow window;
                window.resize(1024, 700);
                window.show();
                window.open(copy.filePath("study.json"));
                ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().before() != nullptr; }, 20000));
                StudySettings settings = window.document().settings();
                for (const char* name : {"cold start in winter", "left out"}) {
                    settings.experiments.push_back(settings.experiments.front());
                    settings.experiments.back().name = name;
                }
                settings.experiments.back().isUsed = false;
                settings.experiments[2].outputs.begin()->second.column = "nowhere";
                window.document().applySettings(settings, "add");
                for (QAction* action : window.findChildren<QAction*>())
                    if (action->shortcut() == QKeySequence(Qt::Key_F8)) action->trigger();
                QTest::qWait(300);
                const QSize before = window.size();
                window.findChild<QAction*>("recordings")->trigger();
                auto* page = window.findChild<RecordingsPage*>();
                ASSERT_TRUE(page->isVisible());
                QTest::qWait(1500);
                for (const QPushButton* button : page->findChildren<QPushButton*>())
                    EXPECT_GE(button->width(), button->sizeHint().width()) << language << button->text().toStdString();
                EXPECT_EQ(window.size(), before) << language;
                window.grab().save(
                    QStringLiteral(ANALOGON_PICTURES "/recordings-%1-%2.png").arg(language, isDark ? "dark" : "light"));
                window.document().undoStack().setClean();
            }
            QCoreApplication::removeTranslator(&translator);
        }
    style::apply(*qApp, style::Theme::Light);
}

}  // namespace
}  // namespace analogon::ui
