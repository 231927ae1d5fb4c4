#include "ui/text/name_popup.hpp"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStandardItemModel>

#include "ui/document/document.hpp"
#include "ui/style/style.hpp"
#include "ui/text/name_completion.hpp"
#include "ui/text/text_view.hpp"

namespace analogon::ui {

namespace {

constexpr int lettersUnasked = 3;  // of a word, from which on names are offered unasked

}  // namespace

NamePopup::NamePopup(Document& document, TextView& text)
    : QObject(&text),
      document_(document),
      text_(text),
      completer_(new QCompleter(this)),
      names_(new QStandardItemModel(this)) {
    completer_->setModel(names_);
    completer_->setWidget(&text);
    completer_->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    completer_->setCompletionRole(Qt::UserRole);
    completer_->popup()->setAccessibleName(tr("Names that fit"));
    connect(completer_, qOverload<const QString&>(&QCompleter::activated), this, &NamePopup::put);
    connect(&document, &Document::modelChanged, this, &NamePopup::learn);
    learn();
}

void NamePopup::learn() {
    if (!document_.definition()) return;
    known_ = document_.library();
    model_ = document_.definition()->name;
}

bool NamePopup::isOpen() const { return completer_->popup()->isVisible(); }

bool NamePopup::takes(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Space && event.modifiers() == Qt::ControlModifier) {
        offer(true);
        return true;
    }
    if (!isOpen()) return false;
    const QModelIndex marked = completer_->popup()->currentIndex();
    const bool isEnter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (event.key() == Qt::Key_Tab || (isEnter && marked.isValid())) {
        const QModelIndex taken = marked.isValid() ? marked : completer_->popup()->model()->index(0, 0);
        completer_->popup()->hide();
        put(taken.data(Qt::UserRole).toString());
        return true;
    }
    if (isEnter || event.key() == Qt::Key_Escape) completer_->popup()->hide();
    return event.key() == Qt::Key_Escape;
}

void NamePopup::follow(const QKeyEvent& event) {
    const QString typed = event.text();
    const bool isWord = !typed.isEmpty() && (typed[0].isLetterOrNumber() || typed[0] == u'_' || typed[0] == u'.');
    if (isWord || (isOpen() && event.key() == Qt::Key_Backspace))
        offer(false);
    else if (isOpen() && !typed.isEmpty())
        completer_->popup()->hide();
}

void NamePopup::offer(bool isAskedFor) {
    const QTextCursor cursor = text_.textCursor();
    const QString before = text_.toPlainText().left(cursor.position());
    const bool isEnough = isAskedFor || isOpen() || before.endsWith(u'.');
    const NameOffers found = nameOffers(known_, model_, before);
    typed_ = found.typed;
    const bool isWhole = found.offers.size() == 1 && found.offers[0].name == before.right(found.typed);
    if (found.offers.empty() || isWhole || text_.isReadOnly() || !(isEnough || found.typed >= lettersUnasked)) {
        completer_->popup()->hide();
        return;
    }
    names_->clear();
    for (const NameOffer& offer : found.offers) {
        auto* row = new QStandardItem(offer.detail.isEmpty() ? offer.name
                                                             : offer.name + QStringLiteral("  –  ") + offer.detail);
        row->setData(offer.name, Qt::UserRole);
        names_->appendRow(row);
    }
    QAbstractItemView* const list = completer_->popup();
    completer_->setCompletionPrefix({});
    QRect at = text_.cursorRect().translated(text_.viewport()->pos());
    const int widest = list->sizeHintForColumn(0) + list->verticalScrollBar()->sizeHint().width() + 2 * style::unit;
    at.setWidth(std::clamp(widest, 40 * style::unit, std::max(text_.width() - at.left(), 100 * style::unit)));
    completer_->complete(at);
    list->setCurrentIndex(isAskedFor ? list->model()->index(0, 0) : QModelIndex());
}

void NamePopup::put(const QString& name) {
    if (name.isEmpty()) return;
    QTextCursor cursor = text_.textCursor();
    cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, typed_);
    cursor.insertText(name);
    text_.setTextCursor(cursor);
}

}  // namespace analogon::ui
