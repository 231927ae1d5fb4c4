#include <QAbstractItemView>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTableView>
#include <QTreeView>
#include <QTreeWidget>
#include <QWheelEvent>

#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/chooser.hpp"
#include "ui/library/library_model.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/plot/residual_plot.hpp"
#include "ui/style/translator.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/recovered_line.hpp"

/// Small faults that were met in the window, each where several panels take part.
namespace analogon::ui {
namespace {

class Met : public Panels {
protected:
    QPoint centreOf(const std::string& block) const {
        const auto* view = panel<DiagramView>();
        return view->mapFromScene(panel<DiagramScene>()->block(block)->body().center());
    }
    void doubleClick(const std::string& block) {
        QWidget* at = panel<DiagramView>()->viewport();
        QTest::mouseClick(at, Qt::LeftButton, {}, centreOf(block));
        QTest::mouseDClick(at, Qt::LeftButton, {}, centreOf(block));
        QTest::mouseRelease(at, Qt::LeftButton, {}, centreOf(block));
    }
    /// A motor with the values of the library, over a recording of the pump.
    void drawMotor() {
        window.open(QStringLiteral(ANALOGON_ROOT "/examples/water-pump"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
        StudySettings settings = document().settings();
        settings.parameters.clear();
        settings.experiments.resize(1);
        settings.experiments[0].outputs = {{"i", settings.experiments[0].outputs.at("i_mot")},
                                           {"w", settings.experiments[0].outputs.at("w_pump")}};
        settings.experiments[0].inputs = {{"u", settings.experiments[0].inputs.at("v_cmd")}};
        document().applySettings(settings, "as it begins");
        document().typeText(
            "model WaterPump\n  Analogon.Interfaces.RealInput u(unit=\"V\");\n  Analogon.Interfaces.RealOutput "
            "i(unit=\"A\");\n"
            "  Analogon.Interfaces.RealOutput w(unit=\"rad/s\");\n"
            "  Analogon.ElectricMechanical.BasicElectricMechanical motor;\n  Analogon.Mechanics.Inertia inertia;\n"
            "  Analogon.Mechanics.ViscousLoad load;\n  Analogon.Sensors.SpeedSensor speed;\nequation\n"
            "  connect(u, motor.v);\n  connect(motor.i, i);\n  connect(motor.flange, inertia.flange_a);\n"
            "  connect(inertia.flange_b, load.flange);\n  connect(inertia.flange_b, speed.flange);\n"
            "  connect(speed.w, w);\nend WaterPump;\n");
        ASSERT_TRUE(QTest::qWaitFor(
            [&] { return panel<ParameterPanel>()->model()->rowOf("inertia.J") >= 0 && document().before(); }, 20000));
    }
    QString chosenClass() const {
        return panel<LibraryPanel>()->tree()->currentIndex().data(LibraryModel::ClassNameRole).toString();
    }
};

TEST_F(Met, ADoubleClickOnABlockWithoutParametersTellsWhatItIsAndMarksNoOther) {
    openLambda();
    QTableView* table = panel<ParameterPanel>()->table();
    table->setCurrentIndex({});
    panel<LibraryPanel>()->search()->setText("resistor");  // which hides what is to be read
    doubleClick("i_mod");
    EXPECT_FALSE(table->currentIndex().isValid()) << "a parameter of another block";
    EXPECT_EQ(chosenClass(), "Analogon.Interfaces.RealOutput");
    EXPECT_TRUE(panel<LibraryPanel>()->search()->text().isEmpty());
    EXPECT_EQ(panel<DiagramScene>()->selectedBlock(), "i_mod");
    doubleClick("heater");
    EXPECT_TRUE(table->currentIndex().isValid());
    EXPECT_TRUE(table->currentIndex().siblingAtColumn(0).data().toString().contains("heater"));
    EXPECT_EQ(chosenClass(), "Analogon.Interfaces.RealOutput") << "parameters are what is asked for";
}

TEST_F(Met, EnterOnABlockWithoutParametersDoesTheSame) {
    openLambda();
    QTableView* table = panel<ParameterPanel>()->table();
    table->setCurrentIndex({});
    panel<DiagramScene>()->select("i_mod");
    panel<DiagramView>()->setFocus();
    QTest::keyClick(panel<DiagramView>(), Qt::Key_Return);
    EXPECT_FALSE(table->currentIndex().isValid());
    EXPECT_EQ(chosenClass(), "Analogon.Interfaces.RealOutput");
}

TEST_F(Met, ThePaletteOfConnectorsBeginsWithWhatIsLikeliestMeant) {
    window.startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    const auto place = [](int x, int y) {
        return "annotation (Placement(transformation(extent={{" + std::to_string(x) + "," + std::to_string(y) + "},{" +
               std::to_string(x + 20) + "," + std::to_string(y + 20) + "}})))";
    };
    document().typeText(QString::fromStdString(
        "model Model\n  Analogon.ElectricMechanical.BasicElectricMechanical motor " + place(-40, 0) +
        ";\n  Analogon.Mechanics.Inertia far " + place(200, 0) + ";\n  Analogon.Mechanics.Inertia near " +
        place(20, 0) + ";\n  Analogon.Mechanics.Inertia taken " + place(-20, 40) +
        ";\n  Analogon.Mechanics.ViscousLoad load " + place(0, 60) + ";\n  Analogon.Interfaces.RealOutput y " +
        place(100, 60) + ";\nequation\n  connect(taken.flange_a, load.flange);\nend Model;\n"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel<DiagramScene>()->block("y") != nullptr; }, 20000));
    auto* chooser = panel<DiagramView>()->findChild<Chooser*>();
    const auto offered = [&](const std::string& from) {
        panel<DiagramScene>()->select(from);
        panel<DiagramView>()->setFocus();
        QTest::keyClick(panel<DiagramView>(), Qt::Key_W);
        return chooser->findChild<QListWidget*>();
    };
    const auto choose = [&](QListWidget* list, const QString& which) {
        for (int row = 0; row < list->count(); ++row)
            if (list->item(row)->text() == which) return list->setCurrentRow(row);
        FAIL() << which.toStdString();
    };
    QListWidget* list = offered("motor");
    choose(list, "motor.flange");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    ASSERT_GT(list->count(), 4);
    EXPECT_EQ(list->item(0)->text(), "near.flange_a") << "free, and the nearest";
    QStringList order;
    for (int row = 0; row < list->count(); ++row) order << list->item(row)->text();
    EXPECT_LT(order.indexOf("far.flange_a"), order.indexOf("taken.flange_a")) << "what is connected comes later";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    list = offered("motor");
    choose(list, "motor.i");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    ASSERT_GT(list->count(), 0);
    EXPECT_EQ(list->item(0)->text(), "y") << "not an input of the motor itself";
}

TEST_F(Met, TheWheelOverWhatWasTriedPreviewsTheRowThatComesUnderThePointer) {
    window.resize(1100, 620);
    openLambda();
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Heat radiation", "element.solid", "port", "epsilon");
    for (int i = 0; i < 30; ++i) result.finding.candidates.push_back(result.finding.candidates[2]);
    document().setResult(RunKind::Discover, std::move(result), document().study());
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->candidates() != nullptr; }, 5000));
    window.findChild<QDockWidget*>("result")->raise();
    QTest::qWait(50);
    QTreeWidget* list = results->candidates();
    results->verticalScrollBar()->setValue(list->y() - 20);
    QTest::qWait(20);
    const QTreeWidgetItem* under = list->topLevelItem(2);
    const QPoint at = list->visualItemRect(under).center(), onScreen = list->viewport()->mapToGlobal(at);
    QCursor::setPos(onScreen);
    QTest::mouseMove(list->viewport(), at);
    QTest::qWait(20);
    ASSERT_TRUE(list->viewport()->underMouse());
    QString looked;
    QObject::connect(results, &ResultPanel::effectLookedAt, results,
                     [&](const EffectChoice&, const QString& name) { looked = name; });
    int left = 0;
    QObject::connect(results, &ResultPanel::placePointedAt, results, [&] { ++left; });
    const QScrollBar* scroll = results->verticalScrollBar();
    const int before = scroll->value(), step = before == scroll->maximum() ? 120 : -120;
    // the list leaves it to the panel that it stands in
    QWheelEvent turn(results->viewport()->mapFromGlobal(QPointF(onScreen)), onScreen, {}, QPoint(0, step), Qt::NoButton,
                     {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(results->viewport(), &turn);
    QTest::qWait(20);
    ASSERT_NE(scroll->value(), before) << "the panel scrolls";
    const QTreeWidgetItem* now = list->itemAt(list->viewport()->mapFromGlobal(onScreen));
    ASSERT_TRUE(now && now != under);
    EXPECT_GT(left, 0);
    EXPECT_EQ(looked, now->text(0)) << "not of the row that went from under it";
    document().undoStack().setClean();
}

/// A fit that ended where the model cannot be simulated.
RunResult failedFit(const Document& document) {
    RunResult result = sampleFinding(document, "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Heat radiation", "element.solid", "port", "epsilon");
    result.finding.effects.clear();
    result.finding.final.status = FitStatus::Failed;
    result.finding.final.message = phrase("{}; the best until then is kept: {}", "it failed",
                                          phrase("{} went from {:.4g} to {:.4g}", "heater.R", 2.5, 1e-9));
    return result;
}

TEST_F(Met, AFitThatFailsShowsItsBestSaysWhatWentWhereAndOffersNothingToWrite) {
    openLambda();
    RunResult result = failedFit(document());
    const double best = result.finding.final.experiments.front().errorPercent;
    document().setResult(RunKind::Fit, result, document().study());
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->headline() == "Fit did not converge"; }, 5000));
    EXPECT_FALSE(results->findChild<QPushButton*>("adopt")) << "values on the way to a failure";
    const QString said = findingWords(result.finding, RunKind::Fit).sentence;
    EXPECT_TRUE(said.contains("heater.R went from 2.5 to 1e-09")) << said.toStdString();
    ASSERT_TRUE(document().after());
    EXPECT_EQ(document().after()->experiments.front().errorPercent, best) << "the best is there to be seen";
    result.finding.final.status = FitStatus::Converged;
    document().setResult(RunKind::Fit, result, document().study());
    EXPECT_TRUE(QTest::qWaitFor([&] { return results->findChild<QPushButton*>("adopt") != nullptr; }, 5000));
    document().undoStack().setClean();
}

/// As a user puts it together, without a bound: the parameters are those of the library.
TEST_F(Met, AMotorOfTheLibraryIsFittedFromItsDefaults) {
    ASSERT_NO_FATAL_FAILURE(drawMotor());
    QTableView* table = panel<ParameterPanel>()->table();
    for (const char* name : {"motor.R", "motor.L", "motor.k", "inertia.J", "load.b"}) {
        ASSERT_GE(panel<ParameterPanel>()->model()->rowOf(name), 0) << name;
        table->setCurrentIndex(table->model()->index(panel<ParameterPanel>()->model()->rowOf(name), 0));
        QTest::keyClick(table, Qt::Key_Space);
    }
    ASSERT_EQ(document().study().parameters.size(), 5u);
    QTest::keyClick(&window, Qt::Key_F5);
    ASSERT_TRUE(window.controller().isRunning());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
    ASSERT_TRUE(document().finding());
    const ModelState& fitted = document().finding()->final;
    EXPECT_EQ(fitted.status, FitStatus::Converged) << fitted.message.english();
    for (const FitEstimate& e : fitted.parameters) EXPECT_GT(e.value, 0) << e.name << " is a positive quantity";
    EXPECT_LT(fitted.experiments.front().errorPercent, 1.5);
    EXPECT_FALSE(panel<ResultPanel>()->headline().contains("did not converge"));
    document().undoStack().setClean();
}

/// With values that nobody has told an effect would make up for every one of them.
TEST_F(Met, ASearchOverTheValuesOfTheLibraryAsksForTheParametersFirst) {
    ASSERT_NO_FATAL_FAILURE(drawMotor());
    QTest::keyClick(&window, Qt::Key_F6);
    EXPECT_FALSE(window.controller().isRunning());
    EXPECT_TRUE(window.statusBar()->currentMessage().startsWith("All values are those of the library yet"))
        << qPrintable(window.statusBar()->currentMessage());
    EXPECT_TRUE(panel<ParameterPanel>()->table()->hasFocus());
    // values that are known are told, and nothing need be fitted
    ParameterModel* parameters = panel<ParameterPanel>()->model();
    EXPECT_TRUE(parameters->setData(parameters->index(parameters->rowOf("motor.R"), ParameterModel::Value), "2.4",
                                    Qt::EditRole));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return document().modelText().contains("R=2.4") && document().before(); }, 20000));
    QTest::keyClick(&window, Qt::Key_F6);
    EXPECT_TRUE(window.controller().isRunning());
    window.controller().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 60000));
    document().undoStack().setClean();
}

/// Three scroll areas stood in one another: the wheel turned whichever happened to be under it.
TEST_F(Met, TheListsOfRunsStandInNoOtherScrollArea) {
    openLambda();
    auto* runs = panel<FitPanel>();
    for (QWidget* list : {static_cast<QWidget*>(runs->history()), static_cast<QWidget*>(runs->comparison())})
        for (QWidget* around = list->parentWidget(); around && !around->isWindow(); around = around->parentWidget())
            EXPECT_FALSE(qobject_cast<QAbstractScrollArea*>(around))
                << list->accessibleName().toStdString() << " in " << around->metaObject()->className();
    for (const QScrollArea* area : runs->findChildren<QScrollArea*>())
        for (const QAbstractItemView* list : area->findChildren<QAbstractItemView*>())
            EXPECT_NE(list->window(), runs->window()) << "only what a box drops down stands in one";
}

TEST(MetMenu, TheLanguageThatIsShownIsTickedWhoeverAskedForIt) {
    for (const auto& [code, name] : {std::pair{"en", "English"}, std::pair{"de", "Deutsch"}}) {
        Translator translator;
        if (translator.loadLanguage(code)) QCoreApplication::installTranslator(&translator);
        {
            MainWindow window;
            QStringList ticked;
            for (const QAction* action : window.findChildren<QAction*>())
                if ((action->text() == "English" || action->text() == "Deutsch") && action->isChecked())
                    ticked << action->text();
            EXPECT_EQ(ticked, QStringList{name});
        }
        QCoreApplication::removeTranslator(&translator);
    }
}

TEST_F(Met, AValueAtABoundThatIsDeclaredOrTheSearchsOwnSaysAtWhichEndItIs) {
    openLambda();
    StudySettings settings = document().settings();
    for (auto& [name, setting] : settings.parameters) setting.min = setting.max = std::nullopt;
    document().applySettings(settings, "no bounds");
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Heat radiation", "element.solid", "port", "epsilon");
    result.finding.effects.clear();
    const auto shownWith = [&](double factor) {
        for (FitEstimate& e : result.finding.final.parameters) {
            e.atBound = true;
            e.value = factor * *document().parameterValue(e.name);
        }
        document().setResult(RunKind::Fit, result, document().study());
        const auto* model = panel<ParameterPanel>()->model();
        return model->index(model->rowOf("heater.R"), ParameterModel::Result).data().toString();
    };
    EXPECT_TRUE(shownWith(0).contains("at min")) << shownWith(0).toStdString();
    EXPECT_TRUE(shownWith(1e4).contains("at max")) << shownWith(1e4).toStdString();
    document().undoStack().setClean();
}

TEST_F(Met, AHintStandsOnALineOfItsOwnBelowItsMessage) {
    openLambda();
    document().setRunMessages({fileError(Text("the first sentence"), "m.csv", 3, 0, Text("What to do."))});
    QTest::qWait(20);
    QStringList texts;
    for (const QListWidget* list : panel<MessagePanel>()->findChildren<QListWidget*>())
        for (int row = 0; row < list->count(); ++row) texts << list->item(row)->text();
    EXPECT_TRUE(texts.filter("the first sentence\nWhat to do.").size() == 1) << texts.join(" | ").toStdString();
}

TEST_F(Met, RecoveredWorkIsCalledByItsFolderAndFileAndItsLibraryIsThereThoughItsTextHasAFault) {
    const QString place = directory.filePath("pump-bench");
    QDir().mkpath(place);
    const QString copy = abandonedCopy("pump-bench/study.json");
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study);
    study->models.at(study->modelFile) = "model Lambda\n  Analogon.Mechanics.Inertia body(\nend Lambda;\n";
    QFile::remove(copy);
    ASSERT_TRUE(saveStudy(*study, copy.toStdString()));
    MainWindow fresh;
    fresh.resize(1440, 900);
    fresh.show();
    QTest::qWait(100);
    QStringList entries;
    QPushButton* open = nullptr;
    for (RecoveredLine* line : fresh.findChildren<RecoveredLine*>()) {
        for (const QLabel* label : line->findChildren<QLabel*>()) entries << label->text();
        for (QPushButton* button : line->findChildren<QPushButton*>())
            if (button->text() == "Open") open = button;
    }
    EXPECT_EQ(entries.filter("pump-bench/study.json").size(), 1) << entries.join(" | ").toStdString();
    ASSERT_TRUE(open);
    QTest::mouseClick(open, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return fresh.document().isOpen(); }, 20000));
    EXPECT_FALSE(fresh.windowTitle().contains(QString::number(QCoreApplication::applicationPid())));
    EXPECT_TRUE(fresh.windowTitle().contains("pump-bench") || fresh.windowTitle().contains("study"))
        << fresh.windowTitle().toStdString();
    EXPECT_GT(fresh.findChild<LibraryPanel*>()->tree()->model()->rowCount(), 5) << "blocks are there to mend it with";
    fresh.document().undoStack().setClean();
}

TEST(ResidualFacts, ScaleTheirCorrelationsByWhatIsToBeTold) {
    std::vector<double> noise(4000), drift(4000);
    unsigned state = 1;
    for (std::size_t i = 0; i < noise.size(); ++i) {
        state = state * 1664525u + 1013904223u;
        noise[i] = static_cast<double>(state >> 8) / (1 << 24) - 0.5;
        drift[i] = std::sin(2e-3 * static_cast<double>(i));
    }
    const ResidualFacts white = residualFacts(noise, {}), coloured = residualFacts(drift, {});
    EXPECT_GT(white.correlationBound() / white.correlationReach(), 0.2) << "the bound is seen, not a line on the axis";
    EXPECT_LE(coloured.correlationReach(), 1);
    for (std::size_t k = 1; k < coloured.correlation.size(); ++k)
        EXPECT_LE(std::abs(coloured.correlation[k]), coloured.correlationReach()) << k;
    EXPECT_GT(coloured.correlationReach(), 0.9);
}

TEST(LibraryInGerman, NamesItsPackagesAndSaysBesideEachBlockWhatItIs) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    QCoreApplication::installTranslator(&german);
    {
        Document document;
        LibraryPanel panel(document);
        document.startNew("x");
        panel.resize(520, 500);
        panel.show();
        ASSERT_TRUE(QTest::qWaitFor([&] { return panel.tree()->model()->rowCount() > 5; }, 20000));
        QStringList packages;
        for (int row = 0; row < panel.tree()->model()->rowCount(); ++row)
            packages << panel.tree()->model()->index(row, 0).data().toString();
        for (const char* name : {"Quellen", "Effekte", "Wärme", "Signale"})
            EXPECT_TRUE(packages.contains(QString::fromUtf8(name))) << name;
        EXPECT_FALSE(packages.contains("Sources"));
        ASSERT_TRUE(panel.read("Analogon.Mechanics.Inertia"));
        const QModelIndex block = panel.tree()->currentIndex();
        EXPECT_EQ(block.data().toString(), "Inertia") << "as the text of the model has it";
        const QString about = block.data(LibraryModel::AboutRole).toString();
        EXPECT_FALSE(about.isEmpty());
        const LibraryClass* cls = document.library().find("Analogon.Mechanics.Inertia");
        ASSERT_TRUE(cls);
        EXPECT_NE(about, QString::fromStdString(cls->definition->description)) << "in German";
        // it is painted: the row has more ink than its name alone
        panel.tree()->setCurrentIndex({});
        QTest::qWait(50);
        const QRect row = panel.tree()->visualRect(block);
        const int nameEnds = row.left() + 24 + 12 + panel.tree()->fontMetrics().horizontalAdvance("Inertia");
        const QImage picture =
            panel.tree()->viewport()->grab(QRect(nameEnds + 20, row.top(), 150, row.height())).toImage();
        int inked = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) inked += picture.pixelColor(x, y).lightness() < 160;
        EXPECT_GT(inked, 30);
    }
    QCoreApplication::removeTranslator(&german);
}

TEST(LanguageMenu, TicksWhatIsShownWhoeverAskedForIt) {
    for (const char* shown : {"en", "de"}) {
        QSettings().setValue("window/language", shown == std::string("en") ? "de" : "en");  // another one was chosen
        Translator translator;
        if (translator.loadLanguage(shown)) QCoreApplication::installTranslator(&translator);
        {
            MainWindow window;
            QStringList ticked;
            for (QAction* action : window.findChildren<QAction*>())
                if ((action->text() == "English" || action->text() == "Deutsch") && action->isChecked())
                    ticked << action->text();
            EXPECT_EQ(ticked, QStringList(shown == std::string("en") ? "English" : "Deutsch"));
        }
        QCoreApplication::removeTranslator(&translator);
    }
    QSettings().remove("window/language");
}

}  // namespace
}  // namespace analogon::ui
