#include "ui/find/find_dialog.hpp"

#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/document/document.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

FindDialog::FindDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      field_(new QLineEdit(this)),
      list_(new QTreeView(this)),
      count_(new QLabel(this)),
      model_(new EntryModel(this)) {
    setObjectName("find-in-study");
    setWindowTitle(tr("Find in the study"));
    setAttribute(Qt::WA_DeleteOnClose);
    field_->setPlaceholderText(tr("Component, parameter, signal, recording, effect, run, text"));
    field_->setAccessibleName(tr("Find in the study"));
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    list_->setModel(model_);
    list_->setAccessibleName(tr("What was found"));
    list_->setRootIsDecorated(false);
    list_->setHeaderHidden(true);
    list_->setUniformRowHeights(true);
    list_->setSelectionBehavior(QAbstractItemView::SelectRows);
    list_->setTextElideMode(Qt::ElideRight);
    list_->header()->setSectionResizeMode(0, QHeaderView::Interactive);
    list_->header()->setStretchLastSection(true);
    style::makeCaption(count_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addWidget(field_);
    layout->addWidget(list_, 1);
    layout->addWidget(count_);
    const QSize room = parent ? parent->size() : QSize(1024, 700);
    resize(std::min(190 * style::unit, room.width() - 20 * style::unit),
           std::min(130 * style::unit, room.height() - 20 * style::unit));
    list_->setColumnWidth(0, width() * 9 / 20);
    model_->setEntries(studyEntries(document));
    connect(field_, &QLineEdit::textChanged, this, &FindDialog::search);
    connect(list_, &QTreeView::activated, this, &FindDialog::go);
    connect(&document, &Document::opened, this, &QDialog::reject);
    search();
}

void FindDialog::search() {
    model_->search(field_->text());
    if (const QModelIndex first = model_->firstEntry(); first.isValid()) list_->setCurrentIndex(first);
    list_->scrollToTop();
    count_->setText(model_->matches() == 0 ? tr("Nothing of the study is called so.")
                                           : tr("%1 found. Enter goes there, Esc closes.").arg(model_->matches()));
}

void FindDialog::go() {
    const StudyEntry* entry = model_->entryAt(list_->currentIndex());
    if (!entry) return;
    const StudyEntry taken = *entry;
    accept();
    Q_EMIT chosen(taken);
}

/// The keys of the list work while one types.
bool FindDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched != field_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        go();
        return true;
    }
    if (key != Qt::Key_Up && key != Qt::Key_Down && key != Qt::Key_PageUp && key != Qt::Key_PageDown) return false;
    QCoreApplication::sendEvent(list_, event);
    return true;
}

}  // namespace analogon::ui
