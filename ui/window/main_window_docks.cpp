#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <algorithm>

#include "ui/document/document.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/window/main_window.hpp"

/// The panels of the window: where they stand, how large they are, and what of it is remembered.
namespace analogon::ui {

namespace {

/// Heading of a dock: a quiet line of text instead of the style's frame. Drags like the built-in one.
class DockTitle : public QLabel {
public:
    DockTitle(const QString& text, QWidget* parent) : QLabel(text, parent) {
        setContentsMargins(style::margin, 2 * style::unit, style::margin, 2 * style::unit);
        QFont bold = font();
        bold.setWeight(QFont::DemiBold);
        setFont(bold);
    }
    /// In a stack of docks the tab already says the name.
    void setCollapsed(bool isCollapsed) {
        isCollapsed_ = isCollapsed;
        updateGeometry();
    }
    QSize sizeHint() const override { return isCollapsed_ ? QSize(0, 0) : QLabel::sizeHint(); }
    QSize minimumSizeHint() const override { return isCollapsed_ ? QSize(0, 0) : QLabel::minimumSizeHint(); }

protected:
    // A title bar must leave its mouse events to the dock.
    void mousePressEvent(QMouseEvent* event) override { event->ignore(); }
    void mouseMoveEvent(QMouseEvent* event) override { event->ignore(); }
    void mouseReleaseEvent(QMouseEvent* event) override { event->ignore(); }

private:
    bool isCollapsed_{};
};

}  // namespace

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(panel);
    dock->setTitleBarWidget(new DockTitle(title, dock));
    addDockWidget(area, dock);
    const auto later = [this] { QTimer::singleShot(0, this, &MainWindow::updateDockTitles); };
    connect(dock, &QDockWidget::dockLocationChanged, this, later);
    connect(dock, &QDockWidget::topLevelChanged, this, later);
    connect(dock, &QDockWidget::visibilityChanged, this, later);
    return dock;
}

QList<QDockWidget*> MainWindow::docks() const {
    return {libraryDock_, measurementDock_, parameterDock_, resultDock_,    runDock_,
            plotDock_,    messageDock_,     signalDock_,    signalPlotDock_};
}

void MainWindow::updateDockTitles() {
    for (QDockWidget* dock : docks()) {
        const QList<QDockWidget*> stack = tabifiedDockWidgets(dock);  // with those that are closed, which have no tab
        const bool hasTab =
            std::any_of(stack.begin(), stack.end(), [](const QDockWidget* d) { return !d->isHidden(); });
        static_cast<DockTitle*>(dock->titleBarWidget())->setCollapsed(!dock->isFloating() && hasTab);
    }
}

/// A screen of 1280 x 720 pixels at 150 % leaves 853 x 480.
bool MainWindow::isSmall() const { return width() < 1000 || height() < 640; }

/// Where there is little room, panels that else stand one above the other share one place by tabs.
void MainWindow::arrangeDocks() {
    isCompact_ = isSmall();
    const auto join = [this](QDockWidget* first, QDockWidget* second) {
        if (isCompact_)
            tabifyDockWidget(first, second);
        else
            splitDockWidget(first, second, Qt::Vertical);
    };
    addDockWidget(Qt::LeftDockWidgetArea, libraryDock_);
    addDockWidget(Qt::LeftDockWidgetArea, measurementDock_);
    join(libraryDock_, measurementDock_);
    addDockWidget(Qt::RightDockWidgetArea, parameterDock_);
    addDockWidget(Qt::RightDockWidgetArea, resultDock_);
    join(parameterDock_, resultDock_);
    addDockWidget(Qt::BottomDockWidgetArea, plotDock_);
    addDockWidget(Qt::BottomDockWidgetArea, messageDock_);
    addDockWidget(Qt::LeftDockWidgetArea, signalDock_);
    tabifyDockWidget(libraryDock_, signalDock_);
    addDockWidget(Qt::BottomDockWidgetArea, signalPlotDock_);
    tabifyDockWidget(plotDock_, signalPlotDock_);
    tabifyDockWidget(plotDock_, messageDock_);
    plotDock_->raise();
    addDockWidget(Qt::RightDockWidgetArea, runDock_);
    tabifyDockWidget(resultDock_, runDock_);
    resultDock_->raise();
    libraryDock_->raise();
    isLayoutFresh_ = true;
}

void MainWindow::resetLayout() {
    arrangement_ = -1;
    showArrangement();
    arrangeDocks();
    closedDocks_.clear();
    if (areDocksShown_)
        for (QDockWidget* dock : docks()) dock->show();
    if (document_->isOpen()) showStudy();
}

/// Pages that need the whole window take the panels out of sight; those that the user had closed stay closed.
void MainWindow::setDocksShown(bool areShown) {
    if (areShown == areDocksShown_) return;
    areDocksShown_ = areShown;
    if (!areShown) closedDocks_.clear();
    for (QDockWidget* dock : docks())  // one that was never shown counts as hidden until it is
        if (!areShown && dock->isHidden() && dock->testAttribute(Qt::WA_WState_ExplicitShowHide)) closedDocks_ << dock;
    for (QDockWidget* dock : docks()) dock->setVisible(areShown && !closedDocks_.contains(dock));
}

/// Sizes only hold for docks that are shown, so they wait for the first study.
void MainWindow::sizeDocks() {
    const int left = std::max(isCompact_ ? 0 : 264, measurements_->minimumSizeHint().width());
    const int right = isCompact_ ? width() - left - 380 : std::clamp(width() - left - 590, 360, 640);
    resizeDocks({measurementDock_, parameterDock_}, {left, right}, Qt::Horizontal);
    resizeDocks({plotDock_}, {std::min(410, height() * 45 / 100)}, Qt::Vertical);
    if (!isCompact_) {
        resizeDocks({libraryDock_, measurementDock_}, {2, 3}, Qt::Vertical);
        resizeDocks({parameterDock_, resultDock_}, {2, 3}, Qt::Vertical);
    }
    isLayoutFresh_ = false;
}

/// A laptop that is plugged into a large screen has two layouts, and each part of the work its own.
QString MainWindow::layoutKey() const {
    const QString key = isCompact_ ? "window/small-state" : "window/state";
    return arrangement_ < 0 ? key : key + QStringLiteral("-%1").arg(arrangement_);
}

void MainWindow::restoreLayout() {
    restoreGeometry(settings_.value("window/geometry").toByteArray());
    arrangement_ = settings_.value("window/arrangement", -1).toInt();
    showArrangement();
    if (isSmall() != isCompact_) arrangeDocks();
    if (restoreState(settings_.value(layoutKey()).toByteArray(), layoutVersion)) isLayoutFresh_ = false;
}

}  // namespace analogon::ui
