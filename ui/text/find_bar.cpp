#include "ui/text/find_bar.hpp"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QToolButton>
#include <algorithm>

#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int mostPlaces = 10000;  // that are marked and counted

}  // namespace

FindBar::FindBar(QPlainTextEdit& text)
    : QFrame(&text), text_(text), field_(new QLineEdit(this)), count_(new QLabel(this)) {
    setFont(QApplication::font());  // not that of the text
    field_->setPlaceholderText(tr("Find in the text"));
    field_->setAccessibleName(tr("Find in the text"));
    field_->setClearButtonEnabled(true);
    field_->setMinimumWidth(20 * style::unit);  // beside the count, in a text that is narrow, too
    field_->installEventFilter(this);
    style::makeCaption(count_);
    count_->setMinimumWidth(count_->fontMetrics().horizontalAdvance(tr("not found")) + 2 * style::unit);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2 * style::unit, style::unit, style::unit, style::unit);
    row->setSpacing(style::unit);
    row->addWidget(field_, 1);
    row->addWidget(count_);
    const auto button = [&](Qt::ArrowType arrow, const QString& tip, const auto& act) {
        auto* made = new QToolButton(this);
        made->setArrowType(arrow);
        if (arrow == Qt::NoArrow) made->setIcon(style::icon("close"));
        made->setAutoRaise(true);
        made->setToolTip(tip);
        made->setAccessibleName(tip);
        made->setFocusPolicy(Qt::NoFocus);
        connect(made, &QToolButton::clicked, this, act);
        row->addWidget(made);
    };
    button(Qt::UpArrow, tr("Previous (Shift+F3)"), [this] { next(true); });
    button(Qt::DownArrow, tr("Next (F3)"), [this] { next(); });
    button(Qt::NoArrow, tr("Close (Esc)"), [this] { leave(); });
    setCursor(Qt::ArrowCursor);
    connect(field_, &QLineEdit::textChanged, this, &FindBar::look);
    hide();
}

void FindBar::open() {
    const QTextCursor cursor = text_.textCursor();
    const QString chosen = cursor.selectedText();
    from_ = cursor.selectionStart();
    show();
    if (!chosen.isEmpty() && !chosen.contains(QChar::ParagraphSeparator)) field_->setText(chosen);
    search();
    place();
    raise();
    field_->setFocus(Qt::ShortcutFocusReason);
    field_->selectAll();
}

void FindBar::place() {
    const QRect room = text_.viewport()->geometry();
    const int width = std::min(sizeHint().width(), room.width());
    setGeometry(room.right() - width - style::unit, room.top() + style::unit, width, sizeHint().height());
}

void FindBar::search() {
    places_.clear();
    const QString word = field_->text();
    if (!isHidden() && !word.isEmpty())
        for (QTextCursor at = text_.document()->find(word); !at.isNull() && places_.size() < mostPlaces;
             at = text_.document()->find(word, at))
            places_.push_back(at);
    sayCount();
    Q_EMIT placesChanged();
}

void FindBar::look() {
    search();
    if (places_.isEmpty()) return;
    const auto here = std::find_if(places_.begin(), places_.end(),
                                   [this](const QTextCursor& c) { return c.selectionStart() >= from_; });
    text_.setTextCursor(here == places_.end() ? places_.front() : *here);
    text_.centerCursor();
    sayCount();
}

void FindBar::next(bool isBackward) {
    if (isHidden()) return open();
    if (places_.isEmpty()) return;
    const QTextCursor cursor = text_.textCursor();
    if (isBackward) {
        const auto before = std::find_if(places_.rbegin(), places_.rend(), [&](const QTextCursor& c) {
            return c.selectionStart() < cursor.selectionStart();
        });
        text_.setTextCursor(before == places_.rend() ? places_.back() : *before);
    } else {
        const auto after = std::find_if(places_.begin(), places_.end(), [&](const QTextCursor& c) {
            return c.selectionStart() >= cursor.selectionEnd();
        });
        text_.setTextCursor(after == places_.end() ? places_.front() : *after);
    }
    from_ = text_.textCursor().selectionStart();
    text_.centerCursor();
    sayCount();
}

void FindBar::sayCount() {
    const int start = text_.textCursor().selectionStart();
    const auto here =
        std::find_if(places_.begin(), places_.end(), [&](const QTextCursor& c) { return c.selectionStart() == start; });
    count_->setText(field_->text().isEmpty() ? QString()
                    : places_.isEmpty()      ? tr("not found")
                    : here == places_.end()
                        ? QString::number(places_.size())
                        : tr("%1 of %2").arg(std::distance(places_.begin(), here) + 1).arg(places_.size()));
}

void FindBar::leave() {
    hide();
    text_.setFocus();
}

void FindBar::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    if (places_.isEmpty()) return;
    places_.clear();
    Q_EMIT placesChanged();
}

void FindBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), style::mix(palette().color(QPalette::Window), style::accent(palette()), 0.6));
    painter.fillRect(rect().adjusted(1, 1, -1, -1), palette().color(QPalette::Window));
}

bool FindBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched != field_) return QFrame::eventFilter(watched, event);
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isOwn = key->key() == Qt::Key_Escape || key->key() == Qt::Key_F3 || key->key() == Qt::Key_Return ||
                       key->key() == Qt::Key_Enter || key->matches(QKeySequence::Find);
    if (!isOwn) return false;
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (key->key() == Qt::Key_Escape)
        leave();
    else if (key->matches(QKeySequence::Find))
        field_->selectAll();
    else
        next(key->modifiers() & Qt::ShiftModifier);
    return true;
}

}  // namespace analogon::ui
