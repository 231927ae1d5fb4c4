#include "ui/inspector/parameter_panel.hpp"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QStackedLayout>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/document/unfinished.hpp"
#include "ui/inspector/knob.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/prior_text.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// Takes numbers, or a mean with its deviation, and says so at once instead of dropping what was typed; offers units;
/// draws where a value lies in its bounds.
class CellDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (index.column() != ParameterModel::Bounds) return;
        const QVariantList at = index.data(ParameterModel::BarRole).toList();
        if (at.size() != 3) return;
        const QPalette& p = option.palette;
        const bool isSelected = option.state & QStyle::State_Selected;
        const bool isAtBound = index.data(ParameterModel::AtBoundRole).toBool();
        const QColor ground = p.color(isSelected ? QPalette::Highlight : QPalette::Base);
        const QColor ink = isSelected                                          ? p.color(QPalette::HighlightedText)
                           : isAtBound                                         ? style::caution(p)
                           : index.data(ParameterModel::IsFittedRole).toBool() ? style::accent(p)
                                                                               : style::mutedText(p);
        const QRectF track = QRectF(option.rect).adjusted(2 * style::unit, 0, -2 * style::unit, 0);
        const double middle = track.center().y();
        const auto x = [&](int i) { return track.left() + at[i].toDouble() * track.width(); };
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(style::mix(ground, ink, 0.5), 2, Qt::SolidLine, Qt::RoundCap));
        painter->drawLine(QPointF(track.left(), middle), QPointF(track.right(), middle));
        painter->setPen(QPen(style::mix(ground, ink, 0.6), 5, Qt::SolidLine, Qt::FlatCap));
        // at a bound the error says nothing
        if (!isAtBound && at[2].toDouble() > at[1].toDouble())
            painter->drawLine(QPointF(x(1), middle), QPointF(x(2), middle));
        if (isAtBound) {  // a stop that the value leans on
            painter->setPen(QPen(ink, 2.5, Qt::SolidLine, Qt::FlatCap));
            painter->drawLine(QPointF(x(0), track.top() + style::unit), QPointF(x(0), track.bottom() - style::unit));
        }
        painter->setPen(Qt::NoPen);
        painter->setBrush(ink);
        const double radius = isAtBound ? 4.5 : 3.5;
        painter->drawEllipse(QPointF(x(0), middle), radius, radius);
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QSize size = QStyledItemDelegate::sizeHint(option, index);
        if (index.column() == ParameterModel::Bounds) size.setWidth(14 * style::unit);
        return size;
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor))
            box->setCurrentText(index.data().toString());
        else if (!style::isTypedInto(editor))
            QStyledItemDelegate::setEditorData(editor, index);
    }

    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor))
            model->setData(index, box->currentText(), Qt::EditRole);
        else
            QStyledItemDelegate::setModelData(editor, model, index);
    }

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override {
        if (index.column() == ParameterModel::Unit) {
            auto* box = new QComboBox(parent);
            box->addItems(index.data(ParameterModel::UnitsRole).toStringList());
            auto* self = const_cast<CellDelegate*>(this);
            QObject::connect(box, &QComboBox::activated, self, [self, box] {
                Q_EMIT self->commitData(box);
                Q_EMIT self->closeEditor(box);
            });
            return box;
        }
        auto* editor = new QLineEdit(parent);
        editor->setFrame(false);
        editor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        const bool isPrior = index.column() == ParameterModel::Prior;
        if (isPrior)
            editor->setPlaceholderText(tr("mean ± std"));
        else if (index.column() != ParameterModel::Value)
            editor->setPlaceholderText(tr("none"));
        QObject::connect(editor, &QLineEdit::textEdited, editor, [editor, isPrior](const QString& text) {
            bool isRight = text.trimmed().isEmpty();
            if (!isRight && isPrior)
                isRight = readPrior(text).has_value();
            else if (!isRight)
                isRight = style::readNumber(text).has_value();
            QPalette palette = editor->parentWidget()->palette();
            if (!isRight) palette.setColor(QPalette::Text, style::fault(palette));
            editor->setPalette(palette);
        });
        return editor;
    }
};

}  // namespace

ParameterPanel::ParameterPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new ParameterModel(document, this)),
      table_(new QTableView(this)),
      knob_(new Knob(document, this)),
      search_(new QLineEdit(this)),
      chip_(new QToolButton(this)),
      onlyFitted_(new QToolButton(this)),
      pages_(new QStackedLayout),
      empty_(new QLabel(this)),
      note_(new QLabel(this)),
      fault_(new QLabel(this)) {
    search_->setPlaceholderText(tr("Search parameters"));
    search_->setClearButtonEnabled(true);
    search_->setMinimumWidth(fontMetrics().horizontalAdvance(search_->placeholderText()) + 6 * style::unit);
    chip_->setIcon(style::icon("close"));
    chip_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    chip_->setIconSize({12, 12});
    chip_->setToolTip(tr("Show the parameters of all components"));
    chip_->hide();
    onlyFitted_->setText(tr("Fitted only"));
    onlyFitted_->setCheckable(true);
    onlyFitted_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);  // as high as the field beside it
    onlyFitted_->setToolTip(tr("Hide parameters that are not fitted"));

    table_->setModel(model_);
    table_->setItemDelegate(new CellDelegate(table_));
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setAlternatingRowColors(true);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 2 * style::unit);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(false);
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);  // what is left over
    table_->horizontalHeader()->setMinimumSectionSize(9 * style::unit);
    table_->setAccessibleName(tr("Parameters"));
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    table_->setTabKeyNavigation(false);  // Tab leads on; the arrows lead from cell to cell
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->viewport()->installEventFilter(this);

    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(style::margin);
    style::makeCaption(empty_);

    note_->setWordWrap(true);
    note_->setMargin(2 * style::unit);
    note_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard |
                                   Qt::TextSelectableByMouse);
    style::makeCaption(note_);
    note_->hide();
    fault_->setWordWrap(true);
    fault_->setContentsMargins(style::margin, 0, style::margin, style::unit);
    style::makeCaption(fault_);
    fault_->hide();

    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(style::margin, 2 * style::unit, style::margin, 2 * style::unit);
    bar->setSpacing(2 * style::unit);
    bar->addWidget(search_, 1);
    bar->addWidget(chip_);
    bar->addWidget(onlyFitted_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(fault_);
    layout->addLayout(pages_, 1);
    layout->addWidget(knob_);
    layout->addWidget(note_);
    pages_->addWidget(table_);
    pages_->addWidget(empty_);

    connect(search_, &QLineEdit::textChanged, model_, &ParameterModel::setFilter);
    style::findBy(*this, [this] { return search_; });
    connect(onlyFitted_, &QToolButton::toggled, model_, &ParameterModel::setOnlyFitted);
    connect(chip_, &QToolButton::clicked, this, [this] {
        showComponent({});
        Q_EMIT componentCleared();
    });
    connect(table_, &QWidget::customContextMenuRequested, this, &ParameterPanel::showMenu);
    connect(&document, &Document::opened, this, [this] {
        wantsPriors_ = false;
        updateState();
    });
    connect(model_, &QAbstractItemModel::modelReset, this, &ParameterPanel::updateState);
    connect(model_, &QAbstractItemModel::dataChanged, this, &ParameterPanel::updateState);
    connect(&document, &Document::messagesChanged, this, &ParameterPanel::updateFault);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ParameterPanel::updateNote);
    connect(note_, &QLabel::linkActivated, this, [this](const QString& target) {
        if (const auto mention = mentionAt(target)) Q_EMIT mentionChosen(*mention);
    });
    updateState();
}

void ParameterPanel::showComponent(const QString& component) {
    component_ = component;
    model_->setComponent(component);
    updateState();
}

/// What few parameters need is a column only where it is used, or was asked for here.
void ParameterPanel::showMenu(QPoint at) {
    const QModelIndex index = table_->indexAt(at);
    if (!index.isValid()) return;
    const QModelIndex prior = index.siblingAtColumn(ParameterModel::Prior);
    if (!(prior.flags() & Qt::ItemIsEditable)) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Give a prior …"), this, [this, prior = QPersistentModelIndex(prior)] {
        wantsPriors_ = true;
        updateState();
        table_->setCurrentIndex(prior);
        table_->scrollTo(prior);
        table_->edit(prior);
    });
    menu->popup(table_->viewport()->mapToGlobal(at));
}

/// Nothing is cut: names take what room is left, and where they have too little the table scrolls.
void ParameterPanel::fitColumns() {
    QHeaderView* header = table_->horizontalHeader();
    int figures = 0;
    for (int c = 1; c < header->count(); ++c) figures += header->sectionSize(c);
    const int names = static_cast<QAbstractItemView*>(table_)->sizeHintForColumn(0);
    const bool scrolls = table_->viewport()->width() - figures < names;
    header->setSectionResizeMode(0, scrolls ? QHeaderView::ResizeToContents : QHeaderView::Stretch);
}

bool ParameterPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) fitColumns();  // also when a scroll bar takes its room
    return QWidget::eventFilter(watched, event);
}

void ParameterPanel::pointAt(const QString& name) {
    if (model_->rowOf(name.toStdString()) < 0) {
        search_->clear();
        onlyFitted_->setChecked(false);
        showComponent({});
    }
    const int row = model_->rowOf(name.toStdString());
    if (row < 0) return;
    table_->setCurrentIndex(model_->index(row, ParameterModel::Value));
    table_->scrollTo(table_->currentIndex());
    table_->setFocus();
}

/// Description, bound and correlations of the marked parameter, without waiting for the pointer to rest on it.
void ParameterPanel::updateNote() {
    const QModelIndex current = table_->currentIndex();
    const QString html = current.isValid() ? model_->noteOn(current.row()) : QString();
    note_->setText(html);
    knob_->turn(current.isValid() ? current.data(ParameterModel::NameRole).toString().toStdString() : std::string());
    note_->setVisible(!html.isEmpty() && pages_->currentWidget() == table_);
}

/// What the declarations tell is there to be edited, whatever is wrong with the model.
void ParameterPanel::updateFault() {
    const bool isFaulty = document_.isOpen() && document_.modelError() && model_->rowCount() > 0;
    fault_->setVisible(isFaulty);
    if (!isFaulty) return;
    fault_->setText(isUnfinished(*document_.modelError())
                        ? tr("Not connected yet: shown is what the declarations tell.")
                    : document_.definition()
                        ? tr("The model has an error (see the messages): shown is what its declarations tell.")
                        : tr("The text of the model cannot be read (see the messages): shown is what it told last."));
}

void ParameterPanel::updateState() {
    updateFault();
    chip_->setText(component_);
    chip_->setVisible(model_->isOfComponent());
    table_->setColumnHidden(ParameterModel::Prior, !wantsPriors_ && !model_->hasPriors());
    if (model_->rowCount() > 0) {
        fitColumns();
        pages_->setCurrentWidget(table_);
        return updateNote();
    }
    note_->hide();
    if (!document_.isOpen())
        empty_->setText(tr("The parameters of the open study appear here."));
    else if (document_.definition() && document_.diagram().blocks.empty())
        empty_->setText(tr("Place a block: its parameters appear here."));
    else if (document_.modelError())
        empty_->setText(tr("The model has an error: the messages say where."));
    else if (!search_->text().isEmpty() || onlyFitted_->isChecked())
        empty_->setText(tr("No parameter matches. Clear the search or the filter."));
    else
        empty_->setText(tr("No block of this model has parameters."));
    pages_->setCurrentWidget(empty_);
}

}  // namespace analogon::ui
