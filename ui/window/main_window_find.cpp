#include <QDockWidget>
#include <QLineEdit>
#include <QTableView>
#include <QTreeView>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/find/find_dialog.hpp"
#include "ui/fit/fit_panel.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/window/main_window.hpp"

/// From what was found in the study, or chosen in its diagram, to its place.
namespace analogon::ui {

namespace {

void bringForward(QDockWidget* dock) {
    dock->show();
    dock->raise();
}

/// The first row that holds; the list has the keys then.
template <class Holds>
void choose(QTreeWidget* list, const Holds& holds) {
    for (QTreeWidgetItemIterator it(list); *it; ++it)
        if (holds(**it)) {
            list->setCurrentItem(*it);
            list->scrollToItem(*it);
            return list->setFocus(Qt::ShortcutFocusReason);
        }
}

/// A row of a group.
void choose(SignalBrowser& browser, const StudyEntry& entry) {
    browser.searchField()->setText(entry.target);
    const SignalModel& model = browser.model();
    QModelIndex taken;
    for (int group = 0; group < model.rowCount(); ++group)
        for (int row = 0; row < model.rowCount(model.index(group, 0)); ++row) {
            const QModelIndex index = model.index(row, 0, model.index(group, 0));
            const Signal* signal = model.signalAt(index);
            if (!signal || signal->reference.name != entry.target) continue;
            if (!taken.isValid() || signal->reference.recording == entry.place) taken = index;
        }
    if (taken.isValid()) browser.tree()->setCurrentIndex(taken);
    browser.tree()->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace

void MainWindow::findInStudy() {
    if (!document_->isOpen()) return;
    if (auto* open = findChild<FindDialog*>(); open && open->isVisible()) {
        open->activateWindow();
        return open->field()->setFocus(Qt::ShortcutFocusReason);
    }
    settle();
    auto* dialog = new FindDialog(*document_, this);
    connect(dialog, &FindDialog::chosen, this, &MainWindow::showEntry);
    dialog->show();
    dialog->field()->setFocus(Qt::ShortcutFocusReason);
}

/// The parameters of a block; what a block without any is, the library tells.
void MainWindow::inspect(const QString& block) {
    parameters_->showComponent(wholeName(block));
    if (!parameters_->model()->isOfComponent()) {
        const Block* found = document_->diagram().find(block.toStdString());
        if (!found || !library_->read(QString::fromStdString(found->className))) return;
        return bringForward(libraryDock_);
    }
    bringForward(parameterDock_);
    parameters_->table()->setFocus();
    if (parameters_->model()->rowCount() > 0)
        parameters_->table()->setCurrentIndex(parameters_->model()->index(0, ParameterModel::Value));
}

void MainWindow::showEntry(const StudyEntry& entry) {
    switch (entry.kind) {
        case StudyEntry::Kind::Component:
            return showMention({Mention::Kind::Block, entry.target});
        case StudyEntry::Kind::Parameter:
            return showMention({Mention::Kind::Parameter, entry.target});
        case StudyEntry::Kind::Recording:
            return showMention({Mention::Kind::Experiment, entry.target});
        case StudyEntry::Kind::Signal:
            bringForward(signalDock_);
            return choose(*signals_, entry);
        case StudyEntry::Kind::Tried:
            bringForward(resultDock_);
            if (!results_->candidates()) return;
            results_->candidateFilter()->clear();
            results_->ensureWidgetVisible(results_->candidates());
            return choose(results_->candidates(), [&](const QTreeWidgetItem& item) {
                return item.data(0, ResultPanel::KindRole).toString() == entry.target &&
                       item.data(3, ResultPanel::KindRole).toString() == entry.place;
            });
        case StudyEntry::Kind::Run:
            bringForward(runDock_);
            return choose(runs_->history(), [&](const QTreeWidgetItem& item) {
                return item.data(0, Qt::UserRole).toULongLong() == entry.number;
            });
        case StudyEntry::Kind::Text:
            break;
    }
    Place place;
    place.file = entry.target.toStdString();
    place.line = static_cast<int>(entry.number);
    showPlace(place);
}

}  // namespace analogon::ui
