#include "ui/text/text_view.hpp"

#include <QFileInfo>
#include <QFontDatabase>
#include <QMouseEvent>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>
#include <utility>

#include "ui/document/document.hpp"
#include "ui/style/style.hpp"
#include "ui/text/annotation_folds.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/highlighter.hpp"
#include "ui/text/name_popup.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int foldWidth = 4 * style::unit;  // of the margin, for the arrows

/// Ctrl+. folds or opens the line, Ctrl+Alt+. all of them.
bool isFoldKey(const QKeyEvent& key) {
    return key.key() == Qt::Key_Period && key.modifiers().testFlag(Qt::ControlModifier) &&
           !key.modifiers().testFlag(Qt::ShiftModifier);
}

}  // namespace

class TextView::LineNumbers : public QWidget {
public:
    explicit LineNumbers(TextView& view) : QWidget(&view), view_(view) {}

protected:
    void paintEvent(QPaintEvent* event) override { view_.paintLineNumbers(event); }
    void mousePressEvent(QMouseEvent* event) override {
        if (event->button() != Qt::LeftButton || !view_.foldAt(event->position())) event->ignore();
    }

private:
    TextView& view_;
};

TextView::TextView(Document& document, QWidget* parent)
    : QPlainTextEdit(parent),
      document_(document),
      lineNumbers_(new LineNumbers(*this)),
      find_(new FindBar(*this)),
      names_(new NamePopup(document, *this)) {
    setUndoRedoEnabled(false);  // the document's list holds these steps too
    setTabChangesFocus(true);
    setFrameShape(NoFrame);
    setLineWrapMode(NoWrap);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(font().pointSizeF());
    setFont(fixed);
    setAccessibleName(tr("Model text"));
    auto* highlighter = new Highlighter(this->document());
    highlighter->setObjectName("highlighter");
    folds_ = new AnnotationFolds(*this, *highlighter);
    connect(folds_, &AnnotationFolds::changed, this, [this] {
        viewport()->update();
        lineNumbers_->update();
    });
    connect(this, &QPlainTextEdit::updateRequest, lineNumbers_, [this] { lineNumbers_->update(); });
    connect(this, &QPlainTextEdit::blockCountChanged, this, &TextView::updateMargins);
    connect(&document, &Document::modelChanged, this, &TextView::refresh);
    typing_.setSingleShot(true);
    typing_.setInterval(250);
    connect(&typing_, &QTimer::timeout, this, &TextView::commit);
    connect(this, &QPlainTextEdit::textChanged, this, [this] {
        // colouring it anew changes the text, too, and what a hidden view holds is out of date
        if (isRefreshing_ || isStale_) return;
        typing_.start();
        updateFolds();
    });
    connect(this, &QPlainTextEdit::textChanged, find_, [this] {
        if (find_->isVisible()) find_->search();
    });
    connect(find_, &FindBar::placesChanged, this, &TextView::showMarks);
    connect(&document, &Document::messagesChanged, this, &TextView::underline);
    refresh();
    recolour();
    updateMargins();
}

/// Takes the document's text over where it differs, so that cursor and view stay where they are.
void TextView::refresh() {
    setReadOnly(!document_.isOpen());
    isStale_ = !isVisible();
    if (isStale_) return typing_.stop();  // laying out and colouring what nobody sees would be felt in large models
    const QString now = toPlainText(), wanted = document_.modelText();
    if (now == wanted) return;
    typing_.stop();
    const qsizetype shorter = std::min(now.size(), wanted.size());
    qsizetype front = 0, back = 0;
    while (front < shorter && now[front] == wanted[front]) ++front;
    while (back < shorter - front && now[now.size() - 1 - back] == wanted[wanted.size() - 1 - back]) ++back;
    isRefreshing_ = true;
    QTextCursor cursor(this->document());
    cursor.setPosition(static_cast<int>(front));
    cursor.setPosition(static_cast<int>(now.size() - back), QTextCursor::KeepAnchor);
    cursor.insertText(wanted.mid(front, wanted.size() - back - front));
    isRefreshing_ = false;
    updateFolds();
    shown_.clear();
    underline();
}

/// The characters of a place; the line where it names no column.
QTextCursor TextView::cursorAt(int line, int column, int length) const {
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (!block.isValid()) return {};
    const auto characters = [&](int bytes) {
        return static_cast<int>(QString::fromUtf8(block.text().toUtf8().left(std::max(0, bytes))).size());
    };
    QTextCursor cursor(block);
    if (column > 0) {
        const int begin = characters(column - 1);
        cursor.setPosition(block.position() + begin);
        const int end = std::min(block.length() - 1, std::max(begin + 1, characters(column - 1 + length)));
        cursor.setPosition(block.position() + end, QTextCursor::KeepAnchor);
    } else {
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    }
    return cursor;
}

/// What messages speak of in this text, with their words as the tip.
void TextView::underline() {
    faults_.clear();
    if (isStale_ || !document_.isOpen()) return;
    for (const Message& message : document_.messages()) {
        const Diagnostic& d = message.diagnostic;
        const QString file = QFileInfo(QString::fromStdString(d.place.file)).fileName();
        if (d.place.line <= 0 || file != QString::fromStdString(document_.study().modelFile)) continue;
        QTextEdit::ExtraSelection fault;
        fault.cursor = cursorAt(d.place.line, d.place.column, d.place.length);
        fault.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        fault.format.setUnderlineColor(d.severity == Severity::Error ? style::fault(palette())
                                                                     : style::caution(palette()));
        fault.format.setToolTip(inWords(d.message));
        if (!fault.cursor.isNull()) faults_.push_back(fault);
    }
    showMarks();
}

void TextView::showMarks() {
    QList<QTextEdit::ExtraSelection> marks = shown_;
    for (const QTextCursor& at : find_->places()) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = at;
        mark.format.setBackground(style::mix(palette().color(QPalette::Base), style::accent(palette()), 0.3));
        marks.push_back(mark);
    }
    setExtraSelections(marks + faults_);
}

void TextView::keyPressEvent(QKeyEvent* event) {
    if (foldBy(*event)) return event->accept();
    if (event->matches(QKeySequence::Find)) return find_->open();
    if (event->key() == Qt::Key_F3) return find_->next(event->modifiers() & Qt::ShiftModifier);
    if (event->key() == Qt::Key_Escape && find_->isVisible()) return find_->hide();
    if (names_->takes(*event)) return event->accept();
    QPlainTextEdit::keyPressEvent(event);
    names_->follow(*event);
}

void TextView::showEvent(QShowEvent* event) {
    if (isStale_) refresh();
    QPlainTextEdit::showEvent(event);
}

/// Whoever turns to something else does so with what was typed.
void TextView::focusOutEvent(QFocusEvent* event) {
    if (typing_.isActive()) commit();
    QPlainTextEdit::focusOutEvent(event);
}

void TextView::recolour() {
    for (QObject* child : this->document()->children())
        if (auto* highlighter = dynamic_cast<Highlighter*>(child)) highlighter->setPalette(palette());
}

void TextView::commit() {
    typing_.stop();
    if (document_.isOpen()) document_.typeText(toPlainText());
}

bool TextView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Find) || key->key() == Qt::Key_F3 ||
            (key->key() == Qt::Key_Escape && find_->isVisible()) || isFoldKey(*key)) {
            event->accept();
            return true;
        }
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            if (typing_.isActive()) commit();
            event->ignore();  // the window's own undo
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && names_->isOpen() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab) {  // else it leads to the next field
        keyPressEvent(static_cast<QKeyEvent*>(event));
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const int at = cursorForPosition(viewport()->mapFrom(this, help->pos())).position();
        QStringList words;
        for (const QTextEdit::ExtraSelection& fault : faults_)
            if (at >= fault.cursor.selectionStart() && at <= fault.cursor.selectionEnd())
                words << fault.format.toolTip();
        QToolTip::showText(help->globalPos(), words.join('\n'), viewport());
        return true;
    }
    return QPlainTextEdit::event(event);
}

void TextView::showPlace(int line, int column, int length) {
    QTextEdit::ExtraSelection mark;
    mark.cursor = cursorAt(line, column, length);
    if (mark.cursor.isNull()) return;
    mark.format.setBackground(style::mix(palette().color(QPalette::Base), style::caution(palette()), 0.3));
    if (column <= 0) {
        mark.cursor.setPosition(mark.cursor.selectionStart());
        mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    }
    QTextCursor begin = mark.cursor;
    begin.setPosition(mark.cursor.selectionStart());
    setTextCursor(begin);
    shown_ = {mark};
    showMarks();
    centerCursor();
}

int TextView::lineNumberWidth() const {
    const int digits = std::max(2, static_cast<int>(QString::number(blockCount()).size()));
    return fontMetrics().horizontalAdvance(QLatin1Char('9')) * digits + 5 * style::unit + foldWidth;
}

void TextView::updateMargins() { setViewportMargins(lineNumberWidth(), 0, 0, 0); }

void TextView::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    const QRect inside = contentsRect();
    lineNumbers_->setGeometry(inside.left(), inside.top(), lineNumberWidth(), inside.height());
    find_->place();
}

void TextView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        recolour();
        underline();
    }
}

void TextView::paintLineNumbers(QPaintEvent* event) {
    QPainter painter(lineNumbers_);
    painter.fillRect(event->rect(), palette().color(QPalette::Base));
    painter.setFont(font());
    painter.setPen(style::mix(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.42));
    const int width = lineNumbers_->width() - style::unit - foldWidth;
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF line = blockBoundingGeometry(block).translated(contentOffset());
        if (line.top() > event->rect().bottom()) break;
        if (!block.isVisible()) continue;
        painter.drawText(QRectF(0, line.top(), width, line.height()), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
        paintFoldMark(painter, block, line);
    }
}

/// A small arrow: to the right where something of the line is folded, downward where it could be.
void TextView::paintFoldMark(QPainter& painter, const QTextBlock& block, const QRectF& line) const {
    const AnnotationFolds::Line fold = folds_->lineAt(block);
    if (fold == AnnotationFolds::Line::Plain) return;
    constexpr double half = 3.5;  // [px]
    const QPointF centre(lineNumbers_->width() - foldWidth / 2.0, line.center().y());
    QPolygonF arrow{QVector<QPointF>{{-half, -half / 2}, {half, -half / 2}, {0, half}}};
    if (fold == AnnotationFolds::Line::Folded)
        arrow = {QVector<QPointF>{{-half / 2, -half}, {half, 0}, {-half / 2, half}}};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(arrow.translated(centre));
    painter.restore();
}

QWidget* TextView::margin() const { return lineNumbers_; }

QRect TextView::foldMark(int line) const {
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    const QRectF at = blockBoundingGeometry(block).translated(contentOffset());
    return QRectF(lineNumbers_->width() - foldWidth, at.top(), foldWidth, at.height()).toRect();
}

bool TextView::foldAt(const QPointF& inMargin) {
    if (inMargin.x() < lineNumbers_->width() - foldWidth) return false;
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF line = blockBoundingGeometry(block).translated(contentOffset());
        if (!block.isVisible() || inMargin.y() >= line.bottom()) continue;
        if (folds_->lineAt(block) == AnnotationFolds::Line::Plain) return false;
        folds_->toggle(block);
        return true;
    }
    return false;
}

/// What the caret is in is opened as it comes there, so a key can fold it, too.
bool TextView::foldBy(const QKeyEvent& key) {
    if (!isFoldKey(key)) return false;
    if (key.modifiers().testFlag(Qt::AltModifier))
        folds_->setAllFolded(folds_->folded() == 0);
    else
        folds_->toggle(textCursor().block());
    return true;
}

void TextView::updateFolds() {
    const bool wasRefreshing = std::exchange(isRefreshing_, true);  // what changes are colours alone
    folds_->update();
    isRefreshing_ = wasRefreshing;
}

/// The mark in place of what is folded, in the coordinates of the viewport.
QRectF TextView::foldRect(int position) const {
    QTextCursor at(document());
    at.setPosition(position);
    const QRectF caret = cursorRect(at);
    const double width = fontMetrics().horizontalAdvance(QLatin1Char('9')) * AnnotationFolds::markWidth;
    return QRectF(caret.left() + 1, caret.top() + 2, width - 2, caret.height() - 4);
}

void TextView::paintEvent(QPaintEvent* event) {
    QPlainTextEdit::paintEvent(event);
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ground = style::mix(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.12);
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        if (blockBoundingGeometry(block).translated(contentOffset()).top() > event->rect().bottom()) break;
        if (!block.isVisible()) continue;
        for (const int mark : folds_->marksOf(block)) {
            const QRectF rect = foldRect(mark);
            painter.setPen(Qt::NoPen);
            painter.setBrush(ground);
            painter.drawRoundedRect(rect, 3, 3);
            painter.setPen(style::mutedText(palette()));
            painter.drawText(rect, Qt::AlignCenter, QStringLiteral("…"));
        }
    }
}

void TextView::mousePressEvent(QMouseEvent* event) {
    const QTextBlock block = cursorForPosition(event->position().toPoint()).block();
    for (const int mark : folds_->marksOf(block))
        if (event->button() == Qt::LeftButton && foldRect(mark).contains(event->position())) {
            folds_->toggle(block);
            return event->accept();
        }
    QPlainTextEdit::mousePressEvent(event);
}

}  // namespace analogon::ui
