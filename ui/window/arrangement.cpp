#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QTabWidget>
#include <QTimer>
#include <array>

#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/window/main_window.hpp"

/// Which panels are beside the diagram while one works on the model, on the data, on the result. Each is kept as the
/// user left it.
namespace analogon::ui {

namespace {

enum Arrangement { ForModel, ForData, ForResult };

/// Of the panels that an arrangement shows the first is in front of those it shares a place with.
QStringList panelsOf(int arrangement) {
    switch (arrangement) {
        case ForModel:
            return {"library", "parameters", "messages"};
        case ForData:
            return {"plots", "traces", "measurements", "signals"};
        default:
            return {"result", "traces", "runs", "plots"};
    }
}

}  // namespace

void MainWindow::addArrangements(QMenu* menu) {
    const std::array<std::pair<QString, Qt::Key>, 3> all{std::pair(tr("Arrange for the model"), Qt::Key_F7),
                                                         std::pair(tr("Arrange for the data"), Qt::Key_F8),
                                                         std::pair(tr("Arrange for the result"), Qt::Key_F9)};
    auto* group = new QActionGroup(this);
    group->setObjectName("arrangements");
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const auto& [name, key] = all[static_cast<std::size_t>(i)];
        QAction* action = group->addAction(menu->addAction(name));
        action->setCheckable(true);
        action->setShortcut(key);
        connect(action, &QAction::triggered, this, [this, i](bool isWanted) { arrangeFor(isWanted ? i : -1); });
    }
    menu->addSeparator();
}

void MainWindow::showArrangement() {
    const auto* group = findChild<QActionGroup*>("arrangements");
    for (int i = 0; group && i < group->actions().size(); ++i) group->actions()[i]->setChecked(i == arrangement_);
}

/// The same key again leads back to all panels.
void MainWindow::arrangeFor(int arrangement) {
    if (!document_->isOpen() || !areDocksShown_) return showArrangement();
    settings_.setValue(layoutKey(), saveState(layoutVersion));
    arrangement_ = arrangement;
    showArrangement();
    isCompact_ = isSmall();
    if (restoreState(settings_.value(layoutKey()).toByteArray(), layoutVersion)) return;
    arrangeDocks();
    const QStringList shown = panelsOf(arrangement);
    const auto isWanted = [&](const QDockWidget* dock) {
        return arrangement < 0 || shown.contains(dock->objectName());
    };
    for (QDockWidget* dock : docks()) dock->setVisible(isWanted(dock));
    sizeDocks();
    if (arrangement == ForData) resizeDocks({plotDock_}, {height() * 6 / 10}, Qt::Vertical);
    if (arrangement == ForResult) resizeDocks({resultDock_}, {width() * 45 / 100}, Qt::Horizontal);
    if (arrangement == ForModel) resizeDocks({messageDock_}, {height() / 6}, Qt::Vertical);
    for (auto name = shown.rbegin(); name != shown.rend(); ++name)
        if (auto* dock = findChild<QDockWidget*>(*name)) dock->raise();
    QTimer::singleShot(0, view_, &DiagramView::fitView);
}

}  // namespace analogon::ui
