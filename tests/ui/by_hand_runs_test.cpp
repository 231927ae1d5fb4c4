#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDrag>
#include <QDragEnterEvent>
#include <QLabel>
#include <QListWidget>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QWheelEvent>

#include "core/study/run.hpp"
#include "tests/ui/by_hand_fixture.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/library/chooser.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/recordings_model.hpp"
#include "ui/measurement/recordings_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/plot/time_plot.hpp"
#include "ui/sensitivity/profile_dialog.hpp"
#include "ui/signals/figure_chart.hpp"

/// Runs and what they leave, by the mouse and the keys.
namespace analogon::ui {
namespace {

class RunsByHand : public ByHand {
protected:
    /// The row of the list whose signal has that name.
    QModelIndex rowOf(const QString& name) const {
        const QAbstractItemModel& model = *list()->model();
        for (int g = 0; g < model.rowCount(); ++g)
            for (int i = 0; i < model.rowCount(model.index(g, 0)); ++i)
                if (const QModelIndex row = model.index(i, 0, model.index(g, 0)); row.data().toString() == name)
                    return row;
        return {};
    }
    /// Pressed on a row of the list, led over the window and let go over a panel. What the list hands to the desktop
    /// when the drag begins is brought to the window as the desktop does it: without one no drag goes any further.
    void dragSignal(const QString& recording, const QString& name, QWidget* onto) {
        seek(recording + ' ' + name);
        const QModelIndex row = rowOf(name);
        ASSERT_TRUE(row.isValid()) << name.toStdString();
        list()->scrollTo(row);
        const QPoint from = list()->visualRect(row).center();
        const auto mouse = [&](QEvent::Type type, QPoint at) {
            QWidget* rows = list()->viewport();
            const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
            QMouseEvent event(type, at, rows->mapToGlobal(QPointF(at)), button, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(rows, &event);
        };
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, from + QPoint(8, 4));
        EXPECT_FALSE(list()->findChild<QDrag*>()) << "a hand that trembles drags nothing";
        mouse(QEvent::MouseMove, from + QPoint(40, 10));
        const auto* drag = list()->findChild<QDrag*>();
        ASSERT_TRUE(drag && drag->mimeData());
        const QPoint to = onto->mapTo(&window, onto->rect().center());
        QDragEnterEvent enter(to, Qt::CopyAction, drag->mimeData(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.windowHandle(), &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDragMoveEvent move(to, Qt::CopyAction, drag->mimeData(), Qt::LeftButton, Qt::NoModifier);
        move.accept();  // as who let it enter has said
        QCoreApplication::sendEvent(window.windowHandle(), &move);
        ASSERT_TRUE(move.isAccepted());
        QDropEvent drop(to, Qt::CopyAction, drag->mimeData(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.windowHandle(), &drop);
        EXPECT_TRUE(drop.isAccepted());
        QTest::qWait(20);
    }
    void fit() {
        activate();
        QTest::keyClick(&window, Qt::Key_F5);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().result() != nullptr; }, 120000));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
        QTest::qWait(50);
    }
    /// Over all that is written in the text view.
    void paste(const QString& text) {
        activate();
        showText();
        QTest::mouseClick(panel<TextView>()->viewport(), Qt::LeftButton);
        QApplication::clipboard()->setText(text);
        QTest::keyClick(panel<TextView>(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(panel<TextView>(), Qt::Key_V, Qt::ControlModifier);
    }
};

TEST_F(RunsByHand, ASignalIsDraggedFromTheListIntoTheEmptyPlotsAndOntoAnAxis) {
    openSignals();
    const StudyExperiment& experiment = document().study().experiments.front();
    const QString output = QString::fromStdString(experiment.outputs.begin()->second.column);
    dragSignal(QString::fromStdString(experiment.name), output, &plots());
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0); }, 5000)) << plots().strips().size();
    EXPECT_EQ(plots().layout().axes[0].traces[0].name, output);
    EXPECT_EQ(plots().layout().axes[0].traces[0].recording.toStdString(), experiment.name);
    dragSignal(QString::fromStdString(experiment.name), "T_exhaust", plots().strips()[0]);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isShown(0, 1); }, 5000)) << "onto the same axis";
    EXPECT_EQ(plots().strips().size(), 1u);
    EXPECT_EQ(plots().layout().axes[0].traces[1].name, "T_exhaust");
}

TEST_F(RunsByHand, AModelIsSimulatedOverTheTimeOfItsAnnotationAndOfTheClassThatItExtends) {
    newStudy();
    const QString equations =
        "  Real x(start=1, fixed=true);\n  output Real y;\nequation\n  der(x) = -x;\n  y = x;\n"
        "  annotation (experiment(StopTime=3));\n";
    paste("model Model\n" + equations + "end Model;\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().facts().outputs.size() == 1; }, 10000));
    simulate();
    ASSERT_TRUE(document().after());
    EXPECT_DOUBLE_EQ(document().after()->experiments.front().time.back(), 3);
    const Eigen::VectorXd& y = document().after()->experiments.front().outputs.front().simulated;
    EXPECT_NEAR(y[y.size() - 1], std::exp(-3), 1e-4);

    paste("model Decay\n" + QString(equations).replace("StopTime=3", "StopTime=7") +
          "end Decay;\nmodel Model\n  extends Decay;\nend Model;\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().facts().outputs.size() == 1; }, 10000));
    simulate();
    EXPECT_DOUBLE_EQ(document().after()->experiments.front().time.back(), 7);
    document().undoStack().setClean();
}

TEST_F(RunsByHand, AFitGoesOnBesideARecordingWithAFaultWhichIsMarkedInBothLists) {
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study);
    StudyExperiment faulty = study->experiments.front();
    faulty.name = "broken";
    faulty.role = Role::Validate;
    for (auto& [output, mapping] : faulty.outputs) mapping.column = "nowhere";
    study->experiments.push_back(faulty);
    const QString file = directory.filePath("broken.analogon");
    ASSERT_TRUE(saveStudy(*study, file.toStdString()));
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    const auto marked = [&](const QString& name) {
        const auto rows = measurements()->findItems(name, Qt::MatchExactly);
        return rows.size() == 1 && rows.front()->toolTip(0).contains("nowhere");
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return marked("broken"); }, 10000));
    fit();
    EXPECT_EQ(document().after()->experiments.size(), 2u) << "the others go on";
    EXPECT_TRUE(marked("broken"));
    for (std::size_t i = 0; i + 1 < study->experiments.size(); ++i)
        EXPECT_FALSE(marked(QString::fromStdString(study->experiments[i].name)));
    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    const auto* page = panel<RecordingsPage>();
    ASSERT_TRUE(page->isVisible());
    const QAbstractItemModel& table = *page->view()->model();
    for (int row = 0; row < table.rowCount(); ++row) {
        const bool isBroken = table.index(row, RecordingsModel::Name).data().toString() == "broken";
        const QString fault = table.index(row, page->model()->faultColumn()).data().toString();
        EXPECT_EQ(fault.contains("nowhere"), isBroken) << fault.toStdString();
        const QString error = table.index(row, RecordingsModel::FirstError).data().toString();
        EXPECT_EQ(error.contains("→"), !isBroken) << error.toStdString();
    }
}

TEST_F(RunsByHand, AProfileShowsThatItIsAtWorkIsStoppedAndWorkedOut) {
    openLambda();
    fit();
    QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    auto* dialog = window.findChild<ProfileDialog*>();
    ASSERT_TRUE(dialog && QTest::qWaitForWindowExposed(dialog));
    auto* progress = dialog->findChild<QProgressBar*>();
    ASSERT_TRUE(progress);
    EXPECT_FALSE(progress->isVisible());
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    EXPECT_TRUE(progress->isVisible()) << "it is at work";
    EXPECT_FALSE(dialog->parameterBox()->isEnabled());
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !progress->isVisible(); }, 20000));
    EXPECT_EQ(dialog->outcome()->text(), "Stopped.");
    EXPECT_FALSE(dialog->interval());

    QComboBox* box = dialog->parameterBox();
    ASSERT_TRUE(box->isEnabled() && box->count() > 1);
    QTest::mouseClick(box, Qt::LeftButton);  // opens the list
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_EQ(box->currentIndex(), 1);
    QTest::mouseClick(dialog->runButton(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->interval().has_value(); }, 120000));
    EXPECT_FALSE(progress->isVisible());
    EXPECT_TRUE(dialog->outcome()->text().contains(box->currentText())) << dialog->outcome()->text().toStdString();
    EXPECT_EQ(dialog->chart()->figure().curves.size(), 3u);
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.findChild<ProfileDialog*>() == nullptr; }, 5000));
}

/// Whatever the residual was before, what is left of it after the fit is seen in all of its height.
TEST_F(RunsByHand, TheResidualIsScaledToWhatIsLeftAfterAndToWhatIsShown) {
    openLambda();
    raise({"traces"});
    const OutputPlot* plot = panel<PlotPanel>()->plots()[0];
    TimePlot* residual = plot->residual();
    ASSERT_TRUE(residual->isVisible());
    const auto height = [&] {
        QTest::qWait(50);
        return residual->valueRange().second - residual->valueRange().first;
    };
    const double before = height();
    fit();
    const double after = height();
    EXPECT_LT(after, 0.8 * before) << "what was left before is no matter any more";
    QAbstractButton* entry = nullptr;
    for (QAbstractButton* button : plot->findChildren<QAbstractButton*>())
        if (button->isVisible() && button->text() == plot->legendText(TraceRole::After)) entry = button;
    ASSERT_TRUE(entry);
    QTest::mouseClick(entry, Qt::LeftButton);
    EXPECT_NEAR(height(), before, 1e-9 * before) << "the other one alone";
    QTest::mouseClick(entry, Qt::LeftButton);
    EXPECT_NEAR(height(), after, 1e-9 * after);
    const QPointF at(residual->width() * 0.8, residual->height() / 2.0);
    QWheelEvent turn(at, residual->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase,
                     false);
    QCoreApplication::sendEvent(residual, &turn);
    EXPECT_LT(height(), 0.9 * after) << "looked at closely by the wheel";
    QTest::mouseDClick(residual, Qt::LeftButton, {}, at.toPoint());
    EXPECT_NEAR(height(), after, 1e-9 * after) << "all of it again";
}

/// With a recording and one block, as a new user has them: the window says what is missing, and the keys lead there.
TEST_F(ByHand, ARecordingAndABlockAreLedToEachOther) {
    newStudy();
    QFile file(directory.filePath("bench.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("Zeit;Spannung;Strom;Drehzahl\r\ns;V;A;1/min\r\n");
    for (int i = 0; i < 40; ++i) file.write(QStringLiteral("0,%1;6,1;0,4;%2\r\n").arg(10 + i).arg(30 * i).toLatin1());
    file.close();
    QTest::keyClick(&window, Qt::Key_I, Qt::ControlModifier);
    name(window.findChild<QFileDialog*>("import-dialog"), file.fileName());
    auto* accept = panel<ImportPanel>()->acceptButton();
    ASSERT_TRUE(QTest::qWaitFor([&] { return accept->isVisible() && accept->isEnabled(); }, 10000));
    QTest::mouseClick(accept, Qt::LeftButton);
    ASSERT_EQ(document().study().experiments.size(), 1u);
    place("Analogon.ElectricMechanical.BasicElectricMechanical", {-40, 10});
    place("Analogon.Mechanics.Inertia", {40, 10});
    ASSERT_EQ(document().diagram().blocks.size(), 2u);
    const std::string motor = document().diagram().blocks[0].name, inertia = document().diagram().blocks[1].name;
    wire((motor + ".flange").c_str(), (inertia + ".flange_a").c_str());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().modelError() != nullptr; }, 10000));

    const auto says = [&](const QString& words) {
        for (const QLabel* label : panel<PlotPanel>()->findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    };
    raise({"traces"});
    EXPECT_TRUE(QTest::qWaitFor([&] { return says("The model is not finished"); }, 10000));
    EXPECT_FALSE(says("no measurement can be read")) << "it is read, and not at fault";
    const auto propose = [&] {
        for (QToolButton* button : panel<MeasurementPanel>()->findChildren<QToolButton*>())
            if (button->text() == "Propose mapping") QTest::mouseClick(button, Qt::LeftButton);
        return window.statusBar()->currentMessage().toStdString();
    };
    const int steps = document().undoStack().count();
    EXPECT_THAT(propose(), testing::HasSubstr("RealInput")) << "what it waits for";
    EXPECT_EQ(document().undoStack().count(), steps) << "nothing that undo could take back";

    auto* view = panel<DiagramView>();
    const auto connect = [&](int from, const char* to) {
        activate();  // the dialog had it
        view->setFocus();
        for (int i = 0; i < 5 && panel<DiagramScene>()->selectedBlock().toStdString() != motor; ++i)
            QTest::keyClick(view, Qt::Key_Tab);
        QTest::keyClick(view, Qt::Key_W);
        auto* chooser = view->findChild<Chooser*>();
        ASSERT_TRUE(chooser->isVisible());
        for (int i = 0; i < from; ++i) QTest::keyClick(chooser->field(), Qt::Key_Down);
        QTest::keyClick(chooser->field(), Qt::Key_Return);
        const auto* choices = chooser->findChild<QListWidget*>();
        ASSERT_GT(choices->count(), 0);
        EXPECT_EQ(choices->item(0)->text().toStdString(), to);
        QTest::keyClick(chooser->field(), Qt::Key_Return);
        QTest::qWait(20);
    };
    connect(0, "a new input of the model");
    connect(1, "a new output of the model");
    ASSERT_EQ(document().diagram().wires.size(), 3u) << document().modelText().toStdString();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().facts().outputs.size() == 1; }, 10000));
    propose();
    const StudyExperiment& experiment = document().study().experiments.front();
    EXPECT_EQ(experiment.inputs.size(), 1u);
    EXPECT_EQ(experiment.outputs.begin()->second.column, "Strom");
    EXPECT_THAT(propose(), testing::HasSubstr("has its column already"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().before() != nullptr; }, 20000)) << "the traces";
    document().undoStack().setClean();
}

/// A search goes on with other models: what is drawn meanwhile is the fit of the one that is given, and is called so.
TEST_F(ByHand, TracesWatchedDuringASearchAreNotCalledItsBest) {
    openLambda();
    activate();
    QTest::keyClick(&window, Qt::Key_F6);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().liveTraces() != nullptr; }, 60000));
    const QString label = panel<PlotPanel>()->plots().front()->legendText(TraceRole::After);
    EXPECT_TRUE(label.startsWith("fitted as given")) << label.toStdString();
    window.controller().cancel();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 20000));
}

}  // namespace
}  // namespace analogon::ui
