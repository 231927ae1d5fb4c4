#pragma once

#include <QMainWindow>

class QDockWidget;
class QFileDialog;
class QStackedWidget;
class QTabWidget;

namespace analogon {
struct Place;
}

namespace analogon::ui {

class DiagramScene;
class DiagramView;
class Document;
class JobRunner;
class MeasurementPanel;
class MessagePanel;
class ParameterPanel;
class PlotPanel;
class ResultPanel;
class RunBar;
class RunController;
class StartPage;
class TextView;

/// Puts the panels together: the diagram in the middle, what was measured to the left, parameters and results to
/// the right, traces below. It has no state of its own beyond its layout.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    void open(const QString& path);

    Document& document() { return *document_; }
    RunController& controller() { return *controller_; }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
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
    void sizeDocks();

    void updateActions();
    void updateTitle();
    void showStudy();
    void showModel();
    void showEffects();
    void showPlace(const Place& place);
    void askForStudy(bool isDirectory);
    void askWhereToSave();
    void askWhereToReport();
    void setTheme(int theme);

    Document* document_;
    RunController* controller_;
    JobRunner* writer_;

    QStackedWidget* pages_{};
    StartPage* start_{};
    QTabWidget* centre_{};
    DiagramScene* scene_{};
    DiagramView* view_{};
    TextView* text_{};
    MeasurementPanel* measurements_{};
    ParameterPanel* parameters_{};
    ResultPanel* results_{};
    PlotPanel* plots_{};
    MessagePanel* messages_{};
    RunBar* runBar_{};
    bool isLayoutFresh_{true};
    QDockWidget *measurementDock_{}, *parameterDock_{}, *resultDock_{}, *plotDock_{}, *messageDock_{};

    QAction *openAction_{}, *openFileAction_{}, *saveAction_{}, *reportAction_{}, *quitAction_{};
    QAction *undoAction_{}, *redoAction_{}, *fitAction_{}, *discoverAction_{}, *fitViewAction_{};
};

}  // namespace analogon::ui
