#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QGraphicsSceneHoverEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPaintEngine>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>
#include <set>

#include "tests/ui/sample_finding.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/fit/error_curve.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/values_page.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/plot/residual_plot.hpp"
#include "ui/plot/time_plot.hpp"
#include "ui/style/translator.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {
namespace {

/// Keeps every text that is drawn and nothing else: the labels of axes are in no model.
class TextCatcher : public QPaintEngine {
public:
    TextCatcher() : QPaintEngine(QPaintEngine::AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawTextItem(const QPointF&, const QTextItem& item) override { texts << item.text(); }
    Type type() const override { return User; }
    QStringList texts;
};

class Sheet : public QPaintDevice {
public:
    explicit Sheet(QSize size) : size_(size) {}
    QPaintEngine* paintEngine() const override { return &engine_; }
    const QStringList& texts() const { return engine_.texts; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
                return size_.width();
            case PdmHeight:
                return size_.height();
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return 96;
            case PdmDevicePixelRatio:
                return 1;
            default:
                return QPaintDevice::metric(metric);
        }
    }

private:
    QSize size_;
    mutable TextCatcher engine_;
};

QStringList drawnOn(QWidget& widget) {
    Sheet sheet(widget.size());
    widget.render(&sheet);
    return sheet.texts();
}

void addModel(const QAbstractItemModel& model, QStringList& texts, const QModelIndex& parent = {}) {
    constexpr int most = 200;  // rows: the others are made the same way
    for (int c = 0; c < model.columnCount(parent); ++c)
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole}) {
            texts << model.headerData(c, Qt::Horizontal, role).toString();
            for (int r = 0; r < std::min(most, model.rowCount(parent)); ++r)
                texts << model.index(r, c, parent).data(role).toString();
        }
    for (int r = 0; r < std::min(most, model.rowCount(parent)); ++r)
        if (const QModelIndex index = model.index(r, 0, parent); model.hasChildren(index))
            addModel(model, texts, index);
}

/// All that the window says: what is drawn, what would be drawn after scrolling, and what appears under the pointer.
QStringList saidBy(QWidget& window) {
    QStringList texts = drawnOn(window);
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        texts << widget->toolTip();
        if (const auto* label = qobject_cast<QLabel*>(widget)) texts << label->text();
        if (const auto* button = qobject_cast<QAbstractButton*>(widget)) texts << button->text();
        if (const auto* bar = qobject_cast<QStatusBar*>(widget)) texts << bar->currentMessage();
        if (const auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->model())
            addModel(*view->model(), texts);
    }
    for (auto* view : window.findChildren<DiagramView*>())
        for (QGraphicsItem* item : view->scene()->items()) {
            QGraphicsSceneHoverEvent enter(QEvent::GraphicsSceneHoverEnter);
            view->scene()->sendEvent(item, &enter);
            texts << item->toolTip();
        }
    return texts;
}

const QRegularExpression point(R"(\d\.\d)"), comma(R"(\d,\d)");

/// The study of an example, with all the numbers that a panel can show, in a German window.
class GermanWindow : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(german.loadLanguage("de"));
        QCoreApplication::installTranslator(&german);
        qputenv("XDG_DATA_HOME", directory.path().toUtf8());
        window = std::make_unique<MainWindow>();
        window->resize(1440, 900);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->open(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    }
    void TearDown() override {
        document().undoStack().setClean();
        QTest::qWait(1);
        window.reset();
        QCoreApplication::removeTranslator(&german);
    }
    Document& document() { return window->document(); }
    template <class T>
    T* panel() const {
        return window->findChild<T*>();
    }
    /// Bounds, a prior, a range, a scaled channel with a clock of its own, and a value with many digits in the model.
    void fill() {
        StudySettings settings = document().settings();
        StudyParameter& resistance = settings.parameters.at("heater.R");
        resistance.min = 0.15;
        resistance.max = 20.5;
        resistance.prior = NormalPrior{3.25, 0.125};
        StudyExperiment& experiment = settings.experiments.front();
        experiment.range = {0.5, 150.25};
        ChannelMapping& output = experiment.outputs.at("i_mod");
        output.scale = 1.0005;
        output.offset = 0.00025;
        output.weight = 1.5;
        output.clock = 0.0125;
        document().applySettings(std::move(settings), "fill");
        document().setParameterValue("heater.alpha", 0.0041234567);
        const auto isTrimmed = [&] {
            return document().before() && document().before()->experiments.front().time.front() >= 0.5;
        };
        ASSERT_TRUE(QTest::qWaitFor(isTrimmed, 20000));
    }
    void run(RunKind kind) {
        window->controller().start(kind);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->controller().isRunning(); }, 120000));
        QTest::qWait(50);
    }
    /// A search that found all there is to find.
    RunResult found() {
        RunResult result = sampleFinding(document(), "thermal.loss", "Analogon.Effects.Thermal.Loss",
                                         "Heat loss to the surroundings", "element.solid", "port", "G");
        Finding& finding = result.finding;
        finding.effects.front().instead.values = {phrase("{} = {:.5g}{}", "element.C", 302.25, " J/K")};
        finding.warnings = {
            phrase("{} rests at its lower bound {:.6g}", "heater.R", 0.15),
            phrase("{} of {:.5g} ± {:.2g}{} instead of {:.5g} explains as much: the data do not tell which is wrong",
                   "heater.R", 3.1415, 0.25, " Ohm", 2.5)};
        finding.final.remarks = {
            phrase("{} and {} can hardly be told apart (correlation {:.5f})", "heater.R", "heater.alpha", 0.99991)};
        Remainder remainder;
        remainder.output = "i_mod";
        remainder.experiment = document().study().experiments.front().name;
        remainder.node = "element.solid";
        remainder.from = 3.5;
        remainder.to = 7.25;
        remainder.movesWith = {{"T_exhaust", 0.83}};
        remainder.proposal.equation =
            withValues("Q_flow = a*T^2", std::vector<EffectValue>{{"a", 0.0125, 0.001, "W/K2"}});
        remainder.proposal.errors.fit = 1.25;
        remainder.proposal.errors.validate = 2.5;
        remainder.proposal.errorValidateWithout = 2.25;
        finding.unexplained.remainders = {remainder};
        finding.nextExperiment = phrase(
            "input {} as {}, over {:.3g} s", "ctrl_var",
            phrase("a slow ramp from {} to {} and back", phrase("{:.3g}{}", 0.5, " V"), phrase("{:.3g}{}", 12.5, " V")),
            22.5);
        return result;
    }
    /// Every page of the window, one after the other: no point in a number, and the commas that were meant.
    void expectCommas(const char* when) {
        for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QTest::qWait(20);
            look(when, dock->objectName().toStdString());
        }
    }
    void look(const char* when, const std::string& where) {
        for (const QString& text : saidBy(*window)) {
            if (text.contains(comma)) seen.insert(text);
            EXPECT_FALSE(text.contains(point)) << when << ", " << where << ": " << text.toStdString();
        }
    }
    bool hasSeen(const char* part) const {
        return std::any_of(seen.begin(), seen.end(),
                           [&](const QString& text) { return text.contains(QString::fromUtf8(part)); });
    }

    Translator german;
    QTemporaryDir directory;
    std::unique_ptr<MainWindow> window;
    std::set<QString> seen;  // texts with a decimal comma
};

TEST_F(GermanWindow, ShowsNoNumberWithAPoint) {
    fill();
    expectCommas("as it was opened");
    for (const char* part : {"0,15", "20,5", "3,25 ± 0,125", "0,5 … 150,25 s", "0,0125 s", "1,0005", "0,00025", "1,5",
                             "0,0041235", "0,0041234567"})
        EXPECT_TRUE(hasSeen(part)) << part;

    run(RunKind::Fit);
    expectCommas("after a fit");
    EXPECT_TRUE(hasSeen(" ± 0,")) << "an estimate";
    EXPECT_TRUE(hasSeen(",") && !drawnOn(*panel<PlotPanel>()->plots().front()->values()).filter(comma).isEmpty())
        << "an axis";

    document().setResult(RunKind::Discover, found(), document().study(), 1.5);
    QTest::qWait(50);
    expectCommas("after a search");
    for (const char* part : {"302,25 J/K", "0,15", "3,1415 ± 0,25 Ohm", "0,99991", "3,5", "7,25", "0,83", "a = 0,0125",
                             "1,25 %", "2,25 %", "12,5 V", "22,5 s", "+0,93", "0,002100 ± 0,000031"})
        EXPECT_TRUE(hasSeen(part)) << part;
}

TEST_F(GermanWindow, ComparesAndReadsOutWithCommas) {
    run(RunKind::Fit);
    document().setResult(RunKind::Discover, found(), document().study(), 1.5);
    QTest::qWait(50);
    panel<FitPanel>()->history()->selectAll();
    QTest::qWait(50);
    ASSERT_TRUE(document().comparedRuns());
    expectCommas("two runs");
    panel<PlotPanel>()->endComparisonButton()->click();
    QTest::qWait(20);

    OutputPlot* plot = panel<PlotPanel>()->plots().front();
    plot->pointAt(12.345);
    look("pointer", "traces");
    EXPECT_TRUE(hasSeen(" s   ")) << "the values at the pointer";
    plot->setMarks({1.5, 7.25});
    plot->pointAt(std::nullopt);
    look("marks", "traces");
    EXPECT_TRUE(hasSeen("Δ 5,75 s"));

    panel<PlotPanel>()->residualButton()->click();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !drawnOn(*panel<PlotPanel>()->residuals().front()).filter(comma).isEmpty(); }, 5000));
    look("residual", "traces");

    ErrorCurve* curve = panel<ErrorCurve>();
    curve->clear();
    for (const double seconds : {0.5, 1.25}) curve->add(seconds, 3.125 / seconds);
    EXPECT_FALSE(drawnOn(*curve).filter(comma).isEmpty());
    EXPECT_TRUE(drawnOn(*curve).filter(point).isEmpty());
}

TEST_F(GermanWindow, ShowsRecordingsWithCommas) {
    QFile file(directory.filePath("run.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("t [s],T [degC],u [V]\n0,20.5,0\n0.5,20.75,12.25\n9.25,21.5,12.5\n9.75,21.75,12.5\n");
    file.close();
    window->open(file.fileName());
    auto* import = panel<ImportPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return import->acceptButton()->isEnabled(); }, 10000));
    look("import", "centre");
    EXPECT_TRUE(hasSeen("12,25"));
    import->convertedBox()->setChecked(true);
    look("import in SI units", "centre");
    EXPECT_TRUE(hasSeen("293,9"));
    Q_EMIT import->cancelled();
    Q_EMIT panel<MeasurementPanel>()->valuesWanted(QString::fromStdString(document().study().experiments.front().name));
    QTest::qWait(20);
    look("values", "centre");
    // what is copied from a table is what is shown
    QTableView* view = panel<ValuesPage>()->view();
    for (int row = 0; row < 200; ++row)
        if (view->model()->index(row, 0).data().toString().contains(comma))
            view->setCurrentIndex(view->model()->index(row, 0));
    QApplication::clipboard()->clear();
    QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QApplication::clipboard()->text().contains(comma)) << QApplication::clipboard()->text().toStdString();
}

TEST_F(GermanWindow, WritesItsReportOnPaperWithCommasAndFilesWithPoints) {
    const Finding finding = found().finding;
    const QString body = reportBody("lambda", RunKind::Discover, finding, {});
    static const QRegularExpression tag("<[^>]*>");
    const QString words = QString(body).replace(tag, " ");
    EXPECT_TRUE(words.contains(comma));
    EXPECT_FALSE(words.contains(point)) << point.match(words).capturedStart() << words.toStdString();
    const QString csv = directory.filePath("shown.csv");
    panel<PlotPanel>()->exportTo(csv);
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo(csv).size() > 100; }, 10000));
    QFile file(csv);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(QString::fromUtf8(file.readLine(1000) + file.readLine(1000) + file.readLine(1000)).contains(point));
    fill();
    EXPECT_NE(studyJson(document().study()).find("0.0125"), std::string::npos);
    EXPECT_TRUE(document().modelText().contains(QRegularExpression(R"(alpha ?= ?0\.0041234567)"))) << "Modelica text";
}

TEST_F(GermanWindow, TakesNumbersWithEitherSign) {
    ParameterModel* model = panel<ParameterPanel>()->model();
    ASSERT_TRUE(QTest::qWaitFor([&] { return model->rowOf("heater.R") >= 0; }, 5000));
    const auto at = [&](int column) { return model->index(model->rowOf("heater.R"), column); };
    const auto setting = [&] { return document().study().parameters.at("heater.R"); };
    for (const auto& [typed, value] : {std::pair("0,25", 0.25), {"0.5", 0.5}, {"7,5e-1", 0.75}}) {
        EXPECT_TRUE(model->setData(at(ParameterModel::Min), typed, Qt::EditRole)) << typed;
        EXPECT_EQ(setting().min, value) << typed;
    }
    for (const char* wrong : {"1.234,5", "1,234.5", "1 234", "1,5;2"})
        EXPECT_FALSE(model->setData(at(ParameterModel::Max), wrong, Qt::EditRole)) << wrong;
    EXPECT_TRUE(model->setData(at(ParameterModel::Prior), QString::fromUtf8("3,5 ± 0.25"), Qt::EditRole));
    EXPECT_EQ(setting().prior, (NormalPrior{3.5, 0.25}));
    EXPECT_EQ(at(ParameterModel::Prior).data(Qt::EditRole).toString(), QString::fromUtf8("3,5 ± 0,25"));
    EXPECT_FALSE(model->setData(at(ParameterModel::Min), at(ParameterModel::Min).data(Qt::EditRole), Qt::EditRole))
        << "an editor that was only opened";
    EXPECT_EQ(setting().min, 0.75);

    auto* tree = panel<MeasurementPanel>()->tree();
    const auto typeRange = [&](const QString& typed) {
        QTreeWidgetItem* range = nullptr;
        for (int i = 0; i < tree->topLevelItem(0)->childCount(); ++i)
            if (tree->topLevelItem(0)->child(i)->text(0) == QString::fromUtf8("Bereich"))
                range = tree->topLevelItem(0)->child(i);
        ASSERT_TRUE(range);
        tree->editItem(range, 1);
        auto* editor = tree->findChild<QLineEdit*>();
        ASSERT_TRUE(editor);
        editor->setText(typed);
        QTest::keyClick(editor, Qt::Key_Return);
        QTest::qWait(10);
    };
    const auto range = [&] { return document().study().experiments.front().range; };
    using Range = std::optional<std::pair<double, double>>;
    for (const char* typed :
         {"0,5 … 22,5 s", "0.5 ... 22.5", "0,5-22,5", "0.5 s - 22,5 s", "0,5; 22,5", "0,5 22.5", "0,5–22,5"}) {
        typeRange(QString::fromUtf8(typed));
        EXPECT_EQ(range(), Range(std::pair(0.5, 22.5))) << typed;
        typeRange("1 … 2");
        EXPECT_EQ(range(), Range(std::pair(1.0, 2.0)));
    }
    typeRange("-0,5 -0,25");
    EXPECT_EQ(range(), Range(std::pair(-0.5, -0.25)));
    for (const char* wrong : {"1,5,3", "1.234,5 … 2000", "3 … 2", "2,5", "1 2 3", "x … 2"}) {
        typeRange(QString::fromUtf8(wrong));
        EXPECT_EQ(range(), Range(std::pair(-0.5, -0.25))) << wrong;
    }
}

}  // namespace
}  // namespace analogon::ui
