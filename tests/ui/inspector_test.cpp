#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QTest>
#include <QTreeWidget>

#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/inspector/prior_text.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {
namespace {

TEST(PriorText, IsReadAsEngineersTypeIt) {
    const NormalPrior known{3.2, 0.1};
    for (const char* typed : {"3.2 ± 0.1", "3.2±0.1", "3,2 +- 0,1", "3.2 +/- 0.1", "3.2; 0.1", " 3.2  0.1 "})
        EXPECT_EQ(readPrior(QString::fromUtf8(typed)), known) << typed;
    EXPECT_EQ(readPrior("-2e-3 +- 1e-4"), (NormalPrior{-2e-3, 1e-4}));
    for (const char* wrong : {"", "3.2", "3.2 ± 0", "3.2 ± -0.1", "3.2 ± x", "1 2 3", "nan ± 1", "1 ± inf"})
        EXPECT_FALSE(readPrior(QString::fromUtf8(wrong))) << wrong;
    EXPECT_EQ(priorText(known, 4), QString::fromUtf8("3.2 ± 0.1"));
}

class Inspector : public testing::Test {
protected:
    void SetUp() override {
        window.resize(1440, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.open(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
        ASSERT_TRUE(QTest::qWaitFor([&] { return model()->rowOf("heater.R") >= 0; }, 5000));
    }
    ~Inspector() override { QTest::qWait(1); }

    Document& document() { return window.document(); }
    ParameterModel* model() { return window.findChild<ParameterPanel*>()->model(); }
    QModelIndex at(const char* parameter, int column) { return model()->index(model()->rowOf(parameter), column); }
    /// Opens the editor of a cell and types, as a user does.
    void type(QAbstractItemView* view, const QModelIndex& index, const QString& text) {
        view->setCurrentIndex(index);
        view->edit(index);
        auto* editor = view->findChild<QLineEdit*>();
        ASSERT_TRUE(editor);
        editor->selectAll();
        QWidget* keys = qobject_cast<QComboBox*>(editor->parent()) ? editor->parentWidget() : editor;
        QTest::keyClicks(keys, text);
        QTest::keyClick(keys, Qt::Key_Return);
        QTest::qWait(10);
    }
    /// What the context menu of a row offers.
    void choose(QAbstractItemView* view, const QModelIndex& row, const QString& action) {
        Q_EMIT view->customContextMenuRequested(view->visualRect(row).center());
        for (QMenu* menu : window.findChildren<QMenu*>())
            for (QAction* each : menu->actions())
                if (menu->isVisible() && each->text() == action) {
                    each->trigger();
                    menu->close();
                    return;
                }
        FAIL() << qPrintable(action);
    }
    /// The field of a channel's clock.
    void typeClock(const char* signal, const QString& text) {
        auto* measurements = window.findChild<MeasurementPanel*>();
        QTreeWidgetItem* item =
            measurements->signalItem(QString::fromStdString(document().study().experiments.front().name), signal);
        ASSERT_TRUE(item);
        QTreeWidget* tree = measurements->tree();
        if (tree->isColumnHidden(2)) choose(tree, tree->indexFromItem(item, 0), "Set the clock …");
        type(tree, tree->indexFromItem(item, 2), text);
    }
    const ChannelMapping& output() { return document().study().experiments.front().outputs.at("i_mod"); }

    MainWindow window;
};

TEST_F(Inspector, TakesWhatIsKnownOfAParameterInTheUnitThatIsShown) {
    QTableView* table = window.findChild<ParameterPanel*>()->table();
    const std::string original = studyJson(document().study());
    ASSERT_TRUE(model()->setData(at("heater.R", ParameterModel::Unit), "mOhm", Qt::EditRole));
    EXPECT_TRUE(table->isColumnHidden(ParameterModel::Prior)) << "nothing is known: the names need the room";
    choose(table, at("heater.R", 0), "Give a prior …");
    ASSERT_FALSE(table->isColumnHidden(ParameterModel::Prior));
    type(table, at("heater.R", ParameterModel::Prior), "3200 +- 100");
    ASSERT_TRUE(document().study().parameters.at("heater.R").prior);
    EXPECT_DOUBLE_EQ(document().study().parameters.at("heater.R").prior->mean, 3.2);
    EXPECT_DOUBLE_EQ(document().study().parameters.at("heater.R").prior->deviation, 0.1);
    EXPECT_EQ(at("heater.R", ParameterModel::Prior).data().toString(), QString::fromUtf8("3200 ± 100"));
    const std::string known = studyJson(document().study());
    const Outcome<Study> read = parseStudyJson(std::make_shared<Source>("study.json", known));
    ASSERT_TRUE(read);
    EXPECT_EQ(studyJson(*read), known) << "byte for byte";
    type(table, at("heater.R", ParameterModel::Prior), "3200 +- 0");
    EXPECT_EQ(studyJson(document().study()), known) << "what is no deviation changes nothing";
    type(table, at("heater.R", ParameterModel::Prior), " ");
    EXPECT_EQ(studyJson(document().study()), original) << "an empty field: nothing is known";
    document().undoStack().undo();
    EXPECT_EQ(studyJson(document().study()), known);
    document().undoStack().undo();
    EXPECT_EQ(studyJson(document().study()), original);
    EXPECT_FALSE(document().undoStack().canUndo());
}

TEST_F(Inspector, KeepsEveryDigitOfABoundWhoseEditorWasOnlyOpened) {
    StudyParameter setting = document().study().parameters.at("heater.R");
    setting.min = 0.123456789;
    document().setStudyParameter("heater.R", setting, "bound");
    const int steps = document().undoStack().count();
    const QModelIndex min = at("heater.R", ParameterModel::Min);
    EXPECT_FALSE(model()->setData(min, min.data(Qt::EditRole), Qt::EditRole));
    EXPECT_EQ(document().study().parameters.at("heater.R").min, 0.123456789);
    EXPECT_EQ(document().undoStack().count(), steps);
}

TEST_F(Inspector, ShowsAValueAtItsBoundFromAfar) {
    StudyParameter setting = document().study().parameters.at("heater.R");
    setting.min = 2.9;
    document().setStudyParameter("heater.R", setting, "bound");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().before() != nullptr; }, 20000));
    window.controller().start(RunKind::Fit);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 60000));
    QTableView* table = window.findChild<ParameterPanel*>()->table();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return at("heater.R", ParameterModel::Bounds).data(ParameterModel::AtBoundRole).toBool(); }, 5000));
    table->clearSelection();
    const QRect cell = table->visualRect(at("heater.R", ParameterModel::Bounds));
    const QImage picture = table->viewport()->grab(cell).toImage();
    const QColor wanted = style::caution(table->palette());
    int seen = 0;  // [px]
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) seen += picture.pixelColor(x, y) == wanted ? 1 : 0;
    EXPECT_GE(seen, 60);
}

TEST_F(Inspector, SaysWhereToLookWhileTheModelHasAnError) {
    auto* panel = window.findChild<ParameterPanel*>();
    QString broken = document().modelText();
    document().typeText(broken.replace("connect(heater.i", "connect(heater.current"));
    const auto says = [&](const char* word) {
        for (const QLabel* label : panel->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(word)) return true;
        return false;
    };
    EXPECT_TRUE(QTest::qWaitFor([&] { return says("error"); }, 5000));
    document().undoStack().setClean();
}

TEST_F(Inspector, AFieldOfASmallWindowSaysWholeWhatItIsFor) {
    window.resize(853, 480);
    QTest::qWait(20);
    const auto* field = window.findChild<ParameterPanel*>()->findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    EXPECT_GT(field->width(), field->fontMetrics().horizontalAdvance(field->placeholderText()) + 4 * style::unit);
}

TEST_F(Inspector, TakesTheClockOfALoggerAndListsWhatTheFitFinds) {
    // The logger of the output stamps everything three samples late.
    StudySettings settings = document().settings();
    const StudyExperiment& experiment = settings.experiments.front();
    Table late = *settings.tables.at(experiment.file);
    Column* column = nullptr;
    double step = 0;
    for (Column& c : late.columns) {
        if (c.name == experiment.outputs.at("i_mod").column) column = &c;
        if (c.name == experiment.timeColumn) step = c.values[1] - c.values[0];
    }
    ASSERT_TRUE(column);
    std::rotate(column->values.begin(), column->values.end() - 3, column->values.end());
    for (std::size_t i = 0; i < 3; ++i) column->values[i] = column->values[3];
    settings.tables[experiment.file] = std::make_shared<const Table>(std::move(late));
    document().applySettings(std::move(settings), "late");
    const std::string original = studyJson(document().study());

    typeClock("ctrl_var", "-2,5 ms");
    EXPECT_DOUBLE_EQ(document().study().experiments.front().inputs.at("ctrl_var").clock, -0.0025);
    document().undoStack().undo();
    typeClock("i_mod", "soon");
    EXPECT_EQ(studyJson(document().study()), original) << "what is no time changes nothing";
    typeClock("i_mod", "fit");
    EXPECT_TRUE(output().fitsClock);
    const Outcome<Study> read = parseStudyJson(std::make_shared<Source>("study.json", studyJson(document().study())));
    ASSERT_TRUE(read);
    EXPECT_EQ(studyJson(*read), studyJson(document().study())) << "byte for byte";

    ASSERT_GE(model()->rowOf("clock i_mod"), 0) << "what the fit looks for is listed";
    ASSERT_TRUE(model()->setData(at("clock i_mod", ParameterModel::Value), "0.001", Qt::EditRole));
    EXPECT_EQ(document().study().parameters.at("clock i_mod").value, 0.001);
    EXPECT_EQ(at("clock i_mod", ParameterModel::Name).data(Qt::CheckStateRole).toInt(), Qt::Checked);
    window.controller().start(RunKind::Fit);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
    QTest::qWait(20);
    ASSERT_TRUE(document().after());
    const QStringList found =
        at("clock i_mod", ParameterModel::Result).data().toString().split(QString::fromUtf8(" ± "));
    ASSERT_EQ(found.size(), 2) << "a value with its standard error";
    EXPECT_NEAR(found[0].toDouble(), 3 * step, 0.5 * step);
    EXPECT_GT(found[1].toDouble(), 0);
    EXPECT_LT(found[1].toDouble(), step);

    ASSERT_TRUE(model()->setData(at("heater.R", ParameterModel::Prior), "3 +- 0.5", Qt::EditRole));
    QTest::qWait(30);
    QDir(QStringLiteral(ANALOGON_PICTURES)).mkpath(".");
    window.grab().save(QDir(QStringLiteral(ANALOGON_PICTURES)).filePath("prior-and-clock.png"));

    typeClock("i_mod", "0.25");
    EXPECT_FALSE(output().fitsClock);
    EXPECT_EQ(output().clock, 0.25);
    EXPECT_FALSE(document().study().parameters.contains("clock i_mod")) << "its settings go with the wish for it";
    EXPECT_TRUE(estimationTask(document().study()));
    while (document().undoStack().index() > 1) document().undoStack().undo();
    EXPECT_EQ(studyJson(document().study()), original);
}

TEST_F(Inspector, TakesAnInputAsHeldFromItsMenu) {
    auto* measurements = window.findChild<MeasurementPanel*>();
    const auto input = [&]() -> const ChannelMapping& {
        return document().study().experiments.front().inputs.at("ctrl_var");
    };
    const auto chooseOfInput = [&](const QString& action) {
        QTreeWidget* tree = measurements->tree();
        QTreeWidgetItem* item =
            measurements->signalItem(QString::fromStdString(document().study().experiments.front().name), "ctrl_var");
        ASSERT_TRUE(item);
        choose(tree, tree->indexFromItem(item, 0), action);
    };
    const std::string original = studyJson(document().study());
    chooseOfInput("Straight between its samples");
    EXPECT_EQ(studyJson(document().study()), original) << "what it is already changes nothing";
    chooseOfInput("Held between its samples");
    EXPECT_EQ(input().interpolation, Interpolation::Hold);
    EXPECT_NE(studyJson(document().study()).find("\"interpolation\": \"hold\""), std::string::npos);
    const QTreeWidgetItem* item =
        measurements->signalItem(QString::fromStdString(document().study().experiments.front().name), "ctrl_var");
    EXPECT_TRUE(item->text(1).endsWith("held")) << item->text(1).toStdString();
    const Outcome<EstimationTask> task = estimationTask(document().study());
    ASSERT_TRUE(task);
    EXPECT_TRUE(task->recordings.front().isHeld("ctrl_var"));
    document().undoStack().undo();
    EXPECT_EQ(studyJson(document().study()), original);
}

TEST_F(Inspector, TheClockOfAnOutputIsRenamedWithIt) {
    typeClock("i_mod", "fit");
    ASSERT_TRUE(model()->setData(at("clock i_mod", ParameterModel::Max), "0.5", Qt::EditRole));
    ASSERT_TRUE(window.compose().composer().rename("i_mod", "i_heater"));
    EXPECT_FALSE(document().study().parameters.contains("clock i_mod"));
    EXPECT_EQ(document().study().parameters.at("clock i_heater").max, 0.5);
    EXPECT_TRUE(estimationTask(document().study()));
}

}  // namespace
}  // namespace analogon::ui
