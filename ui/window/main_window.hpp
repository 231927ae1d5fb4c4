#pragma once

#include <QMainWindow>
#include <functional>

#include "ui/window/settings.hpp"

class QDockWidget;
class QFileDialog;
class QMenu;
class QSplitter;
class QStackedWidget;
class QTabWidget;
class QToolBar;
class QToolButton;

namespace analogon {
struct Place;
enum class ExportFormat;
}  // namespace analogon

namespace analogon::ui {

class ComparePage;
class ComposeActions;
class DiagramScene;
class DiagramView;
class Document;
class FitPanel;
class GeneratePage;
class GuidePage;
class ImportPanel;
class LibraryPanel;
class MeasurementPanel;
class MessagePanel;
class ParameterPanel;
class PlotArea;
class PlotPanel;
class RecordingsPage;
class Recovery;
class ResultPanel;
class RunBar;
class RunController;
class SensitivityPage;
class SignalBrowser;
class StartPage;
class TextView;
class ValuesPage;
struct Mention;
struct Recovered;
struct StudyEntry;

/// Puts the panels together: the diagram in the middle, what was measured to the left, parameters and results to
/// the right, traces below. It has no state of its own beyond its layout.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// A study, or a measurement file that is to be imported.
    void open(const QString& path);
    void startNew();

    Document& document() { return *document_; }
    RunController& controller() { return *controller_; }
    ComposeActions& compose() { return *compose_; }
    Recovery& recovery() { return *recovery_; }
    void saveTo(const QString& path);
    /// HTML, PDF, data and the completed study, into a directory.
    void writeReport(const QString& path);
    /// The model, or its traces, into a file for other tools.
    void exportTo(ExportFormat format, const QString& path);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void createActions();
    void createMenus();
    void createToolBar();
    void createPanels();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area);
    void updateDockTitles();
    void connectPanels();
    void restoreLayout();
    void resetLayout();
    void addArrangements(QMenu* menu);
    void arrangeFor(int arrangement);
    void showArrangement();
    void setDocksShown(bool areShown);
    bool isSmall() const;
    void arrangeDocks();
    void sizeDocks();
    QString layoutKey() const;

    void updateActions();
    QString whyNoRun() const;
    void explainNoRun();
    void updateTitle();
    void showStudy();
    void offerRecovered();
    void openRecovered(const Recovered& recovered);
    void showModel();
    /// Brings the diagram, or the text, to the front: each its tab, or both on one.
    void showDiagram();
    void showText();
    void setTextBeside(bool isBeside);
    void showEffects();
    QString wholeName(const QString& block) const;
    void showPlace(const Place& place);
    void showFault();
    void showMention(const Mention& mention);
    void findInStudy();
    void showEntry(const StudyEntry& entry);
    void inspect(const QString& block);
    void askForStudy(bool isDirectory);
    void askForPicture();
    void askForRecordings();
    void save();
    void askWhereToSave();
    static QStringList measurementFilters();
    void askForMeasurement();
    void askWhereItIs(const QString& experiment);
    void showGenerate();
    void showGuide();
    void addLanguages(QMenu* view);
    void addPanelKeys(QMenu* menu);
    void importMeasurement(const QString& path);
    void takeFiles(const QStringList& paths);
    void leaveImport();
    void showValues(const QString& experiment);
    void leaveValues();
    void showComparison(const QString& signal, const QString& experiment);
    void leaveComparison();
    void connectRecordings();
    void askForPractice();
    void showRecordings();
    void leaveRecordings();
    void showSensitivity();
    void showCampaign(const QString& file);
    void settle();
    /// Does it at once, or once the user has said what becomes of unsaved changes.
    void leaveThen(std::function<void()> next);
    void rememberRecent(const QString& path);
    void showRecent();
    QList<QDockWidget*> docks() const;
    void askForReport();
    void askWhereToReport();
    void offerReport(const QString& file);
    void askWhereToExport(ExportFormat format);
    void setTheme(int theme);

    Settings settings_;
    Document* document_;
    RunController* controller_;
    JobRunner *writer_, *exporter_, *locator_;

    QStackedWidget* pages_{};
    StartPage* start_{};
    GuidePage* guide_{};
    GeneratePage* generate_{};
    ImportPanel* import_{};
    ValuesPage* values_{};
    ComparePage* comparison_{};
    RecordingsPage* recordings_{};
    SensitivityPage* sensitivity_{};
    LibraryPanel* library_{};
    ComposeActions* compose_{};
    Recovery* recovery_{};
    QMenu *recentMenu_{}, *exportMenu_{};
    std::function<void()> afterSave_;
    bool mayClose_{};
    QTabWidget* centre_{};
    DiagramScene* scene_{};
    DiagramView* view_{};
    TextView* text_{};
    QSplitter* both_{};  // diagram and text, when they are shown side by side
    MeasurementPanel* measurements_{};
    ParameterPanel* parameters_{};
    ResultPanel* results_{};
    FitPanel* runs_{};
    PlotPanel* plots_{};
    SignalBrowser* signals_{};
    PlotArea* signalPlots_{};
    MessagePanel* messages_{};
    RunBar* runBar_{};
    QList<QDockWidget*> besideGuide_;  // what comes back when it is left
    QList<QDockWidget*> closedDocks_;  // by the user, while all are out of sight
    bool areDocksShown_{true};
    bool isReadingGuide_{};
    QStringList waitingImports_;  // dropped together: one after the other
    QToolBar* recoveredBar_{};
    bool isCompact_{};                       // as the docks were arranged
    static constexpr int layoutVersion = 4;  // raised when docks are added: an old layout is not restored
    int arrangement_{-1};                    // for one part of the work; -1: everything
    bool isLayoutFresh_{true};
    QDockWidget *libraryDock_{}, *measurementDock_{}, *parameterDock_{}, *resultDock_{}, *runDock_{}, *plotDock_{},
        *messageDock_{}, *signalDock_{}, *signalPlotDock_{};

    QAction *newAction_{}, *generateAction_{}, *openAction_{}, *openFileAction_{}, *saveAction_{}, *saveAsAction_{},
        *importAction_{}, *reportAction_{}, *reportHeadAction_{}, *findAction_{}, *exportTracesAction_{},
        *exportMf4Action_{}, *quitAction_{};
    QAction *textBesideAction_{}, *recordingsAction_{}, *sensitivityAction_{};
    QAction *undoAction_{}, *redoAction_{}, *simulateAction_{}, *practiceAction_{}, *fitAction_{}, *discoverAction_{},
        *longerAction_{}, *fitViewAction_{}, *whyNoRunAction_{};
    QString fitTip_, discoverTip_;
    QToolButton *whyNoRun_{}, *openReport_{};
};

}  // namespace analogon::ui
